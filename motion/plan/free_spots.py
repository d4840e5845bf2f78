"""Free places on tables: where a box can be set down with room for the fingers around it."""

from __future__ import annotations

import numpy as np

from motion.poses import Array
from motion.scene import Box, Scene, standing

GRID = 0.02
ROOM = 0.035
"""Least gap to every other box in metres: fingers fit in."""
MARGIN = 0.02
"""Least gap to the edge of the table in metres."""


def free_spots(scene: Scene, name: str) -> Array:
    """Places on tables, which are fixed boxes, where a box would rest, clear of every other.

    Args:
        scene: where everything is.
        name: the box; where it is now does not count as taken.

    Returns:
        (n, 3) places of its centre in metres, in a fixed order.

    Raises:
        UnknownBody: there is no such box.
    """
    box = standing(scene.box(name))
    found = [_on(scene, table, box) for table in scene.boxes if table.fixed]
    return np.concatenate(found) if found else np.empty((0, 3))


def radius(box: Box) -> float:
    """Of the smallest circle about a box's centre, seen from above, that it fits in; metres."""
    return float(np.max(np.linalg.norm(box.footprint - box.position[:2], axis=1)))


def _on(scene: Scene, table: Box, box: Box) -> Array:
    reach = radius(box)
    low = table.position[:2] - table.half_extents[:2] + reach + MARGIN
    high = table.position[:2] + table.half_extents[:2] - reach - MARGIN
    if (high < low).any():
        return np.empty((0, 3))
    x, y = (np.arange(np.ceil(a / GRID), np.floor(b / GRID) + 1) * GRID for a, b in zip(low, high, strict=True))
    places = np.array(np.meshgrid(x, y, indexing="ij")).reshape(2, -1).T
    free = np.ones(len(places), dtype=bool)
    for other in scene.boxes:
        if not other.fixed and other.name != box.name:
            free &= np.linalg.norm(places - other.position[:2], axis=1) >= reach + radius(other) + ROOM
    height = table.top + float(box.half_extents[2])
    return np.column_stack([places[free], np.full(int(free.sum()), height)])
