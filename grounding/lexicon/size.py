"""Sizes of single things, where these differ: the biggest, the tall one, from their boxes."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.vocabulary import vocabulary
from grounding.world import Array
from grounding.world.scene import Scene

_DIFFERENT = 1.2
"""Things whose volumes differ by this factor are of different sizes."""


def vary(scene: Scene) -> bool:
    """Whether there are things of different sizes, so that words for sizes tell them apart."""
    sizes = np.array([np.prod(item.size) for item in scene.layout.things])
    return bool(len(sizes)) and float(sizes.max()) > _DIFFERENT * float(sizes.min())


def measure(scene: Scene, word: str) -> Array:
    """What a word for a size compares, shape (n,) in [m]: heights of "tall", lengths of "long", edges of "big"."""
    extents = np.array([2 * item.half_extents for item in scene.layout.things]).reshape(-1, 3)
    along = vocabulary().value("dimension", word)
    if along == "height":
        return np.asarray(extents[:, 2])
    if along == "length":
        return np.asarray(extents[:, :2].max(axis=1))
    return np.asarray(np.cbrt(extents.prod(axis=1)))
