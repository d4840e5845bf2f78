"""Candidate grasps of a box: which faces the paddles close on, from which side, how far tilted, with which hand.

The tool's z axis points from the palm to the fingertips, its y axis along the closing. A box may lie on any face: the
closing axis is an edge of the box that is nearly horizontal, the approach comes from above, tilted about the closing
axis.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from motion.errors import InvalidGoal
from motion.poses import Array, Pose, about
from motion.recipe import recipe
from motion.scene import Box, Scene
from motion.state import ARMS

TILTS = (0.0, 0.17, -0.17, 0.35, -0.35, 0.52, -0.52)
"""Angles of the approach from the vertical about the closing axis, radians (up to 30 degrees)."""

_PAD_HALF_WIDTH = 0.021
_PAD_DEPTH = 0.0035
_FINGER_HALF_WIDTH = 0.005
_FINGER_DEPTH = 0.00515
_TIP_CLEARANCE = 0.004
_DEEPEST = 0.010
_OPENING_ROOM = 0.007
_NARROW_ROOM = 0.003
_LEAST_ROOM = 0.002
_LEVEL = 0.26


@dataclass(frozen=True, eq=False)
class Grasp:
    """One way to take a box.

    Attributes:
        arm: "left" or "right".
        box: name of the box.
        tool: pose of the tool frame at the grasp.
        tilt: angle of the approach from the vertical about the closing axis, radians.
        width: extent of the box along the closing axis, metres.
        opening: opening of the gripper before it closes, metres.
        cost: what the ranking goes by; lower is better.
    """

    arm: str
    box: str
    tool: Pose
    tilt: float
    width: float
    opening: float
    cost: float

    def narrowed(self) -> Grasp:
        """The same grasp with the fingers opened less, for where neighbours are close."""
        return replace(self, opening=min(self.opening, self.width + 2 * _NARROW_ROOM))

    def backed(self, distance: float) -> Pose:
        """The tool's pose `distance` metres back along the approach."""
        return Pose(self.tool.position - distance * self.tool.rotation[:, 2], self.tool.orientation)


def grasp_candidates(scene: Scene, name: str, arms: tuple[str, ...] = ARMS) -> list[Grasp]:
    """All grasps of a box that fit the gripper's opening, best first; neighbours and reach are the planner's to check.

    Args:
        scene: what stands around the robot.
        name: the box to grasp.
        arms: the hands to consider.

    Raises:
        UnknownBody: there is no such box.
        InvalidGoal: the box is fixed, or no two opposite faces fit between the paddles.
    """
    box = scene.box(name)
    if box.fixed:
        raise InvalidGoal(f"{name!r} is fixed and cannot be grasped; only loose boxes can", name)
    gripper = recipe().gripper
    widest = gripper.opened - _LEAST_ROOM
    axes = [i for i in range(3) if abs(box.axes[2, i]) < np.sin(_LEVEL)]
    fitting = [i for i in axes if gripper.closed + 0.002 <= box.size[i] <= widest]
    if not fitting:
        widths = ", ".join(f"{1000 * box.size[i]:.0f}" for i in axes) or "none"
        raise InvalidGoal(
            f"{name!r} cannot be grasped: its extents along level axes are {widths} mm, and the gripper takes "
            f"{1000 * gripper.closed + 2:.0f} to {1000 * widest:.1f} mm",
            name,
        )
    grasps = [grasp for arm in arms for axis in fitting for grasp in _about_axis(box, axis, arm)]
    return sorted(grasps, key=lambda grasp: grasp.cost)


def _about_axis(box: Box, axis: int, arm: str) -> Iterator[Grasp]:
    closing = box.axes[:, axis].copy()
    closing[2] = 0.0
    closing /= np.linalg.norm(closing)
    width = float(box.size[axis])
    for sign in (1.0, -1.0):
        y = sign * closing
        z = np.array([0.0, 0.0, -1.0])
        level = np.column_stack([np.cross(y, z), y, z])
        for tilt in TILTS:
            rotation = about(y, tilt) @ level
            depth = _depth(box, abs(tilt))
            if depth is None:
                continue
            tool = Pose.of(rotation, box.position + depth * rotation[:, 2])
            opening = min(recipe().gripper.opened, width + 2 * _OPENING_ROOM)
            yield Grasp(arm, box.name, tool, tilt, width, opening, _cost(box, arm, rotation, tilt))


def _depth(box: Box, tilt: float) -> float | None:
    """How far the tool frame goes past the box's centre, so that the fingertips stay above what the box stands on."""
    half = float(box.half_extents[2])
    low = half - _TIP_CLEARANCE
    pads = (low - _PAD_HALF_WIDTH * np.sin(tilt)) / np.cos(tilt) - _PAD_DEPTH
    fingers = (low - _FINGER_HALF_WIDTH * np.sin(tilt)) / np.cos(tilt) - _FINGER_DEPTH
    depth = float(min(pads, fingers, _DEEPEST))
    return depth if depth > -half / 2 else None


def _cost(box: Box, arm: str, rotation: Array, tilt: float) -> float:
    """Prefers the hand on the box's side, a hand that points down, and a wrist turned little from home."""
    side = 1.0 if arm == "left" else -1.0
    across = max(0.0, 0.05 - side * float(box.position[1]))
    turn = float(np.arccos(np.clip(-rotation[0, 0], -1, 1)))
    return 4.0 * across + 0.6 * abs(tilt) + 0.25 * turn
