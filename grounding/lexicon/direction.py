"""Directions from something: left of it, behind it, above it."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.degrees import gaussian, logistic
from grounding.lexicon.parameters import value
from grounding.lexicon.where import Where
from grounding.lexicon.words import flat
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene


def unit(scene: Scene, names: tuple[str, ...], owner: str = ROBOT) -> Array | None:
    """The unit vector (2,) of directions taken together, as somebody sees them; None where they cancel out."""
    vectors = [scene.direction(name, owner) for name in flat(names)]
    total = np.sum(vectors, axis=0) if vectors else np.zeros(2)
    length = float(np.linalg.norm(total))
    return None if length < 1e-6 else np.asarray(total / length)


def truth(
    where: Where, references: Array, edge: float, vector: Array, *, strict: bool = False
) -> Array:
    """How well places lie in a direction of references: ahead, and little to the side, shape (m, r).

    Args:
        where: the places.
        references: points, shape (r, 2) in [m].
        edge: of a block [m].
        vector: unit vector (2,).
        strict: "directly": little to the side counts more.
    """
    offset = where.xy[:, None] - references[None]
    ahead = offset @ vector
    side = np.abs(offset[..., 0] * vector[1] - offset[..., 1] * vector[0])
    return _directed(ahead, side, edge, strict=strict)


def truth_of_set(where: Where, members: Array, edge: float, vector: Array, *, strict: bool = False) -> Array:
    """How well places lie in a direction of several things together, beyond all of them, shape (m,).

    Args:
        where: the places.
        members: their points, shape (k, 2) in [m].
        edge: of a block [m].
        vector: unit vector (2,).
        strict: "directly": little to the side counts more.
    """
    across = np.array([-vector[1], vector[0]])
    ahead = where.xy @ vector - float((members @ vector).max())
    sideways = where.xy @ across
    low, high = float((members @ across).min()), float((members @ across).max())
    side = np.maximum(np.maximum(low - sideways, sideways - high), 0.0)
    return _directed(ahead, side, edge, strict=strict)


def _directed(ahead: Array, side: Array, edge: float, *, strict: bool) -> Array:
    name = "direction.strict_" if strict else "direction."
    tolerance = value(name + "spread") * np.maximum(ahead, 0.0) + value(name + "width") * edge
    beyond = logistic((ahead / edge - value("direction.ahead")) / value("direction.ahead_blur"))
    return np.asarray(beyond * gaussian(side, tolerance))


def preference(gaps: Array, edge: float, *, strict: bool = False) -> Array:
    """How much the next one in a direction is preferred to those farther away, by gaps of any shape in [m]."""
    decay = value("direction.strict_decay" if strict else "direction.decay")
    return np.asarray(np.exp(-gaps / (decay * edge)))


def vertical(where: Where, scene: Scene, sign: float) -> Array:
    """How well places are on top of objects, or under them where the sign is negative, shape (m, n)."""
    over = np.linalg.norm(where.xy[:, None] - scene.xy[None], axis=2) < 0.5 * scene.edge
    step = sign * (where.z[:, None] - scene.z[None]) / scene.edge
    return np.where(over & (step > 0.5), np.exp(-0.3 * np.maximum(step - 1, 0)), 0.0)
