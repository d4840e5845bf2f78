"""Set points of both arms and both grippers.

The arms are position servos. Their set point leads the plan by what its velocity and acceleration ask of the servo
(feedforward by MuJoCo's mass matrix), and a slow, bounded integral takes out what remains, such as the weight of a
held block.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from motion.collision.scene_model import SceneModel
from motion.physics_engine import mujoco
from motion.poses import Array
from motion.robot.recipe import recipe
from motion.robot.state import ARMS, RobotState
from motion.sim.faults import Injector

_INTEGRAL_RATE = 4.0
_INTEGRAL_BOUND = 0.03
_STILL = np.zeros(7)


class Controller:
    """Writes what the servos shall do; where the arms should be is set from outside.

    Args:
        indices: the scene's model and where things are in it.
        model: MuJoCo's model that is stepped.
        state: where the robot is at the beginning.
        injector: the faults that befall the grippers, or None.

    Attributes:
        reference: for each arm the joints (7,) where it should be, radians.
        width: for each arm the opening that its gripper should have, metres.
    """

    def __init__(self, indices: SceneModel, model: Any, state: RobotState, injector: Injector | None) -> None:
        self.reference = {arm: np.array(state.joints(arm)) for arm in ARMS}
        squeeze = recipe().gripper.squeeze
        self.width = {arm: state.widths[arm] - squeeze * (arm in state.held) for arm in ARMS}
        self._indices, self._model, self._injector = indices, model, injector
        self._integral = {arm: np.zeros(7) for arm in ARMS}
        gains = recipe().actuators
        self._kp, self._kv = np.array(gains["kp"], float), np.array(gains["kv"], float)
        self._acceleration = np.zeros(model.nv)
        self._torque = np.zeros(model.nv)

    def command(
        self, data: Any, moving: str | None = None, velocity: Array = _STILL, acceleration: Array = _STILL
    ) -> None:
        """Writes the set points for the next time step.

        Args:
            data: MjData of the model.
            moving: the arm that moves, or None.
            velocity: (7,) of its joints by the plan, rad/s.
            acceleration: (7,) of its joints by the plan, rad/s².
        """
        indices, time = self._indices, float(data.time)
        closed, step = recipe().gripper.closed, self._model.opt.timestep
        for arm in ARMS:
            deviation = self.reference[arm] - data.qpos[indices.arm_qpos[arm]]
            lead = self._integral[arm] + _INTEGRAL_RATE * step * deviation
            lead = self._integral[arm] = np.minimum(np.maximum(lead, -_INTEGRAL_BOUND), _INTEGRAL_BOUND)
            if arm == moving:
                lead = lead + self._feedforward(data, arm, velocity, acceleration)
            data.ctrl[indices.arm_ctrl[arm]] = self.reference[arm] + lead
            width = self.width[arm] if self._injector is None else self._injector.width(arm, self.width[arm], time)
            data.ctrl[indices.gripper_ctrl[arm]] = (width - closed) / 2

    def _feedforward(self, data: Any, arm: str, velocity: Array, acceleration: Array) -> Array:
        """By how much a servo's set point leads so that its arm moves as planned, (7,) in radians."""
        dofs = self._indices.arm_dof[arm]
        self._acceleration[dofs] = acceleration
        mujoco.mj_mulM(self._model, data, self._torque, self._acceleration)
        self._acceleration[dofs] = 0.0
        return np.asarray((self._kv * velocity + self._torque[dofs]) / self._kp)
