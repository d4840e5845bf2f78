"""Graded predicates: how well places and orders agree with what words ask for, each in [0, 1]."""

from __future__ import annotations

import numpy as np

from grounding.world import Array

DECAY = 2.5
"""A direction fades over gaps of so many edges: what is meant is usually the next one."""
STRICT = 0.4
"""Of that, where "directly" or "right" narrows it."""
FLOOR = 0.02
"""A restriction that does not hold leaves so much: words and eyes err."""


def logistic(values: Array) -> Array:
    """1 / (1 + exp(-x)), without overflow."""
    return np.asarray(0.5 * (1.0 + np.tanh(0.5 * values)))


def softened(held: Array) -> Array:
    """A restriction that leaves `FLOOR` where it does not hold."""
    return np.asarray(FLOOR + (1 - FLOOR) * held)


def peak(weights: Array) -> float:
    """The largest weight, kept from zero so that it can be divided by."""
    return max(float(weights.max(initial=0.0)), 1e-9)


def ranked(weights: Array, key: Array, index: int, noise: float) -> Array:
    """How likely each member is the index-th by a key, where membership itself is uncertain.

    Every other object is in the set with the probability `weights[j]` and lies beyond i with
    logistic((key[j] - key[i]) / noise), so that the number of those beyond i is Poisson-binomial.

    Args:
        weights: membership of each object, shape (n,).
        key: larger comes first, shape (n,).
        index: rank from 1; -1 is the last.
        noise: differences of the key that are hard to see.

    Returns:
        shape (n,), membership included.
    """
    n = len(weights)
    if n == 0:
        return np.zeros(0)
    if index < 0:
        key, index = -key, -index
    beyond = logistic((key[None, :] - key[:, None]) / noise) * weights[None, :]
    np.fill_diagonal(beyond, 0.0)
    if index == 1:
        return np.asarray(weights * np.prod(1.0 - beyond, axis=1))
    counts = np.zeros((n, index))
    counts[:, 0] = 1.0
    for j in range(n):
        p = beyond[:, j][:, None]
        counts[:, 1:] = counts[:, 1:] * (1 - p) + counts[:, :-1] * p
        counts[:, :1] = counts[:, :1] * (1 - p)
    return np.asarray(weights * counts[:, index - 1])


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


def between(points: Array, first: Array, second: Array, edge: float) -> Array:
    """How well points (n, 2) lie between two others."""
    span = second - first
    length = float(np.linalg.norm(span))
    if length < 1e-6:
        return np.zeros(len(points))
    offset = points - first
    along = offset @ span / length**2
    across = np.abs(offset[:, 0] * span[1] - offset[:, 1] * span[0]) / length
    inside = logistic((along - 0.12) / 0.05) * logistic((0.88 - along) / 0.05)
    return np.asarray(inside * np.exp(-0.5 * (across / (0.2 * length + 0.35 * edge)) ** 2)
                      * np.exp(-length / (20 * edge)))  # fmt: skip


def side(scaled: Array, extent: Array) -> Array:
    """How well places count as on a side.

    Args:
        scaled: along the side's direction, 1 at the edge, shape (n,).
        extent: the same for those that are compared, whose extreme one is the best.
    """
    best = float(extent.max()) if len(extent) else 1.0
    return np.asarray(logistic((scaled - 0.1) / 0.12) * np.exp(1.2 * (scaled - best)))
