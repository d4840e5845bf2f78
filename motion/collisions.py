"""Contact checks of whole configurations: both arms, the boxes, and what the hand holds as part of the robot.

MuJoCo's collision detection on a copy of the scene's model whose robot has a margin, so that whatever comes nearer than the
margin is listed with its distance. Pairs that the robot's SRDF disables are left out, and boxes are not checked against one
another, unless one of them is held.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from motion.compiled import scene_model
from motion.engine import mujoco
from motion.poses import Array, Pose
from motion.robot import load_robot
from motion.scene import Scene
from motion.state import RobotState

GRID = 0.01
"""Longest step of any joint between two configurations that are checked, radians."""
CLEARANCE = 0.005
"""Distance kept from everything where no contact is meant, metres."""

_RESTING_OVERLAP = 0.003
_ROBOT, _THINGS = 1, 2


class Near(NamedTuple):
    """Two bodies that are nearer than allowed.

    Attributes:
        bodies: their names.
        distance: metres; negative is penetration.
    """

    bodies: tuple[str, str]
    distance: float


@dataclass(frozen=True)
class Rules:
    """What may be near to what.

    Attributes:
        clearance: distance that all other pairs keep, metres.
        hand_clearance: distance that the moving hand and what it holds keep from boxes, metres.
        touching: names of boxes that the hand may touch.
        resting: names of bodies that the held box may touch.
    """

    clearance: float = CLEARANCE
    hand_clearance: float = CLEARANCE
    touching: frozenset[str] = field(default_factory=frozenset)
    resting: frozenset[str] = field(default_factory=frozenset)


class CollisionChecker:
    """Checks configurations of one arm while everything else stands still.

    Args:
        scene: where the boxes are.
        state: where the robot is; what `state.held` names moves with its hand.
        arm: the arm that moves.
        width: opening of its gripper, metres.
        held: name of the box in its hand, or None.
        grip: pose of that box in the tool frame.
    """

    def __init__(
        self,
        scene: Scene,
        state: RobotState,
        arm: str,
        *,
        width: float | None = None,
        held: str | None = None,
        grip: Pose | None = None,
    ) -> None:
        self._indices = scene_model(scene)
        self._model = copy.copy(self._indices.model)
        self._model.opt.enableflags = 0
        self._data = mujoco.MjData(self._model)
        self._arm, self._robot = arm, load_robot()
        widths = dict(state.widths)
        if width is not None:
            widths[arm] = width
        self._indices.write_boxes(self._data, scene)
        self._indices.write_robot(self._data, RobotState(state.left, state.right, widths, state.held))
        self._held, self._grip = held, grip
        self._scene = scene
        self._hand = self._indices.hand_geoms[arm].copy()
        robot = self._indices.robot_geoms
        solid = (self._model.geom_contype | self._model.geom_conaffinity) != 0
        self._model.geom_contype[:] = np.where(robot & solid, _ROBOT, np.where(solid, _THINGS, 0))
        self._model.geom_conaffinity[:] = np.where(robot & solid, _ROBOT | _THINGS, 0)
        self._model.geom_margin[robot] = CLEARANCE
        self._model.geom_gap[:] = 0
        if held is not None:
            geom = self._indices.box_geoms[held]
            self._hand[geom] = True
            self._model.geom_contype[geom] = _ROBOT
            self._model.geom_conaffinity[geom] = _ROBOT | _THINGS
            self._model.geom_margin[geom] = CLEARANCE
        self._mine = robot.copy()
        if held is not None:
            self._mine[self._indices.box_geoms[held]] = True
        self._boxes = ~robot

    def nearest(self, joints: Array, rules: Rules) -> Near | None:
        """The pair that breaks `rules` most when the arm is at `joints` (7,), or None."""
        self._place(joints)
        data, indices = self._data, self._indices
        if data.ncon == 0:
            return None
        geoms, distances = data.contact.geom, data.contact.dist
        worst: Near | None = None
        excess = 0.0
        for (first, second), distance in zip(geoms, distances, strict=True):
            allowed = self._allowed(int(first), int(second), rules)
            if distance < allowed and allowed - distance > excess:
                excess = allowed - distance
                worst = Near((indices.bodies[first], indices.bodies[second]), float(distance))
        return worst

    def around_held(self, joints: Array, distance: float) -> frozenset[str]:
        """Names of the bodies other than the robot that are within `distance` of the held box at `joints` (7,)."""
        self._place(joints)
        if self._held is None:
            return frozenset()
        held = self._indices.box_geoms[self._held]
        found = set()
        for (first, second), gap in zip(self._data.contact.geom, self._data.contact.dist, strict=True):
            if held in (first, second) and gap <= distance:
                other = int(second if first == held else first)
                if self._boxes[other]:
                    found.add(self._indices.bodies[other])
        return frozenset(found)

    def first_conflict(self, path: Sequence[Array], rules: Rules) -> Near | None:
        """The first conflict along straight lines in joint space through `path`, on the grid; None when there is none."""
        for joints in dense(path):
            near = self.nearest(joints, rules)
            if near is not None:
                return near
        return None

    def free(self, first: Array, second: Array, rules: Rules) -> bool:
        """Whether the straight line between two configurations is free, checked in halves so that conflicts show early."""
        steps = max(1, int(np.ceil(np.max(np.abs(second - first)) / GRID)))
        return all(self.nearest(first + (second - first) * k / steps, rules) is None for k in _bisected(steps))

    def _place(self, joints: Array) -> None:
        model, data, indices = self._model, self._data, self._indices
        data.qpos[indices.arm_qpos[self._arm]] = joints
        if self._held is not None and self._grip is not None:
            pose = self._robot.tool_pose(self._arm, joints) @ self._grip
            indices.write_box(data, self._held, pose)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_collision(model, data)

    def _allowed(self, first: int, second: int, rules: Rules) -> float:
        """Least distance that a pair of geoms may have, metres."""
        if not (self._mine[first] or self._mine[second]):
            return -np.inf
        hand = self._hand[first] or self._hand[second]
        both = self._hand[first] and self._hand[second]
        if both:
            return -np.inf if self._held in (self._indices.bodies[first], self._indices.bodies[second]) else 0.0
        other = second if self._mine[first] else first
        name = self._indices.bodies[other]
        if hand and self._boxes[other]:
            if name in rules.touching:
                return -np.inf
            mine = self._indices.bodies[first if other == second else second]
            if mine == self._held and name in rules.resting:
                return -_RESTING_OVERLAP
            return rules.hand_clearance
        return rules.clearance


def dense(path: Sequence[Array], grid: float = GRID) -> Iterable[Array]:
    """Configurations along straight lines through `path`, no joint moving by more than `grid` between two."""
    if len(path):
        yield path[0]
    for first, second in zip(path[:-1], path[1:], strict=True):
        steps = max(1, int(np.ceil(np.max(np.abs(second - first)) / grid)))
        for k in range(1, steps + 1):
            yield first + (second - first) * (k / steps)


def _bisected(steps: int) -> list[int]:
    """0 .. steps, ends first, then ever finer halves."""
    order, seen = [0, steps], {0, steps}
    stride = 1 << max(0, steps - 1).bit_length()
    while stride >= 1:
        for k in range(0, steps + 1, stride):
            if k not in seen:
                seen.add(k)
                order.append(k)
        stride //= 2
    return order
