"""Sets of equally many objects, measured side by side: one row of an array for each set."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from grounding.world import Array

ALONE = 3.0  # separation of what has no other object beside it
_LEAST = 1e-6  # the smallest gap that separations are measured by [m]
_CELLS = 1 << 15  # of an array at a time: it stays in the cache


def parts(count: int, cells: int) -> Iterator[slice]:
    """Slices of so many rows that their arrays of so many cells a row stay small."""
    step = max(1, _CELLS // max(cells, 1))
    return (slice(start, start + step) for start in range(0, count, step))


def by_size(sets: Sequence[np.ndarray]) -> dict[int, list[int]]:
    """Number of members -> the places of the sets that have so many."""
    places: dict[int, list[int]] = {}
    for place, members in enumerate(sets):
        places.setdefault(len(members), []).append(place)
    return places


def masks_of(inside: np.ndarray) -> list[int]:
    """The masks of sets, see `grounding.geometry.masks`.

    Args:
        inside: which objects are in which set, shape (m, n), booleans.
    """
    packed = np.packbits(inside, axis=1, bitorder="little")
    width = packed.shape[1]
    content = packed.tobytes()
    return [int.from_bytes(content[i : i + width], "little") for i in range(0, len(content), width)] if width else []


def regularities(gaps: Array) -> Array:
    """1 for even gaps, towards 0 for uneven ones; shape (m,) for gaps of shape (m, k)."""
    mean = gaps.mean(axis=1)
    if gaps.shape[1] < 2:
        return np.ones(len(gaps))
    spread = np.std(gaps, axis=1)
    there = mean > 0
    return np.where(there, np.maximum(0.0, 1.0 - spread / np.where(there, mean, 1.0)), 1.0)


def separations(distances: Array, members: np.ndarray, largest_gaps: Array) -> Array:
    """Distance to the nearest other object over the largest gap within.

    Args:
        distances: between all objects, shape (n, n) in [m].
        members: of each set, indices, shape (m, k).
        largest_gaps: within each set, shape (m,) in [m].
    """
    count, size = members.shape
    if size == len(distances):
        return np.full(count, ALONE)
    least = np.empty(count)
    for part in parts(count, size * len(distances)):
        reach = distances[members[part]].min(axis=1)
        np.put_along_axis(reach, members[part], np.inf, axis=1)
        least[part] = reach.min(axis=1)
    return least / np.maximum(largest_gaps, _LEAST)


def neighbouring(apart: Array, number: int) -> np.ndarray:
    """For each object, so many nearest others, the nearest first; fewer where there are not so many.

    Args:
        apart: distances between the objects, shape (n, n).
        number: how many.
    """
    return np.argsort(apart, axis=1, kind="stable")[:, 1 : number + 1]
