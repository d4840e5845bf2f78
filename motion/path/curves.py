"""Curves through joint space: polylines made smooth, and run along so that one bound on their parameter suits all.

A polyline becomes a clamped cubic B-spline whose control points lie on it (Schoenberg's approximation), which cuts
corners and keeps straight lines straight. Its parameter is then replaced by the length of the way in a norm in which
every joint is weighed by what it may do, so that neither the beginning nor the end of a curve is run along more slowly
than the joints allow.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motion.poses import Array

_NORM = 8.0
_SAMPLES = 12
"""Samples a piece of the spline when its length is measured."""


class Curve:
    """A twice continuously differentiable curve on [0, 1].

    Args:
        path: waypoints, (7,) radians each, not all the same.
        spacing: distance between the spline's knots, radians.
        weights: (7,) what each joint may do, such as its greatest acceleration.

    Attributes:
        pieces: how many cubic polynomials it has.
    """

    def __init__(self, path: Sequence[Array], spacing: float, weights: Array) -> None:
        waypoints = np.array(path, dtype=np.float64)
        lengths = np.linalg.norm(np.diff(waypoints, axis=0), axis=1)
        kept = np.concatenate([[True], lengths > 1e-9])
        waypoints, lengths = waypoints[kept], lengths[kept[1:]]
        if len(waypoints) == 2:
            change = waypoints[1] - waypoints[0]
            zero = np.zeros((1, len(change)))
            self.pieces, self._breaks = 1, np.array([0.0, 1.0])
            self._terms: Array = np.stack([waypoints[:1], change[None], zero, zero])
            return
        along = np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum()
        spline = _Spline(waypoints, along, max(1, int(np.ceil(lengths.sum() / spacing)) + 1))
        s = np.linspace(0.0, 1.0, _SAMPLES * spline.pieces + 1)
        values, slopes = spline.evaluate(s)
        speed = np.sum(np.abs(slopes / weights) ** _NORM, axis=1) ** (1 / _NORM)
        way = np.concatenate([[0.0], np.cumsum((speed[1:] + speed[:-1]) / 2)])
        self.pieces = 2 * spline.pieces
        self._breaks = np.linspace(0.0, 1.0, self.pieces + 1)
        places = np.interp(self._breaks, way / way[-1], s)
        points = spline.evaluate(places)[0]
        points[0], points[-1] = values[0], values[-1]
        ends = slopes[[0, -1]] / speed[[0, -1], None] * (way[-1] * s[1])
        self._terms = _cubics(points, ends, 1.0 / self.pieces)

    def evaluate(self, s: Array) -> tuple[Array, Array, Array, Array]:
        """Position and three derivatives with respect to s at (n,) places, (n, 7) each."""
        piece = np.clip(np.searchsorted(self._breaks, s, side="right") - 1, 0, self.pieces - 1)
        x = (s - self._breaks[piece])[:, None]
        a, b, c, d = (term[piece] for term in self._terms)
        return a + x * (b + x * (c + x * d)), b + x * (2 * c + 3 * x * d), 2 * c + 6 * x * d, 6 * d


def _cubics(points: Array, ends: Array, step: float) -> Array:
    """(4, n, 7) coefficients of the cubic spline through (n + 1, 7) `points` a `step` apart, `ends` its end slopes.

    Its inner slopes solve the tridiagonal system that makes the second derivative continuous.
    """
    count = len(points)
    system = 4 * np.eye(count) + np.eye(count, k=1) + np.eye(count, k=-1)
    system[[0, -1]] = np.eye(count)[[0, -1]]
    wanted = np.vstack([ends[:1], 3 * (points[2:] - points[:-2]) / step, ends[1:]])
    slopes = np.linalg.solve(system, wanted)
    rise, first, second = np.diff(points, axis=0) / step, slopes[:-1], slopes[1:]
    return np.stack([points[:-1], first, (3 * rise - 2 * first - second) / step, (first + second - 2 * rise) / step**2])


class _Spline:
    """Clamped uniform cubic B-spline on [0, 1] along a polyline, with its slope.

    Its control points lie on the polyline at the knots' Greville abscissae, so that a straight polyline is run through
    at constant speed.
    """

    def __init__(self, waypoints: Array, along: Array, pieces: int) -> None:
        self.pieces = pieces
        self._knots = np.concatenate([np.zeros(3), np.linspace(0, 1, pieces + 1), np.ones(3)])
        greville = (self._knots[1:-3] + self._knots[2:-2] + self._knots[3:-1]) / 3
        points = np.column_stack([np.interp(greville, along, column) for column in waypoints.T])
        spans = self._knots[4:-1] - self._knots[1:-4]
        self._control = (points, 3 * np.diff(points, axis=0) / np.maximum(spans, 1e-12)[:, None])

    def evaluate(self, s: Array) -> tuple[Array, Array]:
        """Position and derivative with respect to s at (n,) places, (n, 7) each."""
        span = np.clip(np.searchsorted(self._knots, s, side="right") - 1, 3, len(self._control[0]) - 1).astype(np.int64)
        return self._value(0, s, span), self._value(1, s, span)

    def _value(self, order: int, s: Array, span: NDArray[np.int64]) -> Array:
        """De Boor's algorithm on the control points of a derivative, whose knots lose one at each end."""
        control, degree = self._control[order], 3 - order
        knots = self._knots[order : len(self._knots) - order]
        span = span - order
        d = [control[span - degree + j] for j in range(degree + 1)]
        for r in range(1, degree + 1):
            for j in range(degree, r - 1, -1):
                left, right = knots[span - degree + j], knots[span + 1 + j - r]
                t = ((s - left) / np.maximum(right - left, 1e-12))[:, None]
                d[j] = (1 - t) * d[j - 1] + t * d[j]
        return d[degree]
