"""Graded predicates: how well places and orders agree with what words ask for, each in [0, 1]."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.degrees import logistic
from grounding.world import Array

DECAY = 2.5
"""A direction fades over gaps of so many edges: what is meant is usually the next one."""
STRICT = 0.4
"""Of that, where "directly" or "right" narrows it."""


def directed(
    offset: Array, gap: Array, direction: Array, edge: float, *, strict: bool = False, fading: bool = True
) -> Array:
    """How well offsets lie in a direction: ahead, little to the side, not far.

    Args:
        offset: from the reference, shape (..., 2) in [m].
        gap: between the boxes, shape (...,) in [m].
        direction: unit vector (2,).
        edge: of a block [m].
        strict: "directly": little to the side and near count more.
        fading: whether it also counts how near: not where those in a direction are counted.
    """
    ahead = offset @ direction
    side = np.abs(offset[..., 0] * direction[1] - offset[..., 1] * direction[0])
    tolerance = (0.3 if strict else 0.6) * np.maximum(ahead, 0.0) + (0.35 if strict else 0.5) * edge
    beyond = logistic((ahead - 0.4 * edge) / (0.12 * edge))
    near = np.exp(-gap / ((STRICT if strict else 1.0) * DECAY * edge)) if fading else 1.0
    return np.asarray(beyond * np.exp(-0.5 * (side / tolerance) ** 2) * near)


def beside(gap: Array, edge: float, reach: float) -> Array:
    """How well a gap between boxes counts as beside: 1 at contact, one half at `reach` edges."""
    return np.asarray(1.0 / (1.0 + (gap / (reach * edge)) ** 3))


def side(scaled: Array, extent: Array) -> Array:
    """How well places count as on a side.

    Args:
        scaled: along the side's direction, 1 at the edge, shape (n,).
        extent: the same for those that are compared, whose extreme one is the best.
    """
    best = float(extent.max()) if len(extent) else 1.0
    return np.asarray(logistic((scaled - 0.1) / 0.12) * np.exp(1.2 * (scaled - best)))
