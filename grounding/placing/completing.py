"""Arrangements that are to come about: where one more block makes a row, a column, a diagonal, or closes a square."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.degrees import gaussian
from grounding.meaning.nouns import Noun
from grounding.placing.floor_plan import PITCH, FloorPlan
from grounding.world import Array

FAR = 4.0  # members of a line lie no farther apart [edges]
STRAIGHT = 0.3  # how much they may be off [edges]
WIDTH = 0.3  # how exact the place is [edges]
FADING = 2.0  # neighbours that are farther apart look less like a line [edges]
_MOST = 24


def completing(noun: Noun, source: int, plan: FloorPlan) -> tuple[Array, Array]:
    """Find where a block completes an arrangement.

    Args:
        noun: what comes about: "a row of three", "a diagonal", "a square".
        source: index of what is moved.
        plan: the floor plan.

    Returns:
        points in edges, shape (m, 2), and how well each does it, shape (m,), in [0, 1].
    """
    others = np.array([i for i in range(len(plan.points)) if i != source], dtype=int)
    standing = np.unique(np.round(plan.points[others], 3), axis=0)
    if len(standing) < 2:
        return np.zeros((0, 2)), np.zeros(0)
    if not set(noun.kinds) & {"row", "column", "diagonal"}:
        return _corners(standing)
    first, second = np.nonzero(~np.eye(len(standing), dtype=bool))
    step = standing[first] - standing[second]
    size = np.abs(step)
    length = size.max(axis=1)
    fits = np.zeros(len(step), dtype=bool)
    if "row" in noun.kinds:
        fits |= size[:, 1] < STRAIGHT
    if "column" in noun.kinds:
        fits |= size[:, 0] < STRAIGHT
    if "diagonal" in noun.kinds:
        fits |= (size.min(axis=1) > 2 * STRAIGHT) & (np.ptp(size, axis=1) < length / 2)
    beyond = np.flatnonzero(fits & (length < FAR))
    amid = np.flatnonzero(fits & (length > 1.9 * PITCH) & (length < 2 * FAR) & (first < second))
    points = np.concatenate([standing[first[beyond]] + step[beyond], standing[second[amid]] + step[amid] / 2])
    worth = np.exp(-np.maximum(np.concatenate([length[beyond], length[amid] / 2]) - PITCH, 0.0) / FADING)
    best = np.argsort(-worth, kind="stable")[:_MOST]
    return points[best], worth[best]


def _corners(standing: Array) -> tuple[Array, Array]:
    """Fourth corners of squares."""
    found = []
    for corner in standing:
        off = standing - corner
        sides = off[(np.abs(off).max(axis=1) < 1.5) & (np.abs(off).max(axis=1) > 0.5)]
        along = sides[np.abs(sides[:, 1]) < STRAIGHT]
        across = sides[np.abs(sides[:, 0]) < STRAIGHT]
        found += [corner + a + b for a in along for b in across]
    points = np.array(found[:_MOST]).reshape(-1, 2)
    return points, np.ones(len(points))


def shape_map(points: Array, targets: Array, worth: Array) -> Array:
    """Measure how well points (p, 2) complete an arrangement, by `completing`."""
    if not len(targets):
        return np.ones(len(points))
    square = ((points[:, None] - targets[None]) ** 2).sum(axis=2)
    return np.asarray((gaussian(np.sqrt(square), WIDTH) * worth).max(axis=1))
