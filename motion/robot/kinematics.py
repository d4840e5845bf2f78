"""Kinematics of one arm on Pinocchio: its seven joints, the hand's tool frame, and any frame fixed to that.

Pinocchio's model of the whole robot is reduced to the arm (Featherstone's recursion over seven joints instead of
nineteen); many configurations at once go through numpy along the same chain, which a test compares with Pinocchio.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import Any

import numpy as np
import pinocchio
from numpy.typing import ArrayLike

from motion.poses import Array, Pose, frozen, quaternion

LAST = 7
"""Pinocchio's index of the arm's last joint."""


class ArmKinematics:
    """Places and movements of the tool of one arm for given joints.

    Attributes:
        model: Pinocchio's model of this arm alone (seven joints), its base standing in the world's frame.
        lower: (7,) lower ends of the joints' ranges less the recipe's margin, radians.
        upper: (7,) upper ends.
        tool: Pinocchio's placement of the tool frame in the last joint's frame.
        tool_inverse: its inverse.
    """

    def __init__(self, robot: Any, name: str, joints: Sequence[str], lower: ArrayLike, upper: ArrayLike) -> None:
        keep = {robot.getJointId(joint) for joint in joints}
        others = [index for index in range(1, robot.njoints) if index not in keep]
        self.model = pinocchio.buildReducedModel(robot, others, pinocchio.neutral(robot))
        self._own = threading.local()
        self.lower, self.upper = frozen(lower), frozen(upper)
        self.tool = pinocchio.SE3(self.model.frames[self.model.getFrameId(f"{name}_gripper")].placement)
        self.tool_inverse = self.tool.inverse()
        self._frame = self.model.getFrameId(f"{name}_gripper")
        placements = [self.model.jointPlacements[index] for index in range(1, LAST + 1)]
        self._links = [(np.array(placement.rotation), np.array(placement.translation)) for placement in placements]

    @property
    def data(self) -> Any:
        """Pinocchio's workspace for it in this thread; whoever computes with `model` overwrites it."""
        data = getattr(self._own, "data", None)
        if data is None:
            data = self._own.data = self.model.createData()
        return data

    def pose(self, joints: ArrayLike) -> Pose:
        """Pose of the tool frame in the world's frame.

        Args:
            joints: (7,) radians.
        """
        placement = self.placement(joints)
        return Pose(placement.translation, quaternion(placement.rotation))

    def placement(self, joints: ArrayLike) -> Any:
        """Pinocchio's SE3 of the tool frame in the world's frame for `joints` (7,) in radians."""
        pinocchio.forwardKinematics(self.model, self.data, np.asarray(joints, dtype=np.float64))
        return self.data.oMi[LAST] * self.tool

    def poses(self, joints: ArrayLike) -> tuple[Array, Array]:
        """Tool frames of many configurations at once.

        Args:
            joints: (n, 7) radians.

        Returns:
            (n, 3) positions in metres and (n, 3, 3) rotation matrices, tool to world.
        """
        q = np.asarray(joints, dtype=np.float64)
        position, rotation = np.zeros((len(q), 3)), np.broadcast_to(np.eye(3), (len(q), 3, 3))
        for index, (turn, offset) in enumerate(self._links):
            position = position + rotation @ offset
            rotation = rotation @ turn
            cosine, sine = np.cos(q[:, index])[:, None], np.sin(q[:, index])[:, None]
            x, y = rotation[:, :, 0], rotation[:, :, 1]
            rotation = np.stack([cosine * x + sine * y, cosine * y - sine * x, rotation[:, :, 2]], axis=2)
        return position + rotation @ self.tool.translation, rotation @ self.tool.rotation

    def jacobian(self, joints: ArrayLike) -> Array:
        """(6, 7) Jacobian of the tool frame: linear (m/s) over angular (rad/s) velocity in the world's axes per rad/s.

        Args:
            joints: (7,) radians.
        """
        q = np.asarray(joints, dtype=np.float64)
        pinocchio.computeJointJacobians(self.model, self.data, q)
        pinocchio.updateFramePlacement(self.model, self.data, self._frame)
        axes = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
        return np.array(pinocchio.getFrameJacobian(self.model, self.data, self._frame, axes))

    def manipulability(self, joints: ArrayLike) -> float:
        """Yoshikawa's measure sqrt(det(J Jᵀ)) (1985): 0 in a singular configuration."""
        jacobian = self.jacobian(joints)
        return float(np.sqrt(max(0.0, np.linalg.det(jacobian @ jacobian.T))))
