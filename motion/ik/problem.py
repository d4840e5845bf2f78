"""The problem that inverse kinematics solves: a target that is checked, in the frames that a descent works with."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pinocchio
from numpy.typing import ArrayLike

from motion.errors import InvalidGoal
from motion.poses import Array, Pose
from motion.robot.kinematics import ArmKinematics
from motion.robot.load import Arm, load_robot
from motion.robot.recipe import recipe


class Problem(NamedTuple):
    """A target that an arm shall reach.

    Attributes:
        arm: the arm.
        kinematics: its kinematics.
        target: pose of the tool frame in the world's frame.
        placement: the same as Pinocchio's SE3.
        last: SE3 of the last joint's frame at the target.
        seed: (7,) joints to start from, radians, or None.
        posture: (7,) joints that the redundant joint shall come near to, radians, or None.
    """

    arm: Arm
    kinematics: ArmKinematics
    target: Pose
    placement: Any
    last: Any
    seed: Array | None = None
    posture: Array | None = None

    @property
    def preferred(self) -> Array:
        """(7,) joints near which solutions are looked for first, radians: the posture, else the seed, else home."""
        if self.posture is not None:
            return self.posture
        return recipe().home[self.arm.name] if self.seed is None else self.seed


def problem_of(
    arm: str,
    target: Pose,
    *,
    seed: ArrayLike | None = None,
    posture: ArrayLike | None = None,
    tool: Pose | None = None,
) -> Problem:
    """Describes one target.

    Args:
        arm: "left" or "right".
        target: where the tool frame shall be, in the world's frame.
        seed: (7,) joints to start from, radians; brought into their ranges.
        posture: (7,) joints to come near to, radians; brought into their ranges.
        tool: pose, in the tool frame, of another frame of the hand that shall be at the target instead.

    Raises:
        InvalidGoal: target, tool, seed or posture is not finite, an orientation is no unit quaternion, or there is no
            such arm.
    """
    _check(target, "the target of inverse kinematics")
    robot = load_robot()
    data, kinematics = robot.arm(arm), robot.kinematics(arm)
    first = None if seed is None else _joints(seed, "seed", data)
    wished = None if posture is None else _joints(posture, "posture", data)
    if tool is not None:
        _check(tool, "the frame in the hand")
        target = target @ tool.inverse()
    placement = placement_of(target)
    return Problem(data, kinematics, target, placement, placement * kinematics.tool_inverse, first, wished)


def placement_of(target: Pose) -> Any:
    """A pose as Pinocchio's SE3."""
    w, x, y, z = target.orientation.tolist()
    unit = (w * w + x * x + y * y + z * z) ** -0.5
    return pinocchio.XYZQUATToSE3(np.array([*target.position.tolist(), x * unit, y * unit, z * unit, w * unit]))


def _check(pose: Pose, what: str) -> None:
    values = [*pose.position.tolist(), *pose.orientation.tolist()]
    total = sum(values)
    if len(values) != 7 or total - total != 0:  # NaN and infinity are what differ from themselves
        raise InvalidGoal(f"{what} is not finite, or no position with a quaternion: {pose}")
    norm = sum(value * value for value in values[3:]) ** 0.5
    if abs(norm - 1) > 1e-3:
        raise InvalidGoal(f"the orientation of {what} has norm {norm:.6g}; a unit quaternion w, x, y, z is needed")


def _joints(values: ArrayLike, what: str, arm: Arm) -> Array:
    joints = np.asarray(values, dtype=np.float64)
    if joints.shape != (7,) or not np.all(np.isfinite(joints)):
        raise InvalidGoal(f"a {what} of inverse kinematics is seven finite joints in radians, not {joints.tolist()}")
    return np.minimum(np.maximum(joints, arm.lower), arm.upper)
