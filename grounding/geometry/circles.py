"""Circles of objects."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from grounding.geometry.arrangement import Arrangement
from grounding.geometry.many import masks_of, neighbouring, parts, regularities, separations
from grounding.world import Array

TOLERANCE = 0.35  # distance from the circle [edges]
NEIGHBOURS = 8  # triples are formed of an object and two of so many nearest neighbours
_LEAST, _LARGEST = 0.9, 0.35  # radii [edges], [m]
_FEWEST = 4  # members of a circle
_WIDEST = 1.9  # the largest turn between members, over the mean one


def find_circles(positions: Array, distances: Array, flat: np.ndarray, edge: float) -> list[Arrangement]:
    """Circles of four and more among the objects `flat`, all around and with nothing else on them."""
    if len(flat) < _FEWEST:
        return []
    points = positions[flat, :2]
    triples = _triples(distances[np.ix_(flat, flat)])
    centres, radii = _circumcircles(*(points[triples[:, corner]] for corner in range(3)))
    keep = (radii > _LEAST * edge) & (radii < _LARGEST)
    centres, radii = centres[keep], radii[keep]
    found: dict[int, Arrangement] = {}
    for rows, local in _members(points, centres, radii, TOLERANCE * edge):
        _measure(positions, distances, flat[local], centres[rows], radii[rows], edge, found)
    return [found[mask] for mask in sorted(found)]


def _triples(apart: Array) -> np.ndarray:
    """Objects with two of their neighbours, each three once, in order: indices, shape (m, 3)."""
    count = len(apart)
    near = neighbouring(apart, NEIGHBOURS)
    one, other = np.triu_indices(near.shape[1], 1)
    own = np.repeat(np.arange(count), len(one))
    triples = np.sort(np.stack([own, near[:, one].ravel(), near[:, other].ravel()], axis=1), axis=1)
    codes = np.unique((triples[:, 0] * count + triples[:, 1]) * count + triples[:, 2])
    return np.stack([codes // count**2, codes // count % count, codes % count], axis=1)


def _members(points: Array, centres: Array, radii: Array, tolerance: float) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Circles with enough points on them, by their number: which they are, and the indices of the points."""
    inliers = np.empty((len(centres), len(points)), dtype=bool)
    for part in parts(len(centres), len(points)):
        dx = points[None, :, 0] - centres[part, 0, None]
        dy = points[None, :, 1] - centres[part, 1, None]
        inliers[part] = np.abs(np.sqrt(dx * dx + dy * dy) - radii[part, None]) <= tolerance
    sizes = inliers.sum(axis=1)
    for size in np.unique(sizes[sizes >= _FEWEST]):
        rows = np.flatnonzero(sizes == size)
        yield rows, np.nonzero(inliers[rows])[1].reshape(len(rows), size)


def _measure(
    positions: Array, distances: Array, members: np.ndarray, centres: Array, radii: Array, edge: float,
    found: dict[int, Arrangement],
) -> None:  # fmt: skip
    """Add the circles that have members all around; of several with the same members the one that fits best."""
    size = members.shape[1]
    offset = positions[members][:, :, :2] - centres[:, None]
    angles = np.sort(np.arctan2(offset[:, :, 1], offset[:, :, 0]), axis=1)
    turns = np.diff(np.concatenate([angles, angles[:, :1] + 2 * np.pi], axis=1), axis=1)
    around = turns.max(axis=1) <= _WIDEST * 2 * np.pi / size
    if not around.any():
        return
    members, offset, radii, turns = members[around], offset[around], radii[around], turns[around]
    between = distances[members[:, :, None], members[:, None, :]]
    chords = np.sort(between, axis=2)[:, :, 1]
    away = np.linalg.norm(offset, axis=2) - radii[:, None]
    deviations = np.sqrt((away**2).mean(axis=1)) / np.maximum(chords.mean(axis=1), edge / 2)
    inside = np.zeros((len(members), len(positions)), dtype=bool)
    np.put_along_axis(inside, members, True, axis=1)
    best: dict[int, int] = {}
    masks = masks_of(inside)
    for row, mask in enumerate(masks):
        if mask not in best or deviations[row] < deviations[best[mask]]:
            best[mask] = row
    rows = np.array(list(best.values()))
    members = members[rows]
    centroids = positions[members].mean(axis=1)
    measures = (deviations[rows], regularities(turns[rows]), separations(distances, members, chords[rows].max(axis=1)))
    for mask, centroid, off, even, apart in zip(best, centroids, *(m.tolist() for m in measures), strict=True):
        found[mask] = Arrangement("circle", mask, size, centroid, off, even, apart)


def _circumcircles(a: Array, b: Array, c: Array) -> tuple[Array, Array]:
    ab, ac = b - a, c - a
    cross = 2 * (ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0])
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ab2, ac2 = (ab**2).sum(axis=1), (ac**2).sum(axis=1)
        x = (ac[:, 1] * ab2 - ab[:, 1] * ac2) / cross
        y = (ab[:, 0] * ac2 - ac[:, 0] * ab2) / cross
    offset = np.clip(np.nan_to_num(np.stack([x, y], axis=1), nan=1e6), -1e6, 1e6)
    return a + offset, np.linalg.norm(offset, axis=1)
