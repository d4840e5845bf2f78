"""The limit that keeps mink's steps free of collisions.

It is that of Faverjon and Tournassoud (1987), as mink has it: the distance between two bodies shrinks by no more than a
share of what is left of it in a step. It is given for the arm's seven joints alone, however many boxes there are, and
where the distance is already too small the step must widen it. Importing this loads mink.
"""

from __future__ import annotations

import copy

import mink
import numpy as np

from motion.collision.clearance import CLOSE, Rules
from motion.collision.scene_model import scene_model
from motion.physics_engine import mujoco
from motion.poses import Array
from motion.robot.state import RobotState
from motion.scene import Scene

SENSED = 0.03
"""Bodies that are nearer than this take part in the limit, metres."""
_GAIN = 0.5
_ROOM = 0.0005


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
