"""Configurations between configurations: how finely a path is looked at, and in which order."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

import numpy as np

from motion.poses import Array

GRID = 0.005
"""Longest step of any joint between two configurations of a trajectory that is verified, radians."""
SEARCH_GRID = 0.02
"""The same while a path is searched for: what is found is verified on the finer grid."""


def dense(path: Sequence[Array], grid: float = GRID) -> Iterable[Array]:
    """Configurations along straight lines through `path`, no joint moving by more than `grid` between two."""
    if len(path):
        yield path[0]
    for first, second in itertools.pairwise(path):
        steps = max(1, int(np.ceil(np.max(np.abs(second - first)) / grid)))
        for k in range(1, steps + 1):
            yield first + (second - first) * (k / steps)


def resampled(positions: Array, grid: float = GRID) -> Array:
    """(m, 7) configurations along (n, 7) `positions`, no joint moving by more than `grid` between two."""
    along = np.concatenate([[0.0], np.cumsum(np.max(np.abs(np.diff(positions, axis=0)), axis=1))])
    places = np.linspace(0.0, along[-1], int(np.ceil(along[-1] / grid - 1e-9)) + 1)
    return np.column_stack([np.interp(places, along, column) for column in positions.T])


def bisected(steps: int) -> list[int]:
    """0 .. steps, ends first, then ever finer halves."""
    order, seen = [0, steps], {0, steps}
    stride = 1 << max(0, steps - 1).bit_length()
    while stride >= 1:
        for k in range(0, steps + 1, stride):
            if k not in seen:
                seen.add(k)
                order.append(k)
        stride //= 2
    return order
