"""Worlds as people lay them by hand: a few blocks in a loose row or column, gaps uneven, some others about."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from grounding.corpus.composer import COLORS, Composition
from grounding.corpus.tabletop import TABLE, TABLE_TOP
from grounding.symbols import Container
from grounding.world import Array, World, WorldObject, make_object

EDGE = 0.05  # [m]
_X, _Y = (0.4, 0.95), (-0.8, 0.8)
_HANDS = ((0.45, 0.9, 1.2), (0.45, -0.9, 1.2))


def compose_loosely(rng: np.random.Generator) -> Composition:
    """Lay a random world by hand, so to speak.

    Args:
        rng: the only source of chance.
    """
    while True:
        kind = ("row", "column")[int(rng.integers(2))]
        count = int(rng.integers(3, 8 if kind == "row" else 6))
        places = _line(rng, kind, count)
        if places is not None:
            break
    laid = len(places)
    for _ in range(int(rng.integers(0, 6)) if rng.random() < 0.7 else 0):
        place = _apart(rng, places[:laid], places)
        if place is not None:
            places = np.vstack([places, place])
    order = rng.permutation(len(places))
    colors = _colors(rng, len(places))
    names = [f"b{number + 1}" for number in order.tolist()]
    blocks = [_block(rng, name, color, place) for name, color, place in zip(names, colors, places, strict=True)]
    container = Container(kind, tuple(names[:laid]))
    return Composition(World((*sorted(blocks, key=lambda o: int(o.id[1:])), TABLE)), (container,))


def with_hands(world: World) -> World:
    """The world with the robot's hands in it, as recorded worlds have them."""
    hands = [
        make_object(name, "robot", "unknown", place, size=(0.1, 0.1, 0.1))
        for name, place in zip(("left_hand", "right_hand"), _HANDS, strict=True)
    ]
    return World((*world.objects, *hands), world.speaker)


def colourless(world: World) -> World:
    """The world with nobody knowing the colours of its blocks."""
    return world.with_objects(replace(o, color="unknown") if o.type == "block" else o for o in world.objects)


def _line(rng: np.random.Generator, kind: str, count: int) -> Array | None:
    gap = float(rng.uniform(1.5, 4.5)) * EDGE
    steps = gap * rng.uniform(0.65, 1.35, size=count - 1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    across = np.clip(rng.normal(0.0, rng.uniform(0.0, 0.22) * gap, size=count), -0.4 * gap, 0.4 * gap)
    low, high = _Y if kind == "row" else _X
    if along[-1] > high - low:
        return None
    start = float(rng.uniform(low, high - along[-1]))
    other = _X if kind == "row" else _Y
    level = float(rng.uniform(other[0] + 0.05, other[1] - 0.05))
    points = np.stack([start + along, level + across], axis=1)
    return points[:, ::-1].copy() if kind == "row" else points


def _apart(rng: np.random.Generator, line: Array, places: Array) -> Array | None:
    """A place away from the others, and not on the line or where it would go on."""
    centre = line.mean(axis=0)
    axis = np.linalg.svd(line - centre, full_matrices=False)[2][0]
    reach = np.abs((line - centre) @ axis).max()
    gap = 2 * reach / (len(line) - 1)
    for _ in range(40):
        place = np.array([rng.uniform(*_X), rng.uniform(*_Y)])
        offset = place - centre
        along, across = abs(offset @ axis), float(np.linalg.norm(offset - (offset @ axis) * axis))
        if np.linalg.norm(places - place, axis=1).min() < max(2 * EDGE, 0.9 * gap):
            continue
        if across > gap or along > reach + 2.5 * gap:
            return place
    return None


def _colors(rng: np.random.Generator, count: int) -> list[str]:
    palette = [COLORS[int(i)] for i in rng.permutation(len(COLORS))[: int(rng.choice((1, 1, 2, 3, 5)))]]
    return [palette[int(rng.integers(len(palette)))] for _ in range(count)]


def _block(rng: np.random.Generator, name: str, color: str, place: Array) -> WorldObject:
    turn = float(rng.uniform(-0.5, 0.5))
    position = (round(float(place[0]), 4), round(float(place[1]), 4), TABLE_TOP + EDGE / 2)
    return make_object(name, "block", color, position, (np.cos(turn / 2), 0.0, 0.0, np.sin(turn / 2)), (EDGE,) * 3)
