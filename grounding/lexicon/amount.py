"""Amounts: so many blocks away in a direction, by blocks that lie there or by their lengths."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.lexicon.degrees import gaussian, logistic, ranked
from grounding.lexicon.parameters import value
from grounding.world import Array

Start = tuple[Array, float]
"""A point from which is measured, with how likely it is meant."""
_TO_MIDDLE, _BETWEEN = 0.8, 1.0  # measured to the middle of what lies there, or to what lies in between


def measured(
    xy: Array, edge: float, starts: Sequence[Start], way: Array, steps: float, *, counting: bool = False
) -> Array:
    """How well points lie so many blocks away in a direction, shape (m,).

    Args:
        xy: shape (m, 2) in [m].
        edge: of a block [m].
        starts: from where.
        way: the direction for each step, shape (2,).
        steps: how many blocks.
        counting: whether blocks are counted and not lengths: "two blocks behind" is mostly the second one there.
    """
    total, counted = np.zeros(len(xy)), np.zeros(len(xy))
    share = value("amount.counted") if counting and steps >= 1 and steps == int(steps) else 0.0
    length = float(np.linalg.norm(way))
    for start, chance in starts:
        for count, likely in ((steps, _TO_MIDDLE), (steps + 1, _BETWEEN)):
            total = np.maximum(total, chance * likely * _near(xy, start + way * count * _pitch(edge), edge, steps))
        if share and length > 1e-6:
            lane = along_lane(xy, start, way / length, edge)
            key = -(xy - start) @ way / length
            counted = counted + chance * (1 - counted) * ranked(lane, key, int(steps), value("rank.blur") * edge)
    return np.asarray((1 - share) * total + share * counted)


def stepped(xy: Array, edge: float, starts: Sequence[Start], ways: Sequence[tuple[Array, float]]) -> Array:
    """How well points lie so many blocks away along every one of several directions, shape (m,).

    Args:
        xy: shape (m, 2) in [m].
        edge: of a block [m].
        starts: from where.
        ways: directions (2,) with how many blocks in each.
    """
    total = np.zeros(len(xy))
    most = max(count for _, count in ways)
    for start, chance in starts:
        for further, likely in ((0, _TO_MIDDLE), (1, _BETWEEN)):
            target = start + _pitch(edge) * np.sum([(count + further) * way for way, count in ways], axis=0)
            total = np.maximum(total, chance * likely * _near(xy, target, edge, most))
    return total


def in_blocks(length: float, edge: float) -> float:
    """A length [m] in blocks that lie side by side, each with an edge [m]."""
    return length / _pitch(edge)


def along_lane(xy: Array, start: Array, way: Array, edge: float) -> Array:
    """How well points lie in a narrow lane that begins somewhere, shape (m,)."""
    ahead, side = (xy - start) @ way, np.abs((xy - start) @ np.array([-way[1], way[0]]))
    beyond = logistic((ahead / edge - value("direction.ahead")) / value("direction.ahead_blur"))
    return np.asarray(beyond * gaussian(side, value("amount.lane") * edge))


def _pitch(edge: float) -> float:
    return value("amount.pitch") * edge


def _near(xy: Array, target: Array, edge: float, steps: float) -> Array:
    away = np.linalg.norm(xy - target, axis=1) / edge
    return gaussian(away, value("amount.blur") + value("amount.blur_growth") * steps)
