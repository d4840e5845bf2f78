"""Following a line of nearby targets, each solved from the one before."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from motion.ik.levenberg_marquardt import descend
from motion.ik.problem import placement_of
from motion.ik.solver import LM
from motion.poses import Array, Pose
from motion.robot.load import load_robot

_LINE_STEPS = 8
_LARGEST_JUMP = 0.25


def track(arm: str, targets: Sequence[Pose], start: ArrayLike, solver: str = LM) -> list[Array] | None:
    """Joints along a line of nearby targets, or None where the arm cannot follow.

    Args:
        arm: "left" or "right".
        targets: poses of the tool frame, close to one another (a centimetre or less).
        start: (7,) joints near the first target, radians.
        solver: as for `solve_ik`.
    """
    kinematics = load_robot().kinematics(arm)
    path: list[Array] = []
    joints = np.asarray(start, dtype=np.float64)
    for target in targets:
        if solver == LM:
            descent = descend(kinematics, placement_of(target) * kinematics.tool_inverse, joints, _LINE_STEPS)
        else:
            from motion.ik.differential import differential_ik  # loads mink

            descent = differential_ik(arm, solver).descend(joints, target, 12)
        if not descent.reached or np.max(np.abs(descent.joints - joints)) > _LARGEST_JUMP:
            return None
        joints = descent.joints
        path.append(joints)
    return path
