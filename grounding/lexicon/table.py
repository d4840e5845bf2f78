"""Tables, of which a world may have several: which one is meant, and what stands on it."""

from __future__ import annotations

import numpy as np

from grounding.lexicon import shades
from grounding.lexicon.words import flat
from grounding.world import Array, WorldObject
from grounding.world.scene import ROBOT, Scene


def tables(scene: Scene) -> tuple[WorldObject, ...]:
    """The tables of a world, in the order of its file."""
    return tuple(item for item in scene.layout.world.objects if item.type == "table")


def meant(
    scene: Scene, colours: tuple[str, ...] = (), names: tuple[str, ...] = (), owner: str = ROBOT, without: int = -1
) -> np.ndarray:
    """Which tables words may mean, boolean (t,).

    Args:
        scene: the world.
        colours: that were said.
        names: of directions: "the left table" is the leftmost one.
        owner: whose directions.
        without: index of the one that "the other" is not, -1 for none.
    """
    found = tables(scene)
    fits = np.array([not colours or shades.name_of(item.color) in colours for item in found], dtype=bool)
    if 0 <= without < len(found):
        fits[without] = False
    for name in flat(names):
        along = np.array([item.position[:2] @ scene.direction(name, owner) for item in found])
        fits &= along >= along[fits].max(initial=-np.inf) - 0.5 * scene.edge
    return fits


def under(scene: Scene, points: Array) -> np.ndarray:
    """The index of the table under each point, -1 where there is none, shape (m,).

    Args:
        scene: the world.
        points: shape (m, 2) in [m].
    """
    found = np.full(len(points), -1)
    for index, item in reversed(tuple(enumerate(tables(scene)))):
        inside = np.all(np.abs(points - item.position[:2]) <= item.half_extents[:2] + 1e-9, axis=1)
        found[inside] = index
    return found
