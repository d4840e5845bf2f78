"""Degrees in [0, 1]: how they rise and fade, and how likely something is the n-th of an uncertain set."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.parameters import value
from grounding.world import Array


def logistic(values: Array) -> Array:
    """1 / (1 + exp(-x)), without overflow."""
    return np.asarray(0.5 * (1.0 + np.tanh(0.5 * values)))


def gaussian(values: Array, width: float | Array) -> Array:
    """exp(-x² / 2 s²)."""
    return np.asarray(np.exp(-0.5 * np.square(values / width)))


def softened(held: Array) -> Array:
    """A degree that leaves `answer.floor` where it does not hold: words and eyes err."""
    floor = value("answer.floor")
    return np.asarray(floor + (1 - floor) * held)


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
    return np.asarray(weights * counting(beyond, index)[:, index - 1])


def counting(chances: Array, most: int) -> Array:
    """How likely so many of independent coins fall right, by rows: shape (n, most) for counts 0 to most - 1.

    Args:
        chances: of every coin, shape (n, m).
        most: counts below this are told.
    """
    if not chances.shape[1]:
        return np.eye(1, most).repeat(len(chances), axis=0)
    counts = [1.0 - chances, chances][:most]
    while counts[0].shape[1] > 1:  # halves the coins by taking two and two together
        odd = [count[:, -1:] for count in counts] if counts[0].shape[1] % 2 else []
        even, other = [c[:, 0 : c.shape[1] & ~1 : 2] for c in counts], [c[:, 1::2] for c in counts]
        taken = [_convolved(even, other, k) for k in range(min(2 * len(counts) - 1, most))]
        counts = [np.hstack([c, _of(odd, k, c)]) if odd else c for k, c in enumerate(taken)]
    found = np.zeros((len(chances), most))
    for k, count in enumerate(counts):
        found[:, k] = count[:, 0]
    return found


def _convolved(one: list[Array], other: list[Array], k: int) -> Array:
    pairs = range(max(0, k - len(other) + 1), min(k, len(one) - 1) + 1)
    return np.asarray(sum(one[i] * other[k - i] for i in pairs))


def _of(counts: list[Array], k: int, like: Array) -> Array:
    return counts[k] if k < len(counts) else np.zeros((len(like), 1))


def at_least(chances: Array, count: int) -> Array:
    """How likely at least so many of independent coins fall right, by rows of an array (n, m)."""
    if count <= 0:
        return np.ones(len(chances))
    return np.asarray(1.0 - counting(chances, count).sum(axis=1))
