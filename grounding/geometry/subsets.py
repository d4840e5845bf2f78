"""Sets of objects side by side, and the distances and moments that measures of their shapes are made of."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from grounding.world import Array

ON_MODEL = 0.4  # tolerance of members [edges]
LEAST = 1e-9  # lengths below are none [m]
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
        return 1 - second / np.maximum(first, LEAST)

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
        order = np.argsort(-self.count, kind="stable")  # the largest sets first: the others are done before them
        count, left = self.count[order], self.inside[order]
        first = left.argmax(axis=1)
        left[np.arange(len(left)), first] = False
        best = self.distances[first].copy()
        largest = np.zeros(len(left))
        for joined in range(1, int(count.max(initial=1))):
            number = int(np.searchsorted(-count, -joined))  # of sets that have more members
            rows = np.arange(number)
            reach = np.where(left[:number], best[:number], np.inf)
            nearest = reach.argmin(axis=1)
            largest[:number] = np.maximum(largest[:number], reach[rows, nearest])
            left[rows, nearest] = False
            best[:number] = np.minimum(best[:number], self.distances[nearest])
        found = np.empty(len(largest))
        found[order] = largest
        return found


def between_all(positions: Array) -> Array:
    """Distances between all objects, shape (n, n) in [m]."""
    return np.asarray(np.linalg.norm(positions[:, None] - positions[None], axis=2))
