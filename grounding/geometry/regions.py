"""Which objects lie in a region: left, right, front, back, on, under, beside, between, amid reference objects."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.errors import SymbolError
from grounding.world import FURNITURE, Array, WorldObject

BESIDE = 1.1  # "next to": the gap between the boxes is at most so many edges
CONE = 1.0  # a direction holds what deviates sideways by at most so much of its distance, beyond the reference's width

_AXES = {"left": (1, 1.0), "right": (1, -1.0), "back": (0, 1.0), "front": (0, -1.0)}


def in_any_region(relation: str, references: Sequence[WorldObject], things: Sequence[WorldObject]) -> np.ndarray:
    """Which things lie in the region of one at least of several objects: shape (len(things),)."""
    inside = np.zeros(len(things), dtype=bool)
    for reference in references:
        inside |= in_region(relation, [reference], things) & np.array([item is not reference for item in things])
    return inside


def in_region(relation: str, reference: Sequence[WorldObject], things: Sequence[WorldObject]) -> np.ndarray:
    """Which things lie in a region.

    Args:
        relation: a spatial reference.
        reference: the objects that the region is of; a table's regions are its halves.
        things: the objects asked about.

    Returns:
        booleans, shape (len(things),); all True without reference (the robot itself: everything is before it).
    """
    if not things:
        return np.zeros(0, dtype=bool)
    if not reference:
        return np.ones(len(things), dtype=bool)
    points = np.array([item.position for item in things])
    halves = np.array([item.half_extents for item in things])
    low = np.min([item.position - item.half_extents for item in reference], axis=0)
    high = np.max([item.position + item.half_extents for item in reference], axis=0)
    centre = (low + high) / 2
    furniture = all(item.type in FURNITURE for item in reference)
    if relation in _AXES:
        axis, sign = _AXES[relation]
        if furniture:
            return np.asarray(sign * (points[:, axis] - centre[axis]) > 0)
        return _directed(points, halves, low, high, axis, sign)
    overlap = np.all((points[:, :2] + halves[:, :2] > low[:2]) & (points[:, :2] - halves[:, :2] < high[:2]), axis=1)
    if relation == "top":
        return np.asarray(overlap & (points[:, 2] > high[2] - 0.1 * halves[:, 2]))
    if relation == "bottom":
        return np.asarray(overlap & (points[:, 2] < low[2] + 0.1 * halves[:, 2]))
    if relation == "near":
        gap = np.linalg.norm(np.maximum(0.0, np.maximum(low - (points + halves), points - halves - high)), axis=1)
        return np.asarray(gap <= BESIDE * 2 * halves.mean(axis=1))
    if relation == "between":
        return _between(points, reference)
    if relation == "center":
        reach = np.maximum((high - low)[:2] / 4, halves[:, :2])
        return np.asarray(np.all(np.abs(points[:, :2] - centre[:2]) <= reach, axis=1))
    if relation == "far":
        return np.ones(len(things), dtype=bool)
    raise SymbolError(f"no region is defined for {relation!r}")


def _directed(points: Array, halves: Array, low: Array, high: Array, axis: int, sign: float) -> np.ndarray:
    other = 1 - axis
    bound = high[axis] if sign > 0 else -low[axis]
    ahead = sign * points[:, axis] - bound
    beside = np.maximum(0.0, np.maximum(low[other] - points[:, other], points[:, other] - high[other]))
    width = halves[:, other]
    return np.asarray((ahead > 0) & (beside <= CONE * np.maximum(ahead, width)))


def _between(points: Array, reference: Sequence[WorldObject]) -> np.ndarray:
    if len(reference) < 2:
        return np.zeros(len(points), dtype=bool)
    ends = np.array([item.position[:2] for item in reference])
    if len(ends) > 2:  # amid several: within their bounds
        return np.asarray(np.all((points[:, :2] > ends.min(axis=0)) & (points[:, :2] < ends.max(axis=0)), axis=1))
    span = ends[1] - ends[0]
    length = float(np.linalg.norm(span))
    if length < 1e-6:
        return np.zeros(len(points), dtype=bool)
    offset = points[:, :2] - ends[0]
    along = offset @ span / length**2
    across = np.abs(offset[:, 0] * span[1] - offset[:, 1] * span[0]) / length
    return np.asarray((along > 0.1) & (along < 0.9) & (across <= 0.25 * length))
