"""How well sets of objects form rows, columns, groups, circles and towers (Section IV-C), for many sets at once.

Every measure is free of scale: lengths are divided by the mean gap of neighbours or by the typical edge. A line's model
is the principal axis through the mean, a circle's the algebraic fit (Kasa, 1976), a tower's the vertical through the
mean, a group's a disc about it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from grounding.world import Array

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

ON_MODEL = 0.4  # tolerance of members [edges]
IN_THE_WAY = 0.75  # others at most so far from the model stand where the shape is [edges]
FAR = 10.0  # what has no bound ends here: there is nothing else, or nothing to compare with
_LEAST = 1e-9
_LAST = 1e6  # sorts behind everything
_CELLS = 1 << 20  # of an array at a time


class Subsets:
    """Sets of objects, and what the measures of several kinds need of them.

    Args:
        positions: centres of all objects, shape (n, 3) in [m].
        edge: typical edge in [m].
        members: which objects are in which set, shape (m, n), booleans; every set has one member at least.
        distances: between all objects, shape (n, n) in [m]; computed if not given.
    """

    def __init__(self, positions: Array, edge: float, members: np.ndarray, distances: Array | None = None) -> None:
        self.edge = edge
        self.distances = between_all(positions) if distances is None else distances
        self.inside = members
        self.weight = members.astype(np.float64)
        self.count = self.weight.sum(axis=1)
        self.positions = positions
        self.centre = self.weight @ positions / self.count[:, None]
        self.dx, self.dy, self.dz = (positions[None, :, i] - self.centre[:, i, None] for i in range(3))

    def mean(self, values: Array) -> Array:
        """Means over the members of what has shape (m, n)."""
        return np.asarray(np.einsum("mn,mn->m", values, self.weight) / self.count)

    def share(self, off: Array) -> Array:
        """Share of the members that are on the model, by their distances from it."""
        return self.mean(np.where(off <= ON_MODEL * self.edge, 1.0, 0.0))

    def least_outside(self, values: Array) -> Array:
        """The smallest of the values, shape (m, n), over what is no member; infinite where all are members."""
        return np.asarray(np.where(self.inside, np.inf, values).min(axis=1, initial=np.inf))

    def largest_inside(self, values: Array) -> Array:
        """The largest over the members."""
        return np.asarray(np.where(self.inside, values, -np.inf).max(axis=1))

    def among(self, reached: np.ndarray) -> Array:
        """Share of members among themselves and the others that are reached, shape (m, n)."""
        return np.asarray(self.count / (self.count + (reached & ~self.inside).sum(axis=1)))

    def gaps(self, values: Array) -> tuple[Array, Array, Array]:
        """Mean, standard deviation and largest of the gaps between the members' values when these are sorted."""
        ordered = np.sort(np.where(self.inside, values, _LAST), axis=1)
        steps = np.diff(ordered, axis=1)
        there = np.arange(1, self.inside.shape[1])[None] < self.count[:, None]
        steps = np.where(there, steps, 0.0) if steps.size else np.zeros((len(values), 1))
        number = np.maximum(self.count - 1, 1)
        mean = steps.sum(axis=1) / number
        square = (steps**2).sum(axis=1) / number - mean**2
        return mean, np.sqrt(np.maximum(square, 0.0)), steps.max(axis=1)

    @cached_property
    def moments(self) -> tuple[Array, Array, Array]:
        """Second moments xx, xy, yy about the mean, on the floor."""
        return self.mean(self.dx**2), self.mean(self.dx * self.dy), self.mean(self.dy**2)

    @cached_property
    def spread(self) -> tuple[Array, Array]:
        """Standard deviations along the first and the second principal axis, on the floor."""
        xx, xy, yy = self.moments
        half, root = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
        return np.sqrt(half + root), np.sqrt(np.maximum(half - root, 0.0))

    @cached_property
    def angle(self) -> Array:
        """Of the first principal axis to x, in [rad], -pi/2 to pi/2."""
        xx, xy, yy = self.moments
        return np.asarray(np.arctan2(2 * xy, xx - yy) / 2)

    @cached_property
    def elongation(self) -> Array:
        """0 for what is as wide as long, 1 for a line."""
        first, second = self.spread
        return 1 - second / np.maximum(first, _LEAST)

    @cached_property
    def neighbours(self) -> tuple[Array, Array]:
        """Distance of every object to the nearest other that is a member, and of members to the nearest that is none.

        Both have shape (m, n); infinite where there is none, the second also for objects that are no members.
        """
        rows, objects = np.nonzero(self.inside)
        starts = np.flatnonzero(np.diff(rows, prepend=-1))
        apart = self.distances + np.diag(np.full(len(self.distances), np.inf))
        within, beyond = np.full(self.inside.shape, np.inf), np.full(self.inside.shape, np.inf)
        step = max(1, _CELLS // max(len(apart), 1) ** 2)
        for start in range(0, len(self.inside), step):
            sets = slice(start, start + step)
            first = starts[start]
            pairs = slice(first, starts[start + step] if start + step < len(starts) else len(rows))
            reach = apart[objects[pairs]]
            within[sets] = np.minimum.reduceat(reach, starts[sets] - first, axis=0)
            reach[self.inside[rows[pairs]]] = np.inf
            beyond[rows[pairs], objects[pairs]] = reach.min(axis=1)
        return within, beyond

    @cached_property
    def outside(self) -> Array:
        """Distance from the members to the nearest other object; infinite where there is none."""
        return np.asarray(np.where(self.inside, self.neighbours[1], np.inf).min(axis=1))

    @cached_property
    def chords(self) -> tuple[Array, Array]:
        """Mean and largest distance of members to the nearest other member."""
        within = np.where(np.isfinite(self.neighbours[0]), self.neighbours[0], 0.0)
        return self.mean(within), within.max(axis=1)

    @cached_property
    def linkage(self) -> Array:
        """The largest gap that has to be crossed to get from any member to any other (Prim's trees, side by side)."""
        rows = np.arange(len(self.inside))
        first = self.inside.argmax(axis=1)
        left = self.inside.copy()
        left[rows, first] = False
        best = self.distances[first].copy()
        largest = np.zeros(len(rows))
        for _ in range(int(self.count.max(initial=1)) - 1):
            reach = np.where(left, best, np.inf)
            nearest = reach.argmin(axis=1)
            gap = reach[rows, nearest]
            largest = np.maximum(largest, np.where(np.isfinite(gap), gap, 0.0))
            left[rows, nearest] = False
            best = np.minimum(best, self.distances[nearest])
        return largest


def between_all(positions: Array) -> Array:
    """Distances between all objects, shape (n, n) in [m]."""
    return np.asarray(np.linalg.norm(positions[:, None] - positions[None], axis=2))


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
    return np.asarray(values / np.maximum(scale, _LEAST))


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
        np.where(s.spread[0] > _LEAST, np.minimum(turned, np.pi - turned) / (np.pi / 2), 1.0),  # a point has no axis
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
