"""Checks of a goal before anything is planned: a start within range, a destination free and supported."""

from __future__ import annotations

from numbers import Real

import numpy as np
from numpy.typing import ArrayLike

from motion.errors import InvalidGoal
from motion.polygons import contains, overlap
from motion.poses import Array, Pose, about
from motion.robot.load import load_robot
from motion.robot.state import ARMS, RobotState
from motion.scene import Box, Scene, standing

HEIGHT_TOLERANCE = 0.004
"""Largest gap between a destination's height and resting on what is below, metres."""
_TOUCHING = 0.0005
_BEYOND = 0.02


def checked_start(state: RobotState) -> RobotState:
    """The state that a plan begins with.

    Raises:
        InvalidGoal: a joint is beyond the end of its range.
    """
    for arm in ARMS:
        data = load_robot().arm(arm)
        beyond = np.maximum(data.lower - state.joints(arm), state.joints(arm) - data.upper)
        worst = int(np.argmax(beyond))
        if beyond[worst] > _BEYOND:
            raise InvalidGoal(
                f"a plan cannot begin with {data.joints[worst]} at {state.joints(arm)[worst]:.3f} rad; its range is "
                f"{data.lower[worst]:.3f} to {data.upper[worst]:.3f}"
            )
    return state


def checked_lift(lift: float) -> float:
    """Checks how far a box is to be lifted.

    Raises:
        InvalidGoal: it is no finite number above 0.
    """
    if not (isinstance(lift, Real) and np.isfinite(lift) and lift > 0):
        raise InvalidGoal(f"a box is lifted by a finite number of metres above 0, not by {lift!r}")
    return float(lift)


def positions(name: str, position: ArrayLike) -> Array:
    """One place or several as (n, 3), metres.

    Raises:
        InvalidGoal: they are neither (3,) nor (n, 3) numbers, or there is none.
    """
    try:
        points = np.asarray(position, dtype=np.float64)
    except (TypeError, ValueError):
        points = np.empty(0)
    if points.shape == (3,):
        return points[None]
    if points.ndim == 2 and points.shape[1] == 3 and len(points):
        return points
    raise InvalidGoal(
        f"the destination of {name!r} must be three finite numbers, or rows of three, not {_told(position)}", name
    )


def turned(box: Box, position: Array, turn: float) -> Box:
    """The box at `position`, standing on a face, turned by `turn` radians about the vertical."""
    return box.at(Pose.of(about((0, 0, 1), turn) @ standing(box).axes, position))


def heading(box: Box) -> float:
    """Direction in (-pi, pi] of the box's first level edge, seen from above, radians."""
    level = [i for i in range(3) if abs(box.axes[2, i]) < 0.7]
    x, y = box.axes[:2, level[0]]
    return float(np.arctan2(y, x))


def checked_destination(scene: Scene, name: str, position: ArrayLike, turn: float) -> tuple[Box, str]:
    """The box at its destination, lowered or raised until it rests, and the name of what it will rest on.

    Args:
        scene: where everything is.
        name: the box to be put down; where it is now does not count as occupied.
        position: (3,) where its centre shall be, metres.
        turn: by how much it is turned about the vertical on the way, radians.

    Raises:
        InvalidGoal: the destination is not finite, occupied, without support, or too near the edge of its support.
    """
    try:
        point = np.asarray(position, dtype=np.float64)
    except (TypeError, ValueError):
        point = np.empty(0)
    if point.shape != (3,) or not np.all(np.isfinite(point)) or not np.isfinite(turn):
        raise InvalidGoal(
            f"the destination of {name!r} must be three finite numbers and a finite yaw, not {_told(position)} and "
            f"{turn}",
            name,
        )
    goal = turned(scene.box(name), point, turn)
    below: Box | None = None
    for other in scene.boxes:
        if other.name == name or _apart(goal, other) or overlap(goal.footprint, other.footprint) <= _TOUCHING:
            continue
        if other.top > goal.bottom + HEIGHT_TOLERANCE and other.bottom < goal.top - _TOUCHING:
            raise InvalidGoal(
                f"the destination {_at(point)} of {name!r} is occupied by {other.name!r}, which reaches up to "
                f"z = {other.top:.3f}; a free place or the top of a box is needed",
                name,
            )
        if other.top <= goal.bottom + HEIGHT_TOLERANCE and (below is None or other.top > below.top):
            below = other
    if below is None:
        raise InvalidGoal(f"the destination {_at(point)} of {name!r} is off the table: nothing is below it", name)
    gap = goal.bottom - below.top
    if gap > HEIGHT_TOLERANCE:
        raise InvalidGoal(
            f"at {_at(point)} {name!r} would hang {1000 * gap:.0f} mm above {below.name!r}; its centre must be at "
            f"z = {point[2] - gap:.4f} to rest there",
            name,
        )
    if not contains(below.footprint, point[:2], margin=0.005):
        raise InvalidGoal(
            f"at {_at(point)} {name!r} would tip off {below.name!r}: its centre must be at least 5 mm inside the edge",
            name,
        )
    return goal.at(Pose(point - [0, 0, gap], goal.orientation)), below.name


def _apart(first: Box, second: Box) -> bool:
    """Tells whether the upright boxes around both are apart, seen from above."""
    return bool(np.any(np.abs(first.position - second.position)[:2] > (first.half_extents + second.half_extents)[:2]))


def _told(position: ArrayLike) -> str:
    return str(position.tolist() if isinstance(position, np.ndarray) else position)


def _at(point: Array) -> str:
    return f"({point[0]:.3f}, {point[1]:.3f}, {point[2]:.3f})"
