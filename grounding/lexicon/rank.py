"""Ranks among several: the third from the left, the nearest, the middle one, the end of a row."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from grounding.lexicon.degrees import peak, ranked
from grounding.lexicon.parameters import value
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene


def truth(pool: Array, key: Array, index: int, noise: float) -> Array:
    """How well every object is the index-th of a pool by a key, shape (n,); membership in the pool left aside.

    Args:
        pool: membership of each object, shape (n,), at most 1.
        key: larger comes first, shape (n,).
        index: rank from 1; -1 is the last.
        noise: differences of the key that are hard to see.
    """
    found = ranked(pool, key, index, noise)
    return np.divide(found, pool, out=np.zeros(len(pool)), where=pool > 1e-9)


def blur(scene: Scene) -> float:
    """Differences along the table that are hard to see [m]."""
    return value("rank.blur") * scene.edge


def main_axis(points: Array) -> Array:
    """The longer axis of points (m, 2), a unit vector (2,)."""
    return np.asarray(np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][0])


def along(scene: Scene, pool: Array) -> Array:
    """How far every object is from the middle of a pool along its longer side, shape (n,) in [m]."""
    points = scene.xy[pool > 0.3 * pool.max()]
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return np.asarray((scene.xy - centre) @ main_axis(points))


def middle(scene: Scene, pool: Array, *, chosen: bool) -> Array:
    """How well every object is the middle one of a pool, shape (n,): nearest to its centre, and by rank along it.

    Args:
        scene: the world.
        pool: weights (n,) of those among which it is.
        chosen: whether words chose the pool; else the middle of all may be meant as well.
    """
    total = float(pool.sum())
    if total < 1e-9:
        return np.zeros(scene.n)
    noise = value("rank.middle_blur") * scene.edge
    centre = pool @ scene.xy / total
    by_centre = truth(pool, -np.linalg.norm(scene.xy - centre, axis=1), 1, noise)
    likely = np.flatnonzero(pool > 0.3 * pool.max())
    by_rank = np.zeros(scene.n)
    if len(likely) > 2:
        points = scene.xy[likely]
        order = likely[np.argsort(points @ main_axis(points), kind="stable")]
        central = order[(len(order) - 1) // 2 : len(order) // 2 + 1]
        by_rank[central] = 1.0 / len(central)
    found = 0.5 * by_centre + 0.5 * by_rank
    if chosen:
        return np.asarray(found)
    share = value("rank.middle_of_all")
    of_all = truth(pool, -np.linalg.norm(scene.seen, axis=1), 1, noise)
    return np.asarray((1 - share) * found + share * of_all)


def start(scene: Scene, kinds: Collection[str]) -> str:
    """The direction in which the first of a row or a column lies, where nothing is said: left, or the near end.

    Where only places tell things apart people speak of a picture, and count its columns from the top.
    """
    if "row" in kinds:
        return "left"
    return "front" if len(scene.layout.colors) > 1 else "back"


def counted_off(scene: Scene, view: str, pool: Array, index: int, kinds: tuple[str, ...]) -> Array:
    """An ordinal without a direction, shape (n,): from the start of a line, or whichever.

    Args:
        scene: the world.
        view: whose left is meant.
        pool: weights (n,) of those that are counted.
        index: rank from 1; -1 is the last.
        kinds: of arrangement from which is chosen.
    """
    noise, share = blur(scene), value("rank.from_left")
    if "row" in kinds or "column" in kinds:
        key = scene.xy @ scene.direction(start(scene, kinds), view)
        return np.asarray(share * truth(pool, key, index, noise) + (1 - share) * truth(pool, -key, index, noise))
    spread = scene.xy[pool > 0.3 * peak(pool)]
    extent = np.ptp(spread, axis=0) if len(spread) else np.ones(2)
    sideways = float(extent[1] / max(extent.sum(), 1e-9))
    left = scene.xy @ scene.direction("left", view)
    near = -np.linalg.norm(scene.xy - scene.viewpoint(ROBOT).position[:2], axis=1)
    across = 0.8 * (share * truth(pool, left, index, noise) + (1 - share) * truth(pool, -left, index, noise))
    return np.asarray(sideways * across + (1 - 0.8 * sideways) * truth(pool, near, index, noise))
