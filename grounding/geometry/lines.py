"""Rows and columns of objects, and clusters that are seen as one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from grounding.geometry.arrangement import Arrangement
from grounding.geometry.many import by_size, masks_of, neighbouring, parts, regularities, separations
from grounding.geometry.masks import indices_of
from grounding.world import Array

TOLERANCES = ((0.45, 1.7), (1.2, 2.6))  # distance from the line [edges], largest ratio of neighbouring gaps
ELONGATED = 0.3  # a cluster is a band, seen as a line, when its second axis is at most so long, of the first
_DOUBT = 1e-9  # moments that differ by less are looked at more closely [m^2]
NEIGHBOURS = 8  # pairs are formed among so many nearest neighbours


class _Pairs(NamedTuple):
    """Pairs of neighbours that lines grow from."""

    first: np.ndarray
    second: np.ndarray
    gap: Array
    """Between them, in [m]."""

    def part(self, rows: slice) -> _Pairs:
        """Some of them."""
        return _Pairs(self.first[rows], self.second[rows], self.gap[rows])


def find_lines(positions: Array, distances: Array, flat: np.ndarray, edge: float) -> list[Arrangement]:
    """Rows and columns among the objects `flat`: runs that go on evenly from a pair of neighbours."""
    points = positions[flat, :2]
    pairs = _pairs(distances[np.ix_(flat, flat)], 0.5 * edge)
    runs: dict[int, np.ndarray] = {}
    for tolerance, ratio in TOLERANCES:
        for rows in parts(len(pairs.gap), len(flat)):
            grown = [flat[run] for run in _grown(points, pairs.part(rows), tolerance * edge, ratio)]
            for mask, run in zip(_masks(grown, len(positions)), grown, strict=True):
                runs.setdefault(mask, run)
    masks = sorted(runs)
    return _measured(positions, distances, [runs[mask] for mask in masks], masks, edge)


def find_bands(positions: Array, distances: Array, groups: Sequence[Arrangement], edge: float) -> list[Arrangement]:
    """The clusters that are long and narrow, as rows or columns."""
    masks = [group.mask for group in groups if group.count >= 3]
    sets = [np.array(list(indices_of(mask))) for mask in masks]
    narrow = [place for place in _perhaps_narrow(positions, sets) if _is_narrow(positions[sets[place], :2])]
    return _measured(positions, distances, [sets[p] for p in narrow], [masks[p] for p in narrow], edge)


def _perhaps_narrow(positions: Array, sets: Sequence[np.ndarray]) -> np.ndarray:
    """The places of the sets that are not clearly too wide to be bands, by their second moments."""
    if not sets:
        return np.zeros(0, dtype=int)
    x, y = (positions[:, :2] - positions[:, :2].mean(axis=0)).T
    values = np.stack([x, y, x * x, x * y, y * y], axis=1)[np.concatenate(sets)]
    sizes = np.array([len(one) for one in sets])
    sums = np.add.reduceat(values, np.cumsum(sizes) - sizes, axis=0) / sizes[:, None]
    x, y, xx, xy, yy = sums.T
    xx, xy, yy = xx - x * x, xy - x * y, yy - y * y
    half, root = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
    return np.flatnonzero(half - root <= ELONGATED**2 * (half + root) + _DOUBT)


def _is_narrow(points: Array) -> bool:
    singular = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return bool(singular[1] <= ELONGATED * singular[0])


def _pairs(apart: Array, least: float) -> _Pairs:
    """The pairs of neighbours that are at least so far apart, each once, in order."""
    near = neighbouring(apart, NEIGHBOURS)
    own = np.repeat(np.arange(len(apart)), near.shape[1])
    other = near.ravel()
    codes = np.unique(np.minimum(own, other) * len(apart) + np.maximum(own, other))
    first, second = np.divmod(codes, len(apart))
    gap = apart[first, second]
    kept = gap >= least
    return _Pairs(first[kept], second[kept], gap[kept])


def _grown(points: Array, pairs: _Pairs, tolerance: float, ratio: float) -> list[np.ndarray]:
    """The runs of points through pairs, in order; none for pairs that another point lies between.

    Args:
        points: shape (n, 2) in [m].
        pairs: of the points.
        tolerance: distance from the line, in [m]; less between pairs that are close.
        ratio: largest ratio of neighbouring gaps.
    """
    if not len(pairs.gap):
        return []
    start, gap = points[pairs.first], pairs.gap
    x, y = ((points[pairs.second] - start) / gap[:, None]).T
    dx, dy = (points[:, axis] - start[:, axis, None] for axis in range(2))
    across = np.abs(dx * y[:, None] - dy * x[:, None])
    rows, inliers = np.nonzero(across <= np.minimum(tolerance, 0.35 * gap)[:, None])
    along = dx[rows, inliers] * x[rows] + dy[rows, inliers] * y[rows]
    order = np.lexsort((along, rows))
    inliers = inliers[order]  # of all lines, one after the other, each in its direction
    steps = np.diff(along[order])
    even = (rows[1:] == rows[:-1]) & (gap[rows[1:]] / ratio <= steps) & (steps <= gap[rows[1:]] * ratio)
    ends = np.concatenate([[-1], np.flatnonzero(~even), [len(rows) - 1]])  # a run ends at each of these places
    here, there = np.flatnonzero(inliers == pairs.first[rows]), np.flatnonzero(inliers == pairs.second[rows])
    firsts = ends[np.searchsorted(ends, here) - 1] + 1
    lasts = ends[np.searchsorted(ends, there)]
    return [inliers[a : b + 1] for a, b, i, j in zip(firsts, lasts, here, there, strict=True) if j - i == 1]


def _masks(sets: Sequence[np.ndarray], count: int) -> list[int]:
    """The masks of sets of indices, of so many objects."""
    inside = np.zeros((len(sets), count), dtype=bool)
    if sets:
        inside[np.repeat(np.arange(len(sets)), [len(one) for one in sets]), np.concatenate(sets)] = True
    return masks_of(inside)


def _measured(
    positions: Array, distances: Array, runs: Sequence[np.ndarray], masks: Sequence[int], edge: float
) -> list[Arrangement]:
    """Lines, by their members in order, as rows and columns with how well they are formed."""
    found: dict[int, Arrangement] = {}
    for size, places in by_size(runs).items():
        members = np.array([runs[place] for place in places])
        centroids = positions[members].mean(axis=1)
        points = positions[members][:, :, :2]
        centred = points - points.mean(axis=1, keepdims=True)
        _, singular, axes = np.linalg.svd(centred, full_matrices=False)
        axis = axes[:, 0]
        gaps = np.diff(np.sort(np.matmul(centred, axis[:, :, None])[:, :, 0], axis=1), axis=1)
        deviation = singular[:, 1] / np.sqrt(size) / np.maximum(gaps.mean(axis=1), edge / 2)
        lateral = np.arctan2(np.abs(axis[:, 0]), np.abs(axis[:, 1]))  # 0 along y, pi/2 along x
        measures = (deviation, regularities(gaps), separations(distances, members, gaps.max(axis=1)), lateral)
        for place, centroid, off, even, apart, angle in zip(
            places, centroids, *(m.tolist() for m in measures), strict=True
        ):
            kind, turned = ("row", angle) if angle <= np.pi / 4 else ("column", np.pi / 2 - angle)
            found[place] = Arrangement(kind, masks[place], size, centroid, off, even, apart, turned)
    return [found[place] for place in range(len(runs))]
