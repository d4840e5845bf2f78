"""Free space on a table: gaps between blocks, room for fingers, room for a block that is put down."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from grounding.corpus.sight import separation
from grounding.world import Array, WorldObject

EDGE = 0.05  # of all blocks in [m]
LEAST = 0.0115  # gap that motion needs between blocks that do not stand on each other, in [m]
FINGER = 0.02  # free width beside two opposite sides of a block that is grasped, in [m]
_SIGNS = np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]]) / 2


def yaw_of(item: WorldObject) -> float:
    """Turn of a block about z in [rad]."""
    return 2.0 * math.atan2(float(item.orientation[3]), float(item.orientation[0]))


def gap(place: Array, turn: float, other: WorldObject, size: tuple[float, float] = (EDGE, EDGE)) -> float:
    """Free space in [m] between a rectangle that may be laid and a block, seen from above; 0 where they overlap."""
    first, second = _axes(turn), _axes(yaw_of(other))
    corners = np.asarray(place)[:2] + (_SIGNS * size) @ first
    return separation(corners, other.position[:2] + (_SIGNS * other.size[:2]) @ second, first, second)


def level(item: WorldObject, other: WorldObject) -> bool:
    """Whether two blocks are on the same level."""
    return abs(float(item.position[2] - other.position[2])) < 0.5 * EDGE


def supports(lower: WorldObject, upper: WorldObject) -> bool:
    """Whether a block stands right on another."""
    near = float(np.linalg.norm(lower.position[:2] - upper.position[:2])) < EDGE / 2
    return near and abs(float(upper.position[2] - lower.position[2]) - EDGE) < 0.1 * EDGE


def uncovered(item: WorldObject, items: Iterable[WorldObject]) -> bool:
    """Whether nothing stands on a block."""
    return not any(supports(item, other) for other in items if other is not item)


def graspable(item: WorldObject, items: Iterable[WorldObject]) -> bool:
    """Whether fingers find room on two opposite sides of a block that nothing stands on."""
    others = [other for other in items if other is not item]
    beside = [other for other in others if level(item, other)]
    if not uncovered(item, others):
        return False
    wide = (EDGE + 2 * FINGER, 0.6 * EDGE)
    return any(
        all(gap(item.position, yaw_of(item) + turn, other, wide) > 0.0 for other in beside)
        for turn in (0.0, math.pi / 2)
    )


def apart(items: Iterable[WorldObject], least: float = LEAST) -> bool:
    """Whether all blocks of a level keep a gap from each other."""
    listed = list(items)
    return all(
        gap(one.position, yaw_of(one), other) >= least
        for number, one in enumerate(listed)
        for other in listed[:number]
        if level(one, other)
    )


def _axes(turn: float) -> Array:
    return np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
