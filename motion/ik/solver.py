"""Inverse kinematics of one arm: joints that bring a frame of the hand to its target, or the reason why none do.

Starts come from a table of configurations close to the target, then at random (`starts`); each is led to the target by
Levenberg-Marquardt within the joints' ranges (`levenberg_marquardt`) or by mink with a solver of one's choice
(`differential`). Where every solution is in collision, mink moves the arm along its redundant joint, kept clear of what
stands around (`avoidance`). What remains unreachable is explained (`reasons`).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pinocchio
from numpy.typing import ArrayLike

from motion.collision.clearance import Near
from motion.errors import InvalidGoal, UnreachableTarget
from motion.ik.avoidance import Avoidance
from motion.ik.levenberg_marquardt import Descent, descend, drawn_to_posture, persist
from motion.ik.problem import Problem, problem_of
from motion.ik.reasons import checked_distance, in_collision, out_of_reach
from motion.ik.starts import RESTARTS, Start, nearest_starts, starts_of
from motion.poses import Array, Pose, frozen

LM = "lm"
"""The name of the solver that is not mink's: Levenberg-Marquardt on Pinocchio."""
_SLIDES = 2
_SLIDING_SOLVER = "daqp"


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


def solve_ik(
    arm: str,
    target: Pose,
    *,
    seed: ArrayLike | None = None,
    rng: np.random.Generator | None = None,
    restarts: int = RESTARTS,
    solver: str = LM,
    accept: Callable[[Array], bool] | None = None,
    avoid: Avoidance | None = None,
    posture: ArrayLike | None = None,
    tool: Pose | None = None,
) -> IkSolution:
    """Joints of `arm` that bring its tool frame to `target` in the world's frame.

    Args:
        arm: "left" or "right".
        target: where the tool frame shall be: between the fingertips, z along the approach, y along the closing.
        seed: (7,) joints to start from, radians. Later starts are close to the target in the table, then random.
        rng: where random starts come from; a fixed seed by default.
        restarts: how many starts are tried at most.
        solver: "lm" for Levenberg-Marquardt on Pinocchio, or a quadratic programming solver with which mink shall do it
            ("daqp", "osqp", "proxqp", ... as far as they are installed).
        accept: further condition on a solution; a solution it refuses counts as a failed start.
        avoid: what the arm must keep clear of.
        posture: (7,) joints that the redundant joint shall come as near to as it can, radians; without it, solutions
            near `seed`, or near home, are preferred, but not sought.
        tool: pose, in the tool frame, of another frame of the hand that shall be at the target instead; for example
            the centre of a held box.

    Raises:
        InvalidGoal: the target, seed or posture is not finite, the orientation is no unit quaternion, or there is no
            such arm or solver.
        UnreachableTarget: no start led there; `reason` says why, with the joints that would have to leave their range,
            or the bodies that are in each other's way.
    """
    problem = problem_of(arm, target, seed=seed, posture=posture, tool=tool)
    if restarts < 1:
        raise InvalidGoal(f"inverse kinematics needs at least one start, not restarts={restarts!r}")
    search = _Search(problem, solver, accept, avoid)
    joints = search.from_starts(restarts, rng)
    if joints is None:
        joints = search.by_sliding()
    if joints is None:
        raise search.failure()
    return _solution(problem, joints, search.tried)


class _Search:
    """One search for joints. What was missed and what was refused is kept, to be mended in the end or explained.

    Attributes:
        tried: how many starts were used.
    """

    def __init__(
        self, problem: Problem, solver: str, accept: Callable[[Array], bool] | None, avoid: Avoidance | None
    ) -> None:
        self._problem, self._solver = problem, solver
        self._accept, self._avoid = accept, avoid
        self._lead = _leader(problem, solver)
        self._missed: list[Descent] = []
        self._refused: list[Array] = []
        self._conflicts: list[Near] = []
        self.tried = 0

    def from_starts(self, restarts: int, rng: np.random.Generator | None) -> Array | None:
        """The first joints that are accepted, by one start after the other; None where no start leads to any.

        Raises:
            UnreachableTarget: it is too far, or the hand itself is in collision wherever the arm may be.
        """
        problem = self._problem
        for start in starts_of(problem, self._missed, restarts, rng):
            self.tried += not start.again
            descent = self._led(start)
            if not descent.reached:
                if self.tried == 1:
                    checked_distance(problem.arm, problem.target)
                self._missed.append(descent)
                continue
            joints = descent.joints
            if problem.posture is not None:
                joints = drawn_to_posture(problem.kinematics, problem.last, joints, problem.posture)
            if self._accepted(joints):
                return joints
        return None

    def by_sliding(self) -> Array | None:
        """Joints found from the mildest collisions by moving the redundant joint, or None."""
        if self._avoid is None or len(self._refused) != len(self._conflicts):
            return None
        solver = _SLIDING_SOLVER if self._solver == LM else self._solver
        order = sorted(range(len(self._conflicts)), key=lambda index: -self._conflicts[index].distance)
        for index in order[:_SLIDES]:
            descent = self._avoid.slide(self._refused[index], self._problem.target, solver)
            if descent.reached and self._conflict(descent.joints) is None and self._suits(descent.joints):
                return descent.joints
        return None

    def failure(self) -> UnreachableTarget:
        """The reason why there are no joints, after all has been tried."""
        problem = self._problem
        if self._refused:
            return in_collision(problem.arm, problem.target, self._conflicts, len(self._refused), self.tried)
        return out_of_reach(problem, nearest_starts(problem), self.tried)

    def _led(self, start: Start) -> Descent:
        if start.again:
            return persist(self._problem.kinematics, self._problem.last, start.joints)
        return self._lead(start.joints)

    def _accepted(self, joints: Array) -> bool:
        """Tells whether joints are free of collision and suit the caller, and keeps what is refused."""
        near = self._conflict(joints)
        if near is None and self._suits(joints):
            return True
        self._refused.append(joints)
        if near is not None:
            self._conflicts.append(near)
            if self._avoid is not None and self._avoid.hopeless(near):
                raise in_collision(self._problem.arm, self._problem.target, [near], len(self._refused), self.tried)
        return False

    def _conflict(self, joints: Array) -> Near | None:
        return None if self._avoid is None else self._avoid.nearest(joints)

    def _suits(self, joints: Array) -> bool:
        return self._accept is None or self._accept(joints)


def _leader(problem: Problem, solver: str) -> Callable[[Array], Descent]:
    """The function that leads a start to the target."""
    if solver == LM:
        kinematics, last = problem.kinematics, problem.last
        return lambda start: descend(kinematics, last, start)
    from motion.ik.differential import differential_ik  # loads mink

    differential = differential_ik(problem.arm.name, solver)
    return lambda start: differential.descend(start, problem.target, posture=problem.posture)


def _solution(problem: Problem, joints: Array, tried: int) -> IkSolution:
    left = problem.kinematics.placement(joints).actInv(problem.placement)
    distance, angle = math.hypot(*left.translation.tolist()), math.hypot(*pinocchio.log3(left.rotation).tolist())
    return IkSolution(frozen(joints), distance, angle, tried)
