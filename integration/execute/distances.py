"""Distances of points from convex regions in the plane."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def distances_outside(region: ArrayLike, points: ArrayLike) -> Array:
    """Signed distances of points from a convex region: negative inside.

    Args:
        region: (m, 2) outline, anticlockwise, in [m].
        points: (n, 2) in [m].

    Returns:
        (n,) in [m].
    """
    starts = np.asarray(region, dtype=np.float64)
    places = np.asarray(points, dtype=np.float64).reshape(-1, 1, 2)
    edges = np.roll(starts, -1, axis=0) - starts
    offsets = places - starts
    lengths = np.maximum((edges**2).sum(axis=1), 1e-12)
    shares = np.clip((offsets * edges).sum(axis=2) / lengths, 0.0, 1.0)
    nearest = np.linalg.norm(offsets - shares[:, :, None] * edges, axis=2).min(axis=1)
    inside = (edges[:, 0] * offsets[:, :, 1] - edges[:, 1] * offsets[:, :, 0] >= 0).all(axis=1)
    return np.asarray(np.where(inside, -nearest, nearest))
