"""How objects lie among others: between two, amid several, surrounded by them, or alone."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from grounding.graded import scores
from grounding.graded.scene import Scene
from grounding.graded.values import SETS, Value
from grounding.world import Array

_MOST = 12  # of the objects that a phrase may mean, so many are tried two by two


def amid(scene: Scene, value: Value) -> Array:
    """How well every object lies between two, or amid several, shape (n,)."""
    total = np.zeros(scene.n)
    if value.kind == "sets":
        for mask, chance in value.sets[:SETS]:
            total = np.maximum(total, chance * _amid_members(scene, np.flatnonzero(mask)) * ~mask)
        if value.sets and total.max(initial=0.0) > 0.1:
            return total
    likely = np.flatnonzero(value.weights > 0.4 * scores.peak(value.weights))[:_MOST]
    for b, a in combinations(likely, 2):
        held = scores.between(scene.xy, scene.xy[a], scene.xy[b], scene.edge)
        held[[a, b]] = 0.0
        total = np.maximum(total, held)
    return total


def _amid_members(scene: Scene, members: np.ndarray) -> Array:
    """Between any two members of a set; less surely where they are more than two."""
    if len(members) == 2:
        return scores.between(scene.xy, scene.xy[members[0]], scene.xy[members[1]], scene.edge)
    held = np.zeros(scene.n)
    for b, a in combinations(members, 2):
        held = np.maximum(held, 0.8 * scores.between(scene.xy, scene.xy[a], scene.xy[b], scene.edge))
    return held


def surrounded(scene: Scene, value: Value) -> Array:
    """How well every object is surrounded by what a phrase means, by all where it means nothing, shape (n,)."""
    weights = value.weights / scores.peak(value.weights)
    if not value.weights.any():
        weights = np.ones(scene.n)
    close = scores.beside(scene.gaps, scene.edge, 1.5) * weights[None, :]
    np.fill_diagonal(close, 0.0)
    count = close.sum(axis=1)
    wanted = value.number or 3
    return np.asarray(1.0 / (1.0 + np.exp(-(count - 0.6 * wanted) / 0.4)))


def lone(scene: Scene, base: Array) -> Array:
    """How well every object stands apart: from all, from those of its kind (`base`, shape (n,)), and by itself."""
    if scene.n < 2:
        return np.ones(scene.n)
    gaps = scene.gaps + np.where(np.eye(scene.n, dtype=bool), np.inf, 0.0)
    nearest = gaps.min(axis=1)
    same = np.where(base[None, :] > 0.5, gaps, np.inf).min(axis=1)
    same = np.where(np.isfinite(same), same, nearest.max(initial=0.0) * 2)
    alone = scores.ranked(base, nearest, 1, 0.4 * scene.edge)
    apart = scores.ranked(base, same, 1, 0.4 * scene.edge)
    single = scores.logistic((nearest / scene.edge - 0.7) / 0.25) * ~scene.stacked
    return np.asarray(0.2 * alone + 0.15 * apart + 0.65 * single)
