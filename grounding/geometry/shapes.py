"""How well sets of objects form rows, columns, groups, circles and towers (Section IV-C), for many sets at once.

Every measure is free of scale: lengths are divided by the mean gap of neighbours or by the typical edge. A line's model
is the principal axis through the mean, a circle's the algebraic fit (Kasa, 1976), a tower's the vertical through the
mean, a group's a disc about it.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from grounding.geometry.subsets import LEAST, ON_MODEL, Subsets, between_all
from grounding.world import Array

__all__ = ["FAR", "IN_THE_WAY", "MEASURES", "ON_MODEL", "Subsets", "between_all", "measure"]

MEASURES = ("likelihood", "fit", "coherence", "separation", "ordering", "orientation", "distinction")
"""In the order of the columns of `measure`:

likelihood: share of the members that lie on the model, within a tolerance.
fit: root mean square distance of the members from the model; 0 is exact.
coherence: 1 for even gaps, towards 0 for uneven ones.
separation: distance to the nearest other object over the largest gap within.
ordering: share of members among all that stands where the shape is; 1 if nothing comes in between.
orientation: angle of the principal axis to the kind's own, over a right angle; for circles and groups the elongation.
distinction: distance of the nearest other object from the model: the model is the more a thing of its own the larger.
"""

IN_THE_WAY = 0.75  # others at most so far from the model stand where the shape is [edges]
FAR = 10.0  # what has no bound ends here: there is nothing else, or nothing to compare with


def measure(kind: str, subsets: Subsets) -> Array:
    """How well sets form a shape.

    Args:
        kind: row, column, group, circle or tower.
        subsets: the sets.

    Returns:
        the measures in the order of `MEASURES`, shape (m, 7), finite, at most `FAR`.
    """
    columns = _SHAPES[kind](subsets)
    return np.clip(np.nan_to_num(np.stack(columns, axis=1), nan=FAR, posinf=FAR), 0.0, FAR)


def _over(values: Array, scale: Array) -> Array:
    return np.asarray(values / np.maximum(scale, LEAST))


def _line(s: Subsets, axis: float) -> list[Array]:
    cosine, sine = np.cos(s.angle)[:, None], np.sin(s.angle)[:, None]
    along, across = s.dx * cosine + s.dy * sine, np.abs(s.dy * cosine - s.dx * sine)
    mean, deviation, largest = s.gaps(along)
    gap = np.maximum(mean, s.edge / 2)
    reach = s.largest_inside(np.abs(along))
    low, high = -s.largest_inside(-along), s.largest_inside(along)
    beyond = np.maximum(0.0, np.maximum(low[:, None] - along, along - high[:, None]) - gap[:, None])
    between = (np.abs(along) < reach[:, None]) & (along > low[:, None]) & (along < high[:, None])
    turned = np.abs(s.angle - axis) % np.pi
    return [
        s.share(across),
        _over(np.sqrt(s.mean(across**2)), gap),
        np.maximum(0.0, 1 - _over(deviation, mean)),
        _over(s.outside, largest),
        s.among(between & (across <= IN_THE_WAY * s.edge)),
        np.where(s.spread[0] > LEAST, np.minimum(turned, np.pi - turned) / (np.pi / 2), 1.0),  # a point has no axis
        _over(s.least_outside(np.hypot(across, beyond)), gap),
    ]


def _row(s: Subsets) -> list[Array]:
    return _line(s, np.pi / 2)


def _column(s: Subsets) -> list[Array]:
    return _line(s, 0.0)


def _circle(s: Subsets) -> list[Array]:
    xx, xy, yy = s.moments
    square = s.dx**2 + s.dy**2
    right_x, right_y = s.mean(s.dx * square) / 2, s.mean(s.dy * square) / 2
    determinant = xx * yy - xy**2
    flat = (determinant <= 1e-6 * (xx + yy) ** 2) | (s.count < 3)  # no circle goes through what is in line
    determinant = np.where(flat, 1.0, determinant)
    x, y = (right_x * yy - right_y * xy) / determinant, (right_y * xx - right_x * xy) / determinant
    x, y = np.where(flat, 0.0, x)[:, None], np.where(flat, 0.0, y)[:, None]
    away = np.hypot(s.dx - x, s.dy - y)
    radius = np.sqrt(s.mean(away**2))
    off = np.abs(away - radius[:, None])
    chord = np.maximum(2 * np.pi * radius / s.count, s.edge / 2)
    turn = np.arctan2(s.dy - y, s.dx - x)
    mean, deviation, _ = s.gaps(turn)
    last = 2 * np.pi - mean * (s.count - 1)
    even = 2 * np.pi / s.count
    variance = ((deviation**2 + mean**2) * (s.count - 1) + last**2) / s.count - even**2
    worst = np.where(flat, FAR, 0.0)
    return [
        np.where(flat, 0.0, s.share(off)),
        worst + _over(np.sqrt(s.mean(off**2)), chord),
        np.where(flat, 0.0, np.maximum(0.0, 1 - np.sqrt(np.maximum(variance, 0.0)) / even)),
        _over(s.outside, s.chords[1]),
        s.among(away <= (radius + ON_MODEL * s.edge)[:, None]),
        s.elongation,
        _over(s.least_outside(off), chord),
    ]


def _tower(s: Subsets) -> list[Array]:
    away = np.hypot(s.dx, s.dy)
    mean, deviation, _ = s.gaps(s.dz)
    edge = np.full(len(s.count), s.edge)
    upright = np.sqrt(s.mean(s.dz**2))
    return [
        s.share(away),
        np.sqrt(s.mean(away**2)) / s.edge,
        np.where(mean > s.edge / 4, np.maximum(0.0, 1 - _over(deviation, mean)), 0.0),
        _over(s.outside, s.linkage),
        s.among(away <= IN_THE_WAY * s.edge),
        np.arctan2(s.spread[0], upright) / (np.pi / 2),
        _over(s.least_outside(away), edge),
    ]


def _group(s: Subsets) -> list[Array]:
    away = np.hypot(s.dx, s.dy)
    within, beyond = s.neighbours
    gap = np.maximum(s.chords[0], s.edge / 2)
    reach = s.largest_inside(away)
    finite = np.where(np.isfinite(within), within, 0.0)
    deviation = np.sqrt(np.maximum(s.mean(finite**2) - s.chords[0] ** 2, 0.0))
    return [
        s.mean(np.where(within < beyond, 1.0, 0.0)),
        _over(np.sqrt(s.mean(away**2)), gap * np.sqrt(s.count)),
        np.maximum(0.0, 1 - deviation / gap),
        _over(s.outside, s.linkage),
        s.among(away < reach[:, None]),
        s.elongation,
        _over(s.least_outside(away), reach),
    ]


_SHAPES: dict[str, Callable[[Subsets], list[Array]]] = {
    "row": _row,
    "column": _column,
    "group": _group,
    "circle": _circle,
    "tower": _tower,
}
