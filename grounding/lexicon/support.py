"""What something can stand on: what has a flat top and carries nothing."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.kind import kind_of
from grounding.lexicon.vocabulary import vocabulary
from grounding.world.scene import Scene


def flat(scene: Scene) -> np.ndarray:
    """What has a flat top, shape (n,): not what is pointed or round."""
    table = vocabulary()
    return np.array([not table.has("pointed", str(kind_of(item.type))) for item in scene.layout.things], dtype=bool)


def bare(scene: Scene, without: int = -1) -> np.ndarray:
    """What something can be put on, shape (n,).

    Args:
        scene: the world.
        without: index of what is taken away first, so that what is right below it carries nothing; -1 for nothing.
    """
    found = scene.clear & flat(scene)
    for tower in scene.towers:
        if tower[-1] == without:
            found[tower[-2]] = True
    return found
