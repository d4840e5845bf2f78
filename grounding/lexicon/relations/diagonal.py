"""Diagonal from something: as far to the side of it as before or behind it."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.degrees import gaussian, logistic
from grounding.lexicon.direction import preference as nearer
from grounding.lexicon.parameters import value
from grounding.lexicon.where import Where
from grounding.world import Array
from grounding.world.scene import Scene

SAID = "diagonal from"
_OFF = np.pi / 10  # what is farther from the diagonal than a third of the way to an axis is rather not on it


def truth(where: Where, scene: Scene) -> Array:
    """How well places lie diagonally from objects, shape (m, n)."""
    offset = np.abs(where.xy[:, None] - scene.xy[None])
    off = np.abs(np.arctan2(offset[..., 1], offset[..., 0]) - np.pi / 4)
    apart = logistic((offset.min(axis=2) / scene.edge - value("direction.ahead")) / value("direction.ahead_blur"))
    return np.asarray(gaussian(off, _OFF) * apart)


def preference(where: Where, scene: Scene) -> Array:
    """How much the next one is preferred, shape (m, n)."""
    return nearer(where.gaps, scene.edge)
