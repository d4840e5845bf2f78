"""Inverse kinematics of one arm: mink's differential IK, restarted, within the joints' ranges.

Each step solves a small quadratic program for the joints' displacement (Zakka, "mink", after Kanoun et al., 2011): the
frame task pulls the tool to its target, a little damping settles the redundant joint, and the joints' ranges and a
bound on the step are hard limits. Differential IK is local, so a start that gets stuck is given up and another tried.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import mink
import numpy as np

from motion.errors import InvalidGoal, UnreachableTarget
from motion.poses import Array, Pose, frozen
from motion.recipe import recipe
from motion.robot import Arm, load_robot

POSITION_TOLERANCE = 1e-4
ORIENTATION_TOLERANCE = 1e-3
RESTARTS = 15
_STEPS = 40
_LARGEST_STEP = 0.6
_DAMPING = 1e-5


class IkSolution(NamedTuple):
    """Joints that bring the tool to its target.

    Attributes:
        joints: (7,) radians, within the joints' ranges less the recipe's margin.
        position_error: distance left, metres, by Pinocchio's kinematics.
        orientation_error: angle left, radians.
        attempts: how many starts were used.
    """

    joints: Array
    position_error: float
    orientation_error: float
    attempts: int


class _Best(NamedTuple):
    error: float
    joints: Array
    distance: float


def solve_ik(
    arm: str,
    target: Pose,
    *,
    seed: Array | None = None,
    rng: np.random.Generator | None = None,
    restarts: int = RESTARTS,
    solver: str = "daqp",
    accept: Callable[[Array], bool] | None = None,
) -> IkSolution:
    """Joints of `arm` that bring its tool frame to `target` in the world's frame.

    Args:
        arm: "left" or "right".
        target: where the tool frame shall be.
        seed: (7,) joints to start from, radians; home by default. Later starts are drawn from `rng`.
        rng: where later starts come from; a fixed seed by default.
        restarts: how many starts are tried at most.
        solver: a quadratic programming solver that qpsolvers knows ("daqp", "osqp", "proxqp", ...).
        accept: further condition on a solution, such as freedom from collision; a solution it refuses counts as a
            failed start.

    Raises:
        InvalidGoal: the target is not finite, or there is no such arm.
        UnreachableTarget: no start led there; `reason` says why.
    """
    if not (np.all(np.isfinite(target.position)) and np.all(np.isfinite(target.orientation))):
        raise InvalidGoal(f"the target of inverse kinematics is not finite: {target}")
    data = load_robot().arm(arm)
    _check_distance(data, target)
    rng = np.random.default_rng(0) if rng is None else rng
    workspace = _workspace(arm, solver)
    home = recipe().home[arm]
    best: _Best | None = None
    refused = 0
    for attempt in range(restarts):
        if attempt == 0:
            start = home if seed is None else seed
        elif attempt < 4:
            start = home + rng.uniform(-0.8, 0.8, 7)
        else:
            start = rng.uniform(data.lower, data.upper)
        joints, error, distance = workspace.descend(np.clip(start, data.lower, data.upper), target)
        if error <= 1:
            found = load_robot().tool_pose(arm, joints).distance(target)
            if accept is None or accept(joints):
                return IkSolution(frozen(joints), *found, attempts=attempt + 1)
            refused += 1
        elif best is None or error < best.error:
            best = _Best(error, joints, distance)
    raise _explain(data, target, best, refused, restarts)


def track(arm: str, targets: list[Pose], start: Array, solver: str = "daqp") -> list[Array] | None:
    """Joints along a line of nearby targets, each solved from the one before; None when the arm cannot follow.

    Args:
        arm: "left" or "right".
        targets: poses of the tool frame, close to one another (a centimetre or less).
        start: (7,) joints near the first target, radians.
        solver: as for `solve_ik`.
    """
    workspace = _workspace(arm, solver)
    path, joints = [], np.asarray(start)
    for target in targets:
        following, error, _ = workspace.descend(joints, target, steps=12)
        if error > 1 or np.max(np.abs(following - joints)) > 0.25:
            return None
        path.append(following)
        joints = following
    return path


class _Workspace:
    """mink's objects for one arm, made once."""

    def __init__(self, arm: Arm, solver: str) -> None:
        self._configuration = mink.Configuration(arm.model)
        self._task = mink.FrameTask(f"{arm.name}_tool", "site", position_cost=1.0, orientation_cost=0.3)
        self._limits = [
            mink.ConfigurationLimit(arm.model, gain=0.95),
            mink.VelocityLimit(arm.model, dict.fromkeys(arm.joints, _LARGEST_STEP)),
        ]
        self._tasks = [self._task]
        self._solver = solver

    def descend(self, start: Array, target: Pose, steps: int = _STEPS) -> tuple[Array, float, float]:
        """Follows the task's gradient from `start`; joints, error in units of the tolerances, distance in metres."""
        configuration, task = self._configuration, self._task
        configuration.update(start)
        task.set_target(mink.SE3(np.concatenate([target.orientation, target.position])))
        last = np.inf
        for step in range(steps + 1):
            residual = task.compute_error(configuration)
            distance = float(np.linalg.norm(residual[:3]))
            error = max(distance / POSITION_TOLERANCE, float(np.linalg.norm(residual[3:])) / ORIENTATION_TOLERANCE)
            if error <= 0.5 or step == steps or (step % 6 == 5 and error > 0.9 * last):
                break
            if step % 6 == 5:
                last = error
            try:
                velocity = mink.solve_ik(
                    configuration, self._tasks, 1.0, self._solver, damping=_DAMPING, limits=self._limits
                )
            except mink.NoSolutionFound:
                break
            configuration.integrate_inplace(velocity, 1.0)
        return configuration.q.copy(), error, distance


@lru_cache(maxsize=8)
def _workspace(arm: str, solver: str) -> _Workspace:
    return _Workspace(load_robot().arm(arm), solver)


def _check_distance(arm: Arm, target: Pose) -> None:
    wrist = target.position - arm.wrist * target.rotation[:, 2]
    distance = float(np.linalg.norm(wrist - arm.shoulder))
    if distance > arm.reach:
        raise UnreachableTarget(
            f"the {arm.name} arm cannot reach {_place(target)}: too far, its wrist would be "
            f"{distance:.3f} m from the shoulder and the arm is {arm.reach:.3f} m long",
            "too far",
        )


def _explain(arm: Arm, target: Pose, best: _Best | None, refused: int, restarts: int) -> UnreachableTarget:
    if refused or best is None:
        return UnreachableTarget(
            f"the {arm.name} arm reaches {_place(target)} only in configurations that are refused "
            f"({refused} of {restarts} starts)",
            "collision",
        )
    slack = np.minimum(best.joints - arm.lower, arm.upper - best.joints)
    stuck = [name for name, room in zip(arm.joints, slack, strict=True) if room < 2e-2]
    if stuck:
        return UnreachableTarget(
            f"the {arm.name} arm cannot reach {_place(target)}: {', '.join(stuck)} at the end of the range "
            f"in the best of {restarts} starts, {1000 * best.distance:.0f} mm short",
            "joint limit",
            stuck,
        )
    return UnreachableTarget(
        f"the {arm.name} arm cannot reach {_place(target)}: too far by {1000 * best.distance:.0f} mm in "
        f"the best of {restarts} starts",
        "too far",
    )


def _place(target: Pose) -> str:
    x, y, z = target.position
    return f"({x:.3f}, {y:.3f}, {z:.3f})"
