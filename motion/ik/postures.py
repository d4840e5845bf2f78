"""Many answers at once: all postures of an arm at one target, and one posture at each of many targets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike

from motion.ik.levenberg_marquardt import Descent, descend, persist
from motion.ik.problem import Problem, problem_of
from motion.ik.reasons import checked_distance, out_of_reach, too_far
from motion.ik.starts import RESTARTS, Start, nearest_starts, starts_of
from motion.poses import Array, Pose, frozen
from motion.robot.load import load_robot

_DIFFERENT = 0.2


def solutions(
    arm: str,
    target: Pose,
    *,
    seed: ArrayLike | None = None,
    rng: np.random.Generator | None = None,
    restarts: int = RESTARTS,
) -> Iterator[Array]:
    """Different postures of the arm with its tool frame at `target`, each looked for when it is asked for.

    Args:
        arm: "left" or "right".
        target: of the tool frame, in the world's frame.
        seed: (7,) joints to start from, radians; postures near it come first.
        rng: where random starts come from; a fixed seed by default.
        restarts: how many starts are tried at most, for all of them together.

    Yields:
        (7,) radians; any two differ by more than 0.2 rad in some joint.

    Raises:
        InvalidGoal: as for `solve_ik`.
        UnreachableTarget: there is not even one; raised by the first step.
    """
    problem = problem_of(arm, target, seed=seed)
    found: list[Array] = []
    missed: list[Descent] = []
    tried = 0
    for start in starts_of(problem, missed, restarts, rng):
        if start.again and found:
            return
        tried += not start.again
        descent = _led(problem, start)
        if not descent.reached:
            if tried == 1:
                checked_distance(problem.arm, target)
            missed.append(descent)
        elif all(np.max(np.abs(descent.joints - other)) > _DIFFERENT for other in found):
            found.append(descent.joints)
            yield frozen(descent.joints)
    if not found:
        raise out_of_reach(problem, nearest_starts(problem), tried)


def reachable(arm: str, targets: Sequence[Pose], *, restarts: int = RESTARTS) -> Array:
    """Joints at each of many targets, boxes and the robot's own body aside.

    Args:
        arm: "left" or "right".
        targets: of the tool frame, in the world's frame.
        restarts: how many starts are tried at most for each.

    Returns:
        (n, 7) joints in radians; a row of NaN for a target that is not reached.

    Raises:
        InvalidGoal: a target is not finite, or there is no such arm.
    """
    load_robot().arm(arm)
    found = np.full((len(targets), 7), np.nan)
    for row, target in enumerate(targets):
        joints = _any_joints(problem_of(arm, target), restarts)
        if joints is not None:
            found[row] = joints
    return found


def _any_joints(problem: Problem, restarts: int) -> Array | None:
    missed: list[Descent] = []
    for start in starts_of(problem, missed, restarts):
        descent = _led(problem, start)
        if descent.reached:
            return descent.joints
        if not missed and too_far(problem.arm, problem.target):
            return None
        missed.append(descent)
    return None


def _led(problem: Problem, start: Start) -> Descent:
    step = persist if start.again else descend
    return step(problem.kinematics, problem.last, start.joints)
