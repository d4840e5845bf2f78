"""Standing apart from others: alone, by itself, single."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.degrees import logistic, ranked
from grounding.lexicon.parameters import value
from grounding.world import Array
from grounding.world.scene import Scene


def truth(scene: Scene, base: Array, *, counted: bool = False) -> Array:
    """How well every object stands apart: from all, from those of its kind, and by itself, shape (n,).

    Args:
        scene: the world.
        base: how well every object is of the kind that is spoken of, shape (n,).
        counted: whether words tell further which one is meant, so that all that is not stacked may be.
    """
    if scene.n < 2:
        return np.ones(scene.n)
    gaps = scene.gaps + np.where(np.eye(scene.n, dtype=bool), np.inf, 0.0)
    nearest = gaps.min(axis=1)
    same = np.where(base[None, :] > 0.5, gaps, np.inf).min(axis=1)
    same = np.where(np.isfinite(same), same, nearest.max(initial=0.0) * 2)
    blur = 0.4 * scene.edge
    most = 0.57 * ranked(base, nearest, 1, blur) + 0.43 * ranked(base, same, 1, blur)
    single = logistic((nearest / scene.edge - value("alone.gap")) / value("alone.blur")) * ~scene.stacked
    if scene.towers:  # "the single block" is one that is not stacked
        single = np.maximum(single, value("alone.unstacked") * ~scene.stacked)
    share = value("alone.most_alone")
    found = np.asarray(share * most + (1 - share) * single)
    return np.maximum(found, value("alone.counted") * ~scene.stacked) if counted and scene.towers else found


def gaps_to_others(scene: Scene, others: np.ndarray) -> Array:
    """The gap from every object to the nearest of some others than itself, shape (n,) in [m]; the widest where none is.

    Args:
        scene: the world.
        others: which objects count, boolean (n,).
    """
    found = np.where(others[None, :] & ~np.eye(scene.n, dtype=bool), scene.gaps, np.inf).min(axis=1, initial=np.inf)
    there = np.isfinite(found)
    return np.asarray(np.where(there, found, found[there].max() if there.any() else scene.edge))
