"""Outlines in the plane: convex hulls, and hulls that keep a distance and have round corners."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from grounding.world import Array, WorldObject

_CORNER = 24  # points on the circle that rounds a corner


def convex_hull(points: ArrayLike) -> Array:
    """Convex hull of (n, 2) points, (m, 2) in order (Andrew's monotone chain)."""
    ordered = sorted({(float(x), float(y)) for x, y in np.asarray(points, dtype=float)})
    if len(ordered) < 3:
        return np.array(ordered).reshape(-1, 2)

    def half(sequence: list[tuple[float, float]]) -> list[tuple[float, float]]:
        kept: list[tuple[float, float]] = []
        for x, y in sequence:
            while len(kept) > 1:
                (ax, ay), (bx, by) = kept[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0:
                    break
                kept.pop()
            kept.append((x, y))
        return kept[:-1]

    return np.array(half(ordered) + half(ordered[::-1]))


def rounded_hull(points: ArrayLike, distance: float) -> Array:
    """The outline that keeps `distance` from the convex hull of (n, 2) points, with round corners."""
    angles = np.linspace(0, 2 * np.pi, _CORNER, endpoint=False)
    circle = distance * np.column_stack([np.cos(angles), np.sin(angles)])
    return convex_hull((convex_hull(points)[:, None, :] + circle[None]).reshape(-1, 2))


def corners_of(item: WorldObject) -> Array:
    """The corners of an object, (8, 3) in the world's frame in [m]; the first four are those of its lowest face."""
    w, x, y, z = item.orientation
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    signs = np.array([[a, b, c] for c in (-1, 1) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
    corners = item.position + (signs * item.size / 2) @ rotation.T
    return np.asarray(corners)


def outline_of(item: WorldObject) -> Array:
    """The outline of an object seen from above, (m, 2) in [m]."""
    return convex_hull(corners_of(item)[:, :2])
