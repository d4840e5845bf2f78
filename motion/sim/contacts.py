"""Contacts in a simulation: pairs of bodies, boxes between the fingers, and pairs that were not meant to touch."""

from __future__ import annotations

from typing import Any

import numpy as np

from motion.collision.scene_model import SceneModel
from motion.poses import Array

TOUCHING = 1e-4
"""Gap in metres up to which two geoms touch."""

Pair = tuple[str, str]


def touching_pairs(indices: SceneModel, data: Any) -> tuple[Pair, ...]:
    """Pairs of bodies that touch, sorted; a body is a box, a link of the robot, or "floor"."""
    return tuple(sorted({_pair(indices, *geoms) for geoms in _touching(data)}))


def between_fingers(indices: SceneModel, data: Any, arm: str) -> tuple[str, ...]:
    """Names of the loose boxes that both fingers of an arm touch."""
    geoms = _touching(data)
    names: list[set[str]] = []
    for finger in indices.finger_geoms[arm]:
        others = np.concatenate([geoms[finger[geoms[:, 0]], 1], geoms[finger[geoms[:, 1]], 0]])
        names.append({indices.bodies[geom] for geom in others})
    return tuple(sorted(name for name in names[0] & names[1] if name in indices.box_qpos))


def unintended_pairs(indices: SceneModel, data: Any, arm: str, target: str | None) -> set[Pair]:
    """Pairs with the robot in them that a plan does not mean to touch.

    The hand may touch itself and its target, and boxes may touch one another.

    Args:
        indices: the scene's model and where things are in it.
        data: MjData of the model.
        arm: the arm that moves.
        target: name of the box it handles, or None.
    """
    geoms = data.contact.geom
    if len(geoms) == 0:
        return set()
    robot, hand = indices.robot_geoms, indices.hand_geoms[arm]
    found = set()
    for first, second in geoms[np.any(robot[geoms], axis=1)]:
        if robot[first] and robot[second]:
            meant = bool(hand[first] and hand[second])
        else:
            link, other = (first, second) if robot[first] else (second, first)
            meant = indices.bodies[other] == target and bool(hand[link])
        if not meant:
            found.add(_pair(indices, first, second))
    return found


def _touching(data: Any) -> Array:
    """(n, 2) geoms that touch."""
    geoms: Array = data.contact.geom[np.asarray(data.contact.dist) <= TOUCHING]
    return geoms


def _pair(indices: SceneModel, first: int, second: int) -> Pair:
    names = indices.bodies[first], indices.bodies[second]
    return min(names), max(names)
