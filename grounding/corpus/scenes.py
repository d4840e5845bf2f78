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


def lines_of_three(places: Array, reach: float = 0.21, deviation: float = 0.03, lean: float = 0.5) -> np.ndarray:
    """Triples that a person might call a row or a column.

    Args:
        places: (n, 2) centres in [m].
        reach: longest distance between neighbours in [m].
        deviation: longest distance of the middle one from the line through the others in [m].
        lean: largest angle between that line and the nearest of the axes in [rad].

    Returns:
        (m, 3) indices, ascending in each triple.
    """
    triples = np.array(list(combinations(range(len(places)), 3)), dtype=int).reshape(-1, 3)
    a, b, c = (places[triples[:, k]] for k in range(3))
    sides = np.stack([c - b, c - a, b - a], axis=1)  # each opposite to one of the three
    lengths = np.linalg.norm(sides, axis=2)
    longest = lengths.argmax(axis=1)
    ends = sides[np.arange(len(triples)), longest]
    area = np.abs(sides[:, 2, 0] * sides[:, 1, 1] - sides[:, 2, 1] * sides[:, 1, 0])
    off = area / np.maximum(lengths.max(axis=1, initial=0.0), 1e-9)
    angle = np.arctan2(np.abs(ends).min(axis=1, initial=np.inf), np.abs(ends).max(axis=1, initial=0.0))
    return triples[(np.sort(lengths, axis=1)[:, 1] <= reach) & (off <= deviation) & (angle <= lean)]


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
            if not (lines_of_three(places) == len(places) - 1).any():
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
    "default": (18, _default),
    "four": (2, _four),
    "seven": (3, _seven),
    "twelve": (4, _twelve),
    "tower": (5, _tower),
    "groups": (6, _groups),
    "two_rows": (7, _two_rows),
    "scattered": (22, _scattered),
    "twenty_mixed": (11, _twenty_mixed),
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
