"""Candidate grasps of a box: which faces the paddles close on, from which side, how far tilted, with which hand.

Where a neighbour is in the fingers' way the hand opens less, or takes the box nearer to one end of its faces; where
that does not help either, the grasp is left out.

The tool's z axis points from the palm to the fingertips, its y axis along the closing. A box may lie on any face: the
closing axis is an edge of the box that is nearly horizontal, the approach comes from above, tilted about the closing
axis.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from motion.errors import GraspUnavailable, InvalidGoal
from motion.grasp.fingers import Pair, obstacles
from motion.poses import Pose
from motion.robot.recipe import recipe
from motion.robot.state import ARMS
from motion.scene import Box, Scene

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
_FINGERS_REACH = 0.14
_FINGER_ON_FACE = 0.009
_FARTHEST_ASIDE = 0.016
_ASIDE_COST = 0.8


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
    """All grasps of a box that fit the gripper's opening and leave its neighbours alone, best first.

    For each pair of opposite faces that are level apart and 18 to 55.7 mm wide: both turns of the hand, tilted about
    the closing axis by each of `TILTS`, with either hand. Reach is for `solve_ik` or `reach_box` to find out.

    Args:
        scene: what stands around the robot.
        name: the box to grasp.
        arms: the hands to consider.

    Raises:
        UnknownBody: there is no such box.
        InvalidGoal: the box is fixed, no two opposite faces fit between the paddles, or there is no such arm.
        GraspUnavailable: the fingers overlap a neighbour in every grasp.
    """
    box = scene.box(name)
    for arm in arms:
        if arm not in ARMS:
            raise InvalidGoal(f"there is no arm {arm!r}; there are 'left' and 'right'", name)
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
    grasps = [grasp for axis in fitting for grasp in _about_axis(box, axis, arms)]
    return sorted(_among(grasps, box, neighbours(scene, box)), key=lambda grasp: grasp.cost)


def neighbours(scene: Scene, box: Box) -> list[Box]:
    """The boxes near enough to meet the fingers."""
    near = []
    for other in scene.boxes:
        gap = np.abs(other.position - box.position)[:2] - other.half_extents[:2]
        if other.name != box.name and np.all(gap < _FINGERS_REACH) and other.top > box.bottom + _TIP_CLEARANCE:
            near.append(other)
    return near


def _among(grasps: list[Grasp], box: Box, near: list[Box]) -> list[Grasp]:
    """The grasps whose fingers, opened less or moved along the box if need be, overlap no neighbour.

    Raises:
        GraspUnavailable: there is none.
    """
    if not near or not grasps:
        return grasps
    free: list[Grasp] = []
    conflicts: Counter[Pair] = Counter()
    for arm in sorted({grasp.arm for grasp in grasps}):
        wide = [grasp for grasp in grasps if grasp.arm == arm]
        met = _obstacles(arm, wide, near)
        free += [grasp for grasp, pair in zip(wide, met, strict=True) if pair is None]
        narrow = [grasp.narrowed() for grasp, pair in zip(wide, met, strict=True) if pair is not None]
        still = _obstacles(arm, narrow, near)
        free += [grasp for grasp, pair in zip(narrow, still, strict=True) if pair is None]
        conflicts.update(pair for pair in still if pair is not None)
        blocked = [grasp for grasp, pair in zip(narrow, still, strict=True) if pair is not None]
        aside = [beside for grasp in blocked for beside in _beside(box, grasp)]
        free += [grasp for grasp, pair in zip(aside, _obstacles(arm, aside, near), strict=True) if pair is None]
    if not free:
        bodies = conflicts.most_common(1)[0][0]
        raise GraspUnavailable(
            f"{grasps[0].box!r} cannot be grasped: in each of {len(grasps)} grasps a finger would overlap a neighbour, "
            f"mostly {bodies[0]} and {bodies[1]!r}; what stands in the way must be moved first",
            grasps[0].box,
            bodies,
        )
    return free


def _beside(box: Box, grasp: Grasp) -> Iterator[Grasp]:
    """The same grasp moved along the faces it closes on, the fingers still well on them."""
    along = grasp.tool.rotation[:, 0].copy()
    along[2] = 0.0
    along /= np.linalg.norm(along)
    most = min(float(np.abs(along @ box.axes) @ box.size / 2) - _FINGER_ON_FACE, _FARTHEST_ASIDE)
    for shift in (most, -most) if most > 0 else ():
        tool = Pose(grasp.tool.position + shift * along, grasp.tool.orientation)
        yield replace(grasp, tool=tool, cost=grasp.cost + _ASIDE_COST)


def _obstacles(arm: str, grasps: list[Grasp], neighbours: list[Box]) -> list[Pair | None]:
    return obstacles(arm, [grasp.tool for grasp in grasps], [grasp.opening for grasp in grasps], neighbours)


def _about_axis(box: Box, axis: int, arms: tuple[str, ...]) -> Iterator[Grasp]:
    closing = box.axes[:, axis].copy()
    closing[2] = 0.0
    closing /= np.linalg.norm(closing)
    width = float(box.size[axis])
    opening = min(recipe().gripper.opened, width + 2 * _OPENING_ROOM)
    depths = [_depth(box, abs(tilt)) for tilt in TILTS]
    down = np.array([0.0, 0.0, -1.0])
    for sign in (1.0, -1.0):
        y = sign * closing
        x = np.cross(y, down)
        for tilt, depth in zip(TILTS, depths, strict=True):
            if depth is None:
                continue
            cosine, sine = math.cos(tilt), math.sin(tilt)
            rotation = np.column_stack([cosine * x - sine * down, y, cosine * down + sine * x])
            tool = Pose.of(rotation, box.position + depth * rotation[:, 2])
            turn = math.acos(min(1.0, max(-1.0, -float(rotation[0, 0]))))
            for arm in arms:
                yield Grasp(arm, box.name, tool, tilt, width, opening, _cost(box, arm, turn, tilt))


def _depth(box: Box, tilt: float) -> float | None:
    """Depth of the tool frame below the box's centre, so that the fingertips stay above what the box stands on."""
    half = float(box.half_extents[2])
    low = half - _TIP_CLEARANCE
    pads = (low - _PAD_HALF_WIDTH * np.sin(tilt)) / np.cos(tilt) - _PAD_DEPTH
    fingers = (low - _FINGER_HALF_WIDTH * np.sin(tilt)) / np.cos(tilt) - _FINGER_DEPTH
    depth = float(min(pads, fingers, _DEEPEST))
    return depth if depth > -half / 2 else None


def _cost(box: Box, arm: str, turn: float, tilt: float) -> float:
    """Prefers the hand on the box's side, a hand that points down, and a wrist turned little from home."""
    side = 1.0 if arm == "left" else -1.0
    across = max(0.0, 0.05 - side * float(box.position[1]))
    return 4.0 * across + 0.6 * abs(tilt) + 0.25 * turn
