"""Places on the table or among what lies on it: sides, corners, edges, middles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from grounding.lexicon.degrees import gaussian, logistic
from grounding.lexicon.parameters import value
from grounding.lexicon.words import flat
from grounding.world import Array
from grounding.world.scene import Scene


@dataclass(frozen=True, eq=False)
class Spot:
    """A part of the table, with its directions as somebody sees them.

    Attributes:
        directions: unit vectors (2,) that lead to it; none for the middle.
        names: of the directions.
        middle: whether it is the middle, along what the directions leave free.
        corner: whether a corner is meant.
        outer: whether it is any corner, edge or end, as no direction was named.
        table: whether it is the table's, however little of it is filled.
    """

    directions: tuple[Array, ...] = ()
    names: tuple[str, ...] = ()
    middle: bool = False
    corner: bool = False
    outer: bool = False
    table: bool = False

    @property
    def upright(self) -> int:
        """Where it is in a stack: 1 for its top, -1 for its bottom, 0 for neither."""
        return 1 if "up" in self.names else -1 if "down" in self.names else 0


def make_spot(
    scene: Scene, names: tuple[str, ...], owner: str, *, middle: bool = False, corner: bool = False, rim: bool = False,
    table: bool = False,
) -> Spot:  # fmt: skip
    """A place from the names of directions as somebody sees them; `rim` for edges, ends and corners."""
    vectors = tuple(scene.direction(name, owner) for name in flat(names))
    return Spot(vectors, names, middle, corner or len(vectors) > 1, rim and not (vectors or middle), table)


def within(scene: Scene, spot: Spot) -> Array:
    """Positions within what a place is a part of, shape (n, 2): -1 and 1 are its edges."""
    return scene.on_whole_table if spot.table else scene.scaled


def closeness(scene: Scene, spot: Spot) -> Array:
    """How near every object is to a place, shape (n,): negative distances in [m], larger is nearer."""
    if not spot.directions:
        return np.asarray(-np.linalg.norm(scene.seen, axis=1))
    if len(spot.directions) == 1 and not spot.middle:
        return np.asarray(scene.xy @ spot.directions[0])
    centre, half = scene.box
    target = np.sum(spot.directions, axis=0) * half
    if spot.middle:
        return np.asarray(-np.linalg.norm(scene.seen - target, axis=1))
    return np.asarray(-np.linalg.norm(scene.xy - centre - target, axis=1))


def distances(scene: Scene, spot: Spot) -> Array:
    """How far every object is from a place, shape (n,) in half extents of what it is a part of."""
    if spot.outer:
        inside = np.maximum(1.0 - np.abs(within(scene, spot)), 0.0)
        return np.asarray(np.linalg.norm(inside, axis=1) if spot.corner else inside.min(axis=1))
    if not spot.directions:
        return np.asarray(np.linalg.norm(within(scene, spot), axis=1))
    vectors = np.array(spot.directions)
    offset = within(scene, spot) - vectors.sum(axis=0)
    if len(spot.directions) == 1 and spot.corner:  # one of the two corners of a side
        across = np.abs(np.abs(within(scene, spot) @ np.array([-vectors[0][1], vectors[0][0]])) - 1.0)
        return np.hypot(offset @ vectors[0], across)
    return np.asarray(np.linalg.norm(offset, axis=1))


def is_side(spot: Spot) -> bool:
    """Whether a place is all on one side of the middle, and no point."""
    return len(spot.directions) == 1 and not (spot.middle or spot.corner)


def truth(scene: Scene, spot: Spot) -> Array:
    """How well every object lies in a place, shape (n,)."""
    if is_side(spot):
        along = within(scene, spot) @ spot.directions[0]
        return logistic((along - value("place.side")) / value("place.side_blur"))
    away = distances(scene, spot)
    if spot.outer:
        return gaussian(away, value("place.rim"))
    if not spot.directions:
        return gaussian(np.maximum(away - value("place.side"), 0.0), value("place.middle"))
    return gaussian(away, value("place.corner"))


def preference(scene: Scene, spot: Spot, compared: np.ndarray) -> Array:
    """How much every object is preferred for lying deeper in a place than those it is compared with, shape (n,).

    Args:
        scene: the world.
        spot: the place.
        compared: the objects among which the best is looked for, boolean (n,).
    """
    if is_side(spot):
        along = within(scene, spot) @ spot.directions[0]
        return np.asarray(np.exp(value("place.side_pull") * np.minimum(along - along[compared].max(initial=-9.0), 0.0)))
    away = distances(scene, spot)
    return np.asarray(np.exp(-value("place.pull") * (away - away[compared].min(initial=9.0)).clip(0)))
