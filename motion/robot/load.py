"""Baxter, built once from its URDF: Pinocchio's model for kinematics, MuJoCo's for contact, from one description."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio

from motion.errors import InvalidGoal, RobotUnavailable
from motion.physics_engine import mujoco
from motion.poses import Array, Pose, frozen
from motion.robot.build import ARM_JOINTS, robot_folder
from motion.robot.kinematics import ArmKinematics
from motion.robot.recipe import JointLimits, recipe
from motion.threads import shared


@dataclass(frozen=True, eq=False)
class Arm:
    """One arm.

    Attributes:
        name: "left" or "right".
        joints: the seven joints' names, shoulder to wrist.
        lower: (7,) lower ends of the joints' ranges, radians.
        upper: (7,) upper ends.
        limits: what the joints may do.
        model: MuJoCo model of this arm alone (seven joints), with the site `<name>_tool`.
        site: id of that site.
        shoulder: (3,) point on the first joint's axis at the height of the second joint, metres.
        reach: longest distance from `shoulder` to the wrist's centre, metres (never less than what is possible).
        wrist: distance from the wrist's centre to the tool frame, along the tool's z axis, metres.
    """

    name: str
    joints: tuple[str, ...]
    lower: Array
    upper: Array
    limits: JointLimits
    model: Any
    site: int
    shoulder: Array
    reach: float
    wrist: float


class Robot:
    """Both models of Baxter and what planning asks of them. Get it by `load_robot`.

    Attributes:
        folder: where the built files are.
        pinocchio: the whole robot as a Pinocchio model (19 joints), standing on the floor of the world's frame.
        arms: by name.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.pinocchio = pinocchio.buildModelFromXML((folder / "robot.urdf").read_text())
        self._data = self.pinocchio.createData()
        self._neutral = pinocchio.neutral(self.pinocchio)
        self._frames = {arm: self.pinocchio.getFrameId(f"{arm}_gripper") for arm in ("left", "right")}
        self.arms = {arm: self._arm(arm) for arm in ("left", "right")}
        self._kinematics = {
            name: ArmKinematics(self.pinocchio, name, arm.joints, arm.lower, arm.upper)
            for name, arm in self.arms.items()
        }

    def arm(self, name: str) -> Arm:
        """The arm of that name.

        Raises:
            InvalidGoal: it is neither "left" nor "right".
        """
        try:
            return self.arms[name]
        except (KeyError, TypeError):
            raise InvalidGoal(f"there is no arm {name!r}; there are 'left' and 'right'") from None

    def kinematics(self, arm: str) -> ArmKinematics:
        """Kinematics of the arm of that name.

        Raises:
            InvalidGoal: it is neither "left" nor "right".
        """
        return self._kinematics[self.arm(arm).name]

    def tool_pose(self, arm: str, joints: Array) -> Pose:
        """Pose of an arm's tool frame (between the fingertips, z along the approach, y along the closing).

        Args:
            arm: "left" or "right".
            joints: (7,) radians.
        """
        return self.kinematics(arm).pose(joints)

    def _arm(self, name: str) -> Arm:
        path = self.folder / f"arm_{name}.mjb"
        try:
            model = mujoco.MjModel.from_binary_path(str(path))
        except ValueError as error:
            raise RobotUnavailable(
                f"{path} could not be read ({error}); delete the folder and it is built again"
            ) from error
        margin = recipe().limits.position_margin
        model.jnt_range[:, 0] += margin
        model.jnt_range[:, 1] -= margin
        pinocchio.forwardKinematics(self.pinocchio, self._data, self._neutral)
        tool = pinocchio.updateFramePlacement(self.pinocchio, self._data, self._frames[name])
        ids = [self.pinocchio.getJointId(f"{name}_{short}") for short in ARM_JOINTS]
        centres = [np.array(self._data.oMi[i].translation) for i in ids]
        lengths = [float(np.linalg.norm(b - a)) for a, b in itertools.pairwise(centres)]
        offset = float(np.linalg.norm((centres[1] - centres[0])[:2]))
        return Arm(
            name=name,
            joints=tuple(f"{name}_{short}" for short in ARM_JOINTS),
            lower=frozen(model.jnt_range[:, 0]),
            upper=frozen(model.jnt_range[:, 1]),
            limits=recipe().limits,
            model=model,
            site=mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, f"{name}_tool"),
            shoulder=frozen([centres[0][0], centres[0][1], centres[1][2]]),
            reach=offset + sum(lengths[1:5]),
            wrist=float(np.linalg.norm(tool.translation - centres[5])),
        )


@shared(maxsize=1)
def load_robot() -> Robot:
    """The robot, built on first use (a progress bar on standard error says so), later read from the user's cache.

    Raises:
        RobotUnavailable: its description is not installed or cannot be read.
    """
    return Robot(robot_folder())
