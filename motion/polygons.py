"""Convex outlines in the plane: hull, containment, and how deep two of them overlap."""

from __future__ import annotations

import numpy as np

from motion.poses import Array


def hull(points: Array) -> Array:
    """(m, 2) convex hull of (n, 2) points, anticlockwise (Andrew's monotone chain); points within 1e-9 count as one."""
    ordered = np.unique(np.round(points, 9), axis=0)

    def chain(sequence: Array) -> list[Array]:
        kept: list[Array] = []
        for point in sequence:
            while len(kept) > 1 and _cross(kept[-1] - kept[-2], point - kept[-2]) <= 1e-12:
                kept.pop()
            kept.append(point)
        return kept

    return np.array(chain(ordered)[:-1] + chain(ordered[::-1])[:-1])


def contains(outline: Array, point: Array, margin: float = 0.0) -> bool:
    """Tells whether `point` (2,) lies inside the anticlockwise `outline`, at least `margin` metres from its edges."""
    edges = np.roll(outline, -1, axis=0) - outline
    inward = edges[:, 0] * (point[1] - outline[:, 1]) - edges[:, 1] * (point[0] - outline[:, 0])
    return bool(np.all(inward >= margin * np.linalg.norm(edges, axis=1) - 1e-12))


def overlap(first: Array, second: Array) -> float:
    """Depth in metres by which two convex outlines overlap; negative: a lower bound of the gap (separating axes)."""
    depth = np.inf
    for outline in (first, second):
        edges = np.roll(outline, -1, axis=0) - outline
        normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.linalg.norm(edges, axis=1, keepdims=True)
        a, b = first @ normals.T, second @ normals.T
        depth = min(depth, float(np.min(np.minimum(a.max(0) - b.min(0), b.max(0) - a.min(0)))))
    return depth


def _cross(a: Array, b: Array) -> float:
    return float(a[0] * b[1] - a[1] * b[0])
