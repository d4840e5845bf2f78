"""Free places on tables: where blocks can be set down out of the way, or beside one another."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

import motion
from grounding.pictures.outlines import convex_hull, rounded_hull
from integration.execute.distances import distances_outside
from motion import Scene
from motion.plan.free_spots import radius
from motion.scene import standing

REGION = 0.02
"""By how much a region is larger than the outline of what lies in it, in [m]."""
_EDGE = 0.6  # how much being near an edge weighs against a short way


def region_of(scene: Scene, names: Sequence[str]) -> np.ndarray:
    """The convex region on the table that objects take up, (n, 2) anticlockwise in [m]."""
    points = np.concatenate([scene.box(name).footprint for name in names])
    return rounded_hull(points, REGION)


def spots_clear_of(scene: Scene, name: str, avoid: Sequence[ArrayLike] = ()) -> np.ndarray:
    """Places on tables where an object would rest, clear of every other.

    Args:
        scene: where everything is.
        name: the object.
        avoid: convex outlines, (n, 2) in [m], that its own must keep out of.

    Returns:
        (n, 3) places of its centre in [m], in a fixed order.
    """
    spots = motion.free_spots(scene, name)
    free = np.ones(len(spots), dtype=bool)
    for outline in avoid:
        free &= distances_outside(convex_hull(outline), spots[:, :2]) >= radius(standing(scene.box(name)))
    return spots[free]


def out_of_the_way(scene: Scene, name: str, region: np.ndarray) -> np.ndarray:
    """Free spots outside a region, (n, 3) in [m]: the near and the outermost first."""
    spots = spots_clear_of(scene, name, [region])
    if not len(spots):
        return spots
    box = scene.box(name)
    ways = np.linalg.norm(spots[:, :2] - box.position[:2], axis=1)
    edges = np.full(len(spots), np.inf)
    for table in scene.boxes:
        if table.fixed:
            low, high = table.position[:2] - table.half_extents[:2], table.position[:2] + table.half_extents[:2]
            sides = np.minimum(spots[:, 1] - low[1], high[1] - spots[:, 1])
            edges = np.minimum(edges, np.minimum(sides, spots[:, 0] - low[0]))
    return spots[np.lexsort((spots[:, 1], spots[:, 0], np.round(ways + _EDGE * edges, 4)))]


def beside(scene: Scene, name: str, place: ArrayLike) -> np.ndarray:
    """Free spots, (n, 3) in [m], the nearest to `place`, (3,) in [m], first."""
    spots = spots_clear_of(scene, name)
    ways = np.linalg.norm(spots[:, :2] - np.asarray(place, dtype=float)[:2], axis=1)
    return spots[np.lexsort((spots[:, 1], spots[:, 0], np.round(ways, 4)))]
