"""Which objects were handled before: "the same block", "another one"."""

from __future__ import annotations

import numpy as np

from grounding.meaning.nouns import Noun
from grounding.world import Array

OTHER_KIND = 0.15  # who says "the other one" without a colour mostly means another one of the same colour


def latest(history: tuple[int, ...], base: Array) -> Array:
    """The object that was handled last among those that a noun's own words allow, weights (n,).

    Args:
        history: indices, the latest last.
        base: how well every object agrees with the noun's words, shape (n,).
    """
    weights = np.zeros(len(base))
    if history:
        weights[next((i for i in reversed(history) if base[i] > 0), history[-1])] = 1.0
    return weights


def others(history: tuple[int, ...], colors: tuple[str, ...], noun: Noun) -> Array:
    """How well every object is "the other one", or "another one", weights (n,).

    Args:
        history: indices, the latest last; at least one.
        colors: of all objects.
        noun: that says so.
    """
    handled = history[-1]
    weights = np.array([1.0 if noun.colors or color == colors[handled] else OTHER_KIND for color in colors])
    if not any(color == colors[handled] for i, color in enumerate(colors) if i != handled):
        weights[:] = 1.0
    weights[handled] = 0.0
    return weights
