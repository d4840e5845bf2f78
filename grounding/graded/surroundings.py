"""How objects lie apart from others."""

from __future__ import annotations

import numpy as np

from grounding.lexicon import degrees
from grounding.world import Array
from grounding.world.scene import Scene

UNSTACKED = 0.5
"""How well what touches others, but stands on the table by itself, is single where others are stacked."""

COUNTED = 0.9
"""The same where it is counted or ranked among the others that are single."""


def lone(scene: Scene, base: Array) -> Array:
    """How well every object stands apart: from all, from those of its kind (`base`, shape (n,)), and by itself."""
    if scene.n < 2:
        return np.ones(scene.n)
    gaps = scene.gaps + np.where(np.eye(scene.n, dtype=bool), np.inf, 0.0)
    nearest = gaps.min(axis=1)
    same = np.where(base[None, :] > 0.5, gaps, np.inf).min(axis=1)
    same = np.where(np.isfinite(same), same, nearest.max(initial=0.0) * 2)
    alone = degrees.ranked(base, nearest, 1, 0.4 * scene.edge)
    apart = degrees.ranked(base, same, 1, 0.4 * scene.edge)
    single = degrees.logistic((nearest / scene.edge - 0.7) / 0.25) * ~scene.stacked
    if scene.towers:  # "the single block" is one that is not stacked
        single = np.maximum(single, UNSTACKED * ~scene.stacked)
    return np.asarray(0.2 * alone + 0.15 * apart + 0.65 * single)


def single(scene: Scene, base: Array) -> Array:
    """The same where words tell further which one is meant: all that is not stacked, where others are."""
    apart = lone(scene, base)
    return np.maximum(apart, COUNTED * ~scene.stacked) if scene.towers else apart
