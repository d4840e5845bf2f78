"""Where objects are for somebody who looks at them: how far, in front, beside."""

from __future__ import annotations

import numpy as np

from grounding.graded.places import in_place, make_place
from grounding.graded.values import Restriction
from grounding.world import Array
from grounding.world.scene import Scene


def distance_from(scene: Scene, agent: str) -> Array:
    """How far every object is from somebody [m], shape (n,); sideways counts a little less."""
    offset = scene.xy - scene.viewpoint(agent).position[:2]
    return np.asarray(np.hypot(offset[:, 0], 0.8 * offset[:, 1]))


def before(scene: Scene, agent: str, names: tuple[str, ...]) -> Restriction:
    """Before or beside somebody: "in front of you", "to the left of you"."""
    if "front" in names or "back" in names:
        offset = scene.xy - scene.viewpoint(agent).position[:2]
        ahead = scene.direction("back", agent)
        along = offset @ ahead
        side = np.abs(offset[:, 0] * ahead[1] - offset[:, 1] * ahead[0])
        centred = np.exp(-0.5 * (side / (2.0 * scene.edge)) ** 2)
        near = np.exp(-(along - along.min(initial=np.inf)) / (4 * scene.edge)) if scene.n else along
        return Restriction(np.asarray(centred * near), preferred=True)
    return Restriction(in_place(scene, make_place(scene, names, agent, bare=True), np.ones(scene.n)))
