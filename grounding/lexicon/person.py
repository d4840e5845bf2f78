"""Where objects are for somebody who looks at them: how far, and how much before them."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.degrees import gaussian
from grounding.lexicon.parameters import value
from grounding.world import Array
from grounding.world.scene import Scene


def distance_from(scene: Scene, owner: str) -> Array:
    """How far every object is from somebody [m], shape (n,); sideways counts a little less."""
    offset = scene.xy - scene.viewpoint(owner).position[:2]
    along, across = offset @ scene.direction("back", owner), offset @ scene.direction("left", owner)
    return np.asarray(np.hypot(along, value("rank.sideways") * across))


def before(scene: Scene, owner: str, xy: Array | None = None) -> Array:
    """How much things are straight before somebody and near: "in front of you".

    Args:
        scene: the world.
        owner: who looks.
        xy: where they are, shape (m, 2) in [m]; all objects where nothing is said.

    Returns:
        shape (m,), 1 for the best that is straight ahead.
    """
    points = scene.xy if xy is None else xy
    if not len(points):
        return np.zeros(0)
    offset = points - scene.viewpoint(owner).position[:2]
    ahead = scene.direction("back", owner)
    along = offset @ ahead
    side = np.abs(offset[:, 0] * ahead[1] - offset[:, 1] * ahead[0])
    near = np.exp(-(along - along.min()) / (value("person.near") * scene.edge))
    return np.asarray(gaussian(side, value("person.centred") * scene.edge) * near)
