"""The scenes that ship in `models/scenes`, laid from fixed plans with a seeded hand; `write` makes the files anew."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from pathlib import Path

import numpy as np

from grounding.corpus.tabletop import Looks, Tabletop, heap, line, ring
from grounding.errors import CorpusError
from grounding.world import Array, World, save_world

ROW, COLUMN = np.pi / 2, 0.0
_PITCH = 0.078  # from centre to centre of 5 cm cubes in a line, in [m]: room for a finger between them
_LOOSE = Looks(jitter=0.0, yaw=0.35)


def _at(x: float, y: float, offsets: Array) -> Array:
    return np.array([x, y]) + offsets


def lines_of_three(places: Array, reach: float = 0.21, deviation: float = 0.03, lean: float = 0.5) -> list[list[int]]:
    """Triples that a person might call a row or a column.

    Args:
        places: (n, 2) centres in [m].
        reach: longest distance between neighbours in [m].
        deviation: longest distance of the middle one from the line through the others in [m].
        lean: largest angle between that line and the nearest of the axes in [rad].
    """
    found = []
    for triple in combinations(range(len(places)), 3):
        points = places[list(triple)]
        apart = [np.linalg.norm(points[j] - points[i]) for i, j in ((0, 1), (0, 2), (1, 2))]
        ends = ((0, 1), (0, 2), (1, 2))[int(np.argmax(apart))]
        middle = points[3 - sum(ends)]
        along = (points[ends[1]] - points[ends[0]]) / max(apart)
        off = abs(along[0] * (middle - points[ends[0]])[1] - along[1] * (middle - points[ends[0]])[0])
        angle = np.arctan2(min(abs(along)), max(abs(along)))
        if sorted(apart)[1] <= reach and off <= deviation and angle <= lean:
            found.append(list(triple))
    return found


def _scatter(table: Tabletop, count: int, colors: tuple[str, ...], apart: float) -> None:
    """Add loose blocks, none nearer than `apart` metres to another and none in line with two others."""
    settled = table.gap
    table.gap = apart
    for number in range(count):
        for _ in range(4000):
            place = table.room(np.zeros((1, 2)), 0.05)
            if place is None:
                continue
            places = np.array([block.position[:2] for block in table.blocks] + [place])
            if not any(len(places) - 1 in triple for triple in lines_of_three(places)):
                break
        else:
            raise CorpusError(f"no place for loose block {number + 1} of {count}")
        looks = Looks((colors[number % len(colors)],), jitter=0.0, yaw=_LOOSE.yaw)
        table.lay(None, place[None], looks)
    table.gap = settled


def _default(table: Tabletop) -> None:
    table.lay("row", _at(0.575, -0.40, line(5, _PITCH, ROW)), Looks())
    table.lay("column", _at(0.605, 0.36, line(3, _PITCH, COLUMN)), Looks())
    _scatter(table, 12, ("red",), 0.05)


def _four(table: Tabletop) -> None:
    places = np.array([[0.52, 0.27], [0.70, 0.12], [0.57, -0.14], [0.68, -0.33]])
    table.lay(None, places, Looks(("red", "blue", "blue", "red"), yaw=0.3))


def _seven(table: Tabletop) -> None:
    table.lay("row", _at(0.57, -0.28, line(4, 0.082, ROW)), Looks(("red", "red", "red", "red")))
    places = np.array([[0.54, 0.42], [0.69, 0.20], [0.73, -0.07]])
    table.lay(None, places, Looks(("blue", "red", "blue"), yaw=0.3))


def _twelve(table: Tabletop) -> None:
    table.lay("circle", _at(0.62, -0.31, ring(6, 0.12, 0.26)), Looks(yaw=0.2))
    table.lay("column", _at(0.62, 0.38, line(4, 0.08, COLUMN)), Looks(("blue",)))
    table.lay(None, np.array([[0.73, 0.07], [0.51, 0.13]]), Looks(("green", "green"), yaw=0.3))


def _tower(table: Tabletop) -> None:
    neat = Looks(("blue", "red", "yellow"), jitter=0.001)
    table.stack(np.array([0.58, 0.33]), 3, neat)
    table.stack(np.array([0.67, -0.36]), 2, Looks(("green", "red"), edge=0.045, jitter=0.001), (0.05, 0.045))
    places = np.array([[0.53, -0.19], [0.72, 0.05], [0.51, 0.10], [0.70, 0.52]])
    table.lay(None, places, Looks(("red", "yellow", "green", "blue"), yaw=0.3))


def _groups(table: Tabletop) -> None:
    group = heap(5, 0.09, table.rng)
    table.lay("group", _at(0.62, 0.34, group), Looks(yaw=0.12))
    table.lay("row", _at(0.60, -0.33, line(3, 0.08, ROW)), Looks(("blue",)))


def _two_rows(table: Tabletop) -> None:
    table.lay("row", _at(0.51, 0.11, line(5, _PITCH, ROW)), Looks())
    table.lay("row", _at(0.71, -0.12, line(5, _PITCH, ROW)), Looks())


def _scattered(table: Tabletop) -> None:
    _scatter(table, 15, ("red", "blue", "green", "yellow", "purple"), 0.045)


def _twenty_mixed(table: Tabletop) -> None:
    table.stack(np.array([0.55, 0.52]), 3, Looks(("green", "blue", "red"), jitter=0.001))
    table.stack(np.array([0.71, 0.02]), 2, Looks(("yellow", "red"), jitter=0.001))
    table.lay("row", _at(0.54, -0.31, line(5, _PITCH, ROW)), Looks(("blue",)))
    table.lay("column", _at(0.63, 0.25, line(3, 0.08, COLUMN)), Looks(("red", "yellow", "red")))
    table.lay(None, np.array([[0.70, -0.55]]), Looks(("orange",), edge=0.04, yaw=0.2))
    _scatter(table, 6, ("green", "yellow", "red"), 0.045)


PLANS: dict[str, tuple[int, Callable[[Tabletop], None]]] = {
    "default": (11, _default),
    "four": (2, _four),
    "seven": (3, _seven),
    "twelve": (4, _twelve),
    "tower": (5, _tower),
    "groups": (6, _groups),
    "two_rows": (7, _two_rows),
    "scattered": (8, _scattered),
    "twenty_mixed": (9, _twenty_mixed),
}


def lay(name: str) -> tuple[World, Tabletop]:
    """Lay one of the scenes; the tabletop knows which arrangements are in it."""
    seed, plan = PLANS[name]
    table = Tabletop(np.random.default_rng(seed))
    plan(table)
    return table.world(), table


def write(folder: Path) -> None:
    """Write all scenes to a folder, one file a scene."""
    for name in PLANS:
        save_world(lay(name)[0], folder / f"{name}.json")


if __name__ == "__main__":
    from models import SCENES

    write(SCENES)
