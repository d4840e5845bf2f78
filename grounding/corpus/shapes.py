"""Whether objects form the container that somebody says they do: not detection, a test of one given set."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from grounding.world import Array, WorldObject

LINE_DEVIATION = 1.1  # largest root mean square distance from a line, in edges: people call uneven lines rows
LINE_ANGLE = np.deg2rad(50)  # largest angle between a line and the axis that its kind is named after
CIRCLE_DEVIATION = 0.5  # largest root mean square distance from a circle, in edges
REST = 0.005  # largest gap between a block of a tower and the one below, in [m]
LEAST = {"row": 2, "column": 2, "group": 2, "circle": 4, "tower": 2, "robot": 1}  # members of each kind


def misfit(kind: str, objects: Sequence[WorldObject]) -> str | None:
    """What is wrong with objects as a container of a kind, or None where nothing is.

    Args:
        kind: row (along y), column (along x), circle, tower, group or robot.
        objects: its members, in any order.
    """
    if len(objects) < LEAST[kind]:
        return f"a {kind} has at least {LEAST[kind]} members, not {len(objects)}"
    if (kind == "robot") != all(item.type == "robot" for item in objects):
        return f"a {kind} is made of {'hands' if kind == 'robot' else 'objects, not of hands'}"
    if kind == "tower":
        return _tower_misfit(objects)
    points = np.array([item.position[:2] for item in objects])
    edge = float(np.median([item.size.min() for item in objects]))
    if kind in ("row", "column"):
        return _line_misfit(kind, points, edge)
    if kind == "circle":
        deviation = circle_deviation(points) / edge
        return None if deviation <= CIRCLE_DEVIATION else f"{deviation:.2f} edges off a circle (rms)"
    return None


def line_fit(points: Array) -> tuple[float, float]:
    """The line through (n, 2) points: root mean square distance from it in [m] and its angle from x, 0 to pi/2."""
    centred = points - points.mean(axis=0)
    _, singular, axes = np.linalg.svd(centred, full_matrices=False)
    deviation = singular[1] / np.sqrt(len(points)) if len(singular) > 1 else 0.0
    return float(deviation), float(np.arctan2(abs(axes[0, 1]), abs(axes[0, 0])))


def circle_deviation(points: Array) -> float:
    """Root mean square distance in [m] of (n, 2) points from the circle fitted to them (Kåsa's least squares)."""
    centred = points - points.mean(axis=0)
    system = np.column_stack([2 * centred, np.ones(len(points))])
    (x, y, c), *_ = np.linalg.lstsq(system, (centred**2).sum(axis=1), rcond=None)
    radius = np.sqrt(max(c + x * x + y * y, 0.0))
    return float(np.sqrt(np.mean((np.hypot(centred[:, 0] - x, centred[:, 1] - y) - radius) ** 2)))


def _line_misfit(kind: str, points: Array, edge: float) -> str | None:
    deviation, angle = line_fit(points)
    if deviation / edge > LINE_DEVIATION:
        return f"{deviation / edge:.2f} edges off a line (rms)"
    lean = np.pi / 2 - angle if kind == "row" else angle
    if lean > LINE_ANGLE:
        axis = "y" if kind == "row" else "x"
        return f"lies {np.degrees(lean):.0f} degrees from {axis}, the axis of a {kind}"
    return None


def _tower_misfit(objects: Sequence[WorldObject]) -> str | None:
    ordered = sorted(objects, key=lambda item: float(item.position[2]))
    for lower, upper in pairwise(ordered):
        gap = upper.position[2] - upper.half_extents[2] - lower.position[2] - lower.half_extents[2]
        aside = np.abs(upper.position[:2] - lower.position[:2]).max()
        if abs(gap) > REST or aside > lower.size.min() / 2:
            return f"{upper.id!r} does not rest on {lower.id!r} (gap {gap:.3f} m, {aside:.3f} m aside)"
    return None
