"""Following a target that moves: one step of differential inverse kinematics at a time, within all limits."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from motion.errors import InvalidGoal, UnreachableTarget
from motion.ik.avoidance import Avoidance
from motion.poses import Array, Pose, frozen
from motion.robot.load import load_robot


def servo(
    arm: str,
    joints: ArrayLike,
    target: Pose,
    dt: float,
    *,
    solver: str = "daqp",
    posture: ArrayLike | None = None,
    avoid: Avoidance | None = None,
) -> Array:
    """Joints `dt` seconds later on the way to `target`.

    The step is the solution of one quadratic program: towards the target, no joint faster than its limit or out of its
    range, and no closer than allowed to what stands around. It is local: it can get stuck where `solve_ik` finds a way.

    Args:
        arm: "left" or "right".
        joints: (7,) where the arm is, within the joints' ranges, radians.
        target: where the tool frame shall go, in the world's frame.
        dt: duration of the step, seconds.
        solver: a quadratic programming solver that is installed ("daqp", "osqp", "proxqp", ...).
        posture: (7,) joints that the redundant joint is drawn to, radians.
        avoid: what the arm must keep clear of.

    Returns:
        (7,) radians.

    Raises:
        InvalidGoal: joints, posture, target or duration make no sense, or there is no such arm or solver.
        UnreachableTarget: no step keeps all limits.
    """
    import mink  # takes longer than all else here

    from motion.ik.differential import differential_ik

    data = load_robot().arm(arm)
    if not (math.isfinite(dt) and dt > 0):
        raise InvalidGoal(f"the duration of a step is a positive number of seconds, not {dt}")
    if not np.all(np.isfinite([*target.position, *target.orientation])):
        raise InvalidGoal(f"the target of a step is not finite: {target}")
    here = _joints(joints, "joints")
    if np.any(here < data.lower - 1e-6) or np.any(here > data.upper + 1e-6):
        raise InvalidGoal(f"the joints {here.round(3).tolist()} are not within the ranges of the {arm} arm")
    wished = None if posture is None else _joints(posture, "posture")
    try:
        moved = differential_ik(arm, solver).step(
            here, target, dt, posture=wished, more=() if avoid is None else (avoid.limit,)
        )
    except mink.NoSolutionFound as error:
        near = None if avoid is None else avoid.nearest(here)
        bodies = None if near is None else near.bodies
        raise UnreachableTarget(
            f"no step of the {arm} arm keeps all limits"
            + ("" if bodies is None else f"; {bodies[0]} and {bodies[1]} are too near already"),
            "joint limit" if bodies is None else "collision",
            bodies=bodies,
        ) from error
    return frozen(moved)


def _joints(values: ArrayLike, what: str) -> Array:
    joints = np.asarray(values, dtype=np.float64)
    if joints.shape != (7,) or not np.all(np.isfinite(joints)):
        raise InvalidGoal(f"{what} are seven finite numbers in radians, not {joints.tolist()}")
    return joints
