"""Worlds without physics where blocks lie close and touch, as people pour them out, in heaps and bunches."""

from __future__ import annotations

import math

import numpy as np

from grounding.corpus.composer import COLORS, Composition
from grounding.corpus.sight import separation
from grounding.corpus.tabletop import TABLE, TABLE_TOP, WHOLE_X, WHOLE_Y
from grounding.world import Array, World, make_object

EDGE = 0.05  # [m]
_APART = 0.001  # between what touches [m]
_TRIES = 30


def compose_clutter(rng: np.random.Generator) -> Composition:
    """Lay a cluttered world: nobody laid a row or a ring in it on purpose.

    Args:
        rng: the only source of chance.
    """
    count = int(rng.integers(8, 22))
    bunches = int(rng.integers(1, 4))
    poses: list[tuple[float, float, float]] = []
    boxes: list[tuple[Array, Array]] = []
    while len(poses) < count:
        fresh = len(poses) < bunches or rng.random() < 0.2
        pose = _anywhere(rng, bunches) if fresh else _beside(rng, poses[int(rng.integers(len(poses)))])
        box = _box(*pose)
        inside = WHOLE_X[0] <= pose[0] <= WHOLE_X[1] and WHOLE_Y[0] <= pose[1] <= WHOLE_Y[1]
        if inside and all(separation(box[0], other[0], box[1], other[1]) >= _APART for other in boxes):
            poses.append(pose)
            boxes.append(box)
    palette = [COLORS[int(i)] for i in rng.permutation(len(COLORS))[: int(rng.integers(2, 6))]]
    blocks = []
    for number, (x, y, turn) in enumerate(poses, start=1):
        place = (round(x, 4), round(y, 4), TABLE_TOP + EDGE / 2)
        turned = (math.cos(turn / 2), 0.0, 0.0, math.sin(turn / 2))
        color = palette[int(rng.integers(len(palette)))]
        blocks.append(make_object(f"b{number}", "block", color, place, turned, (EDGE,) * 3))
    return Composition(World((*blocks, TABLE)), ())


def _anywhere(rng: np.random.Generator, bunches: int) -> tuple[float, float, float]:
    reach = 0.5 if bunches == 1 else 0.9
    x, y = rng.uniform(0.45, 0.85), rng.uniform(WHOLE_Y[0], WHOLE_Y[1]) * reach
    return float(x), float(y), float(rng.uniform(-math.pi / 4, math.pi / 4))


def _beside(rng: np.random.Generator, other: tuple[float, float, float]) -> tuple[float, float, float]:
    """A pose next to another block: in contact with its side, or loosely beside it."""
    x, y, turn = other
    if rng.random() < 0.55:
        side = turn + float(rng.integers(4)) * math.pi / 2
        away, aside = EDGE + _APART + float(rng.exponential(0.001)), float(rng.uniform(-0.6, 0.6)) * EDGE
        return (x + away * math.cos(side) - aside * math.sin(side), y + away * math.sin(side) + aside * math.cos(side),
                turn)  # fmt: skip
    side = float(rng.uniform(-math.pi, math.pi))
    away = EDGE * float(rng.uniform(1.1, 3.0))
    return (
        x + away * math.cos(side),
        y + away * math.sin(side),
        float(rng.uniform(-math.pi / 4, math.pi / 4)),
    )


def _box(x: float, y: float, turn: float) -> tuple[Array, Array]:
    """Corners and axes of a block's base."""
    axes = np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
    signs = np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]]) / 2
    return np.array([x, y]) + EDGE * signs @ axes, axes
