"""mink's differential inverse kinematics as another way from a start to a target, with hard limits on every step.

Each step solves a small quadratic program for the joints' displacement (Zakka, "mink", after Kanoun et al., 2011): the
frame task pulls the tool to its target, a little damping settles the redundant joint, the joints' ranges and a bound
on the step are inequalities, and so is the distance to what stands around when that is asked for. Any solver that
qpsolvers knows can do the quadratic programs; `benchmarks/ik.py` measures them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mink
import numpy as np

from motion.errors import InvalidGoal
from motion.ik.levenberg_marquardt import ORIENTATION_TOLERANCE, POSITION_TOLERANCE, Descent
from motion.poses import Array, Pose
from motion.robot.load import load_robot
from motion.threads import per_thread

STEPS = 40
_LARGEST_STEP = 0.6
_DAMPING = 1e-5
_POSTURE_COST = 1e-3
_PATIENCE = 6


class DifferentialIk:
    """mink's objects for one arm and one solver, made once.

    Args:
        arm: "left" or "right".
        solver: a quadratic programming solver that is installed and that qpsolvers knows.

    Raises:
        InvalidGoal: there is no such arm, or no such solver.
    """

    def __init__(self, arm: str, solver: str) -> None:
        self._arm = data = load_robot().arm(arm)
        checked_solver(solver)
        self._configuration = mink.Configuration(data.model)
        self._task = mink.FrameTask(f"{arm}_tool", "site", position_cost=1.0, orientation_cost=0.3)
        self._posture = mink.PostureTask(data.model, cost=_POSTURE_COST)
        self._limits = [mink.ConfigurationLimit(data.model, gain=0.95), self._bounded(_LARGEST_STEP)]
        self._fastest = mink.VelocityLimit(data.model, dict(zip(data.joints, data.limits.velocity, strict=True)))
        self._solver = solver

    def _bounded(self, step: float) -> mink.VelocityLimit:
        return mink.VelocityLimit(self._arm.model, dict.fromkeys(self._arm.joints, step))

    def step(
        self,
        joints: Array,
        target: Pose,
        dt: float,
        *,
        posture: Array | None = None,
        more: Sequence[mink.Limit] = (),
    ) -> Array:
        """Joints `dt` seconds later on the way to `target`, no joint faster than the recipe allows.

        Args:
            joints: (7,) where the arm is, radians.
            target: where the tool frame shall go.
            dt: duration of the step, seconds.
            posture: (7,) joints that the redundant joint is drawn to, radians.
            more: further limits.

        Raises:
            mink.NoSolutionFound: no step keeps all limits.
        """
        self._configuration.update(np.asarray(joints))
        tasks = self._tasks(target, posture)
        limits = [self._limits[0], self._fastest, *more]
        velocity = mink.solve_ik(self._configuration, tasks, dt, self._solver, damping=_DAMPING, limits=limits)
        moved = self._configuration.integrate(velocity, dt)
        return np.asarray(np.clip(moved, self._arm.lower, self._arm.upper))

    def _tasks(self, target: Pose, posture: Array | None) -> list[mink.Task]:
        self._task.set_target(mink.SE3(np.concatenate([target.orientation, target.position])))
        if posture is None:
            return [self._task]
        self._posture.set_target(np.asarray(posture))
        return [self._task, self._posture]

    def descend(
        self,
        start: Array,
        target: Pose,
        steps: int = STEPS,
        *,
        posture: Array | None = None,
        more: Sequence[mink.Limit] = (),
        largest: float | None = None,
        accept: Callable[[Array], bool] | None = None,
    ) -> Descent:
        """Follows the task's gradient from `start` until the target is met or progress ends.

        Args:
            start: (7,) joints within their ranges, radians.
            target: where the tool frame shall be.
            steps: how many steps are taken at most.
            posture: (7,) joints that the redundant joint is drawn to, radians.
            more: further limits.
            largest: bound on a joint's step, radians, when it is smaller than usual.
            accept: further condition on where to stop, such as freedom from collision.
        """
        configuration, task = self._configuration, self._task
        configuration.update(np.asarray(start))
        tasks = self._tasks(target, posture)
        limits = [*self._limits, *([] if largest is None else [self._bounded(largest)]), *more]
        last = np.inf
        for step in range(steps + 1):
            residual = task.compute_error(configuration)
            error = max(
                float(np.linalg.norm(residual[:3])) / POSITION_TOLERANCE,
                float(np.linalg.norm(residual[3:])) / ORIENTATION_TOLERANCE,
            )
            late, met = step % _PATIENCE == _PATIENCE - 1, error <= 0.5
            done = met and (accept is None or accept(configuration.q))
            if done or step == steps or (late and not met and error > 0.9 * last):
                break
            if late:
                last = error
            try:
                velocity = mink.solve_ik(configuration, tasks, 1.0, self._solver, damping=_DAMPING, limits=limits)
            except mink.NoSolutionFound:
                break
            configuration.integrate_inplace(velocity, 1.0)
        joints = np.clip(configuration.q, self._arm.lower, self._arm.upper)
        return Descent(joints, error <= 1, step, 0.0 if error <= 1 else np.inf)


@per_thread(maxsize=16)
def differential_ik(arm: str, solver: str) -> DifferentialIk:
    """The objects of one arm and one solver, for this thread.

    Raises:
        InvalidGoal: there is no such arm, or no such solver.
    """
    return DifferentialIk(arm, solver)


def checked_solver(solver: str) -> None:
    """Refuses a solver that cannot be used.

    Raises:
        InvalidGoal: with the names of those that can.
    """
    import qpsolvers

    if solver not in qpsolvers.available_solvers:
        known = ", ".join(sorted(qpsolvers.available_solvers))
        raise InvalidGoal(
            f"there is no solver {solver!r} for inverse kinematics; there are lm (Levenberg-Marquardt) and of the "
            f"quadratic programming solvers that are installed: {known}"
        )
