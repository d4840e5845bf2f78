"""Keeping clear of what stands around: the check of a configuration, and the limit that keeps mink's steps free.

The limit is that of Faverjon and Tournassoud (1987), as mink has it: the distance between two bodies shrinks by no more
than a share of what is left of it in a step. It is given for the arm's seven joints alone, however many boxes there
are, and where the distance is already too small the step must widen it.
"""

from __future__ import annotations

import copy

import mink
import numpy as np

from motion.collisions import CLOSE, CollisionChecker, Near, Rules
from motion.compiled import scene_model
from motion.engine import mujoco
from motion.ik_mink import differential_ik
from motion.ik_newton import Descent
from motion.poses import Array, Pose
from motion.robot import load_robot
from motion.scene import Scene
from motion.state import RobotState

SENSED = 0.03
"""Bodies that are nearer than this take part in the limit, metres."""
_GAIN = 0.5
_ROOM = 0.0005
_STEP = 0.08
_STEPS = 30


class Avoidance:
    """What an arm must keep clear of while everything else stands still.

    Args:
        scene: where the boxes are.
        arm: the arm that moves.
        state: where the robot is; home by default.
        rules: what may be near to what.
        width: opening of the gripper, metres; that of `state` by default.
        held: name of the box in the hand, or None.
        grip: pose of that box in the tool frame.
        checker: the check to use where there is one already for the same arguments.
    """

    def __init__(
        self,
        scene: Scene,
        arm: str,
        *,
        state: RobotState | None = None,
        rules: Rules | None = None,
        width: float | None = None,
        held: str | None = None,
        grip: Pose | None = None,
        checker: CollisionChecker | None = None,
    ) -> None:
        load_robot().arm(arm)
        self._scene, self._arm = scene, arm
        self._state = RobotState.home() if state is None else state
        self._rules = Rules() if rules is None else rules
        self._width = width
        self._checker = (
            CollisionChecker(scene, self._state, arm, width=width, held=held, grip=grip) if checker is None else checker
        )
        self._limit: ContactLimit | None = None

    def nearest(self, joints: Array) -> Near | None:
        """The pair that is nearer than the rules allow when the arm is at `joints` (7,), or None."""
        return self._checker.nearest(joints, self._rules)

    def hopeless(self, near: Near) -> bool:
        """Whether no other joints would help: the hand itself, which the target fixes, is too near to a box."""
        hand = (f"{self._arm[0]}_gripper", f"{self._arm}_gripper", f"{self._arm}_hand")
        others = (*self._scene.names, "floor")
        first, second = near.bodies
        return (first.startswith(hand) and second in others) or (second.startswith(hand) and first in others)

    @property
    def limit(self) -> ContactLimit:
        """The limit for mink on the arm's model."""
        if self._limit is None:
            self._limit = ContactLimit(self._scene, self._arm, self._state, self._rules, self._width)
        return self._limit

    def slide(self, joints: Array, target: Pose, solver: str) -> Descent:
        """Moves from a configuration in collision to a free one with the tool at its target, if mink finds the way.

        Args:
            joints: (7,) radians.
            target: of the tool frame.
            solver: a quadratic programming solver.
        """
        return differential_ik(self._arm, solver).descend(
            joints,
            target,
            _STEPS,
            more=[self.limit],
            largest=_STEP,
            accept=lambda configuration: self.nearest(configuration) is None,
        )


class ContactLimit(mink.Limit):
    """Inequalities on a step of one arm's joints that keep distances, found by MuJoCo's collision detection.

    Args:
        scene: where the boxes are.
        arm: the arm that moves.
        state: where the robot is.
        rules: what may be near to what; what a hand holds is not considered.
        width: opening of the gripper, metres; that of `state` by default.
    """

    def __init__(self, scene: Scene, arm: str, state: RobotState, rules: Rules, width: float | None) -> None:
        self._indices = scene_model(scene)
        self._model = model = copy.copy(self._indices.model)
        model.opt.enableflags = 0
        self._data = mujoco.MjData(model)
        widths = dict(state.widths) if width is None else {**state.widths, arm: width}
        self._indices.write_boxes(self._data, scene)
        self._indices.write_robot(self._data, RobotState(state.left, state.right, widths, state.held))
        self._qpos, self._dof = self._indices.arm_qpos[arm], self._indices.arm_dof[arm]
        moving = np.isin(model.geom_bodyid, _below(model, f"{arm}_s0"))
        solid = (model.geom_contype | model.geom_conaffinity) != 0
        model.geom_contype[:] = np.where(moving & solid, 1, np.where(solid, 2, 0))
        model.geom_conaffinity[:] = np.where(moving & solid, 3, 0)
        model.geom_margin[:] = np.where(moving, SENSED, 0.0)
        model.geom_gap[:] = 0
        model.body_margin[np.unique(model.geom_bodyid[moving])] = SENSED
        self._moving, self._hand, self._rules = moving, self._indices.hand_geoms[arm], rules
        self._robot = self._indices.robot_geoms

    def compute_qp_inequalities(self, configuration: mink.Configuration, dt: float) -> mink.Constraint:
        """G Δq ≤ h for every pair within `SENSED`, with Δq (7,) in radians; `dt` is not used."""
        model, data = self._model, self._data
        data.qpos[self._qpos] = configuration.q
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_collision(model, data)
        rows, bounds = [], []
        for contact in data.contact:
            first, second = (int(geom) for geom in contact.geom)
            least = self._least(first, second)
            if least is None:
                continue
            normal = contact.frame[:3]
            closing = self._speed(first, contact.pos, normal) - self._speed(second, contact.pos, normal)
            rows.append(closing)
            bounds.append(_GAIN * (contact.dist - least - _ROOM))
        if not rows:
            return mink.Constraint()
        return mink.Constraint(G=np.array(rows), h=np.array(bounds))

    def _least(self, first: int, second: int) -> float | None:
        """Distance that the pair must keep, metres; None for a pair that may touch."""
        rules, names = self._rules, self._indices.bodies
        if self._robot[first] and self._robot[second]:
            return 0.0 if self._hand[first] and self._hand[second] else rules.clearance
        hand = self._hand[first] or self._hand[second]
        other = names[second if self._robot[first] else first]
        if hand and other in rules.touching:
            return None
        if hand and other in rules.close:
            return CLOSE
        return rules.hand_clearance if hand and other in self._indices.box_geoms else rules.clearance

    def _speed(self, geom: int, point: Array, normal: Array) -> Array:
        """(7,) velocity of a geom's point along the normal for each of the arm's joints, m/rad."""
        if not self._moving[geom]:
            return np.zeros(7)
        jacobian = np.zeros((3, self._model.nv))
        mujoco.mj_jac(self._model, self._data, jacobian, None, point, int(self._model.geom_bodyid[geom]))
        return np.asarray(normal @ jacobian[:, self._dof])


def _below(model: object, joint: str) -> list[int]:
    """Ids of the bodies that the joint carries."""
    parents = model.body_parentid  # type: ignore[attr-defined]
    found = {int(model.joint(joint).bodyid[0])}  # type: ignore[attr-defined]
    for body in range(len(parents)):
        if int(parents[body]) in found:
            found.add(body)
    return sorted(found)
