"""Levenberg-Marquardt on Pinocchio, within the joints' ranges: the quick way from a start to a target.

A step solves (J Jᵀ + λ I) y = e for the joints' displacement Jᵀ y, where e is the logarithm of the pose that is left
(Lynch and Park, "Modern Robotics", section 6.2) and λ grows with |e|² (Sugihara, "Solvability-unconcerned inverse
kinematics by the Levenberg-Marquardt method", 2011). Joints that would leave their range stop at its end, and the
others take over what is left: an active set of one step.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pinocchio
from scipy.linalg.lapack import dposv

from motion.poses import Array
from motion.robot.kinematics import LAST, ArmKinematics

POSITION_TOLERANCE = 1e-4
"""Distance from its target at which the tool has reached it, metres."""
ORIENTATION_TOLERANCE = 1e-3
"""The same for its orientation, radians."""

_DAMPING = 1e-6
_DAMPING_BY_ERROR = 0.01
_LARGEST_STEP = 0.8
_CONVERGED = 1e-10
_GOOD = 1e-9
_STEPS = 14
_NULLSPACE_STEP = 0.3
_SETTLED = 1e-3
_MOST_DAMPING = 1e3
_PATIENCE = 3
_PROGRESS = 0.5


class Descent(NamedTuple):
    """The end of the way from a start.

    Attributes:
        joints: (7,) radians.
        reached: whether the target was met to some hundredths of a millimetre and of a milliradian.
        steps: how many steps it took.
        left: squared norm of the logarithm of the pose that is left, of the last joint's frame.
    """

    joints: Array
    reached: bool
    steps: int
    left: float = 0.0


def descend(
    kinematics: ArmKinematics,
    target: Any,
    start: Array,
    steps: int = _STEPS,
    *,
    lower: Array | None = None,
    upper: Array | None = None,
) -> Descent:
    """Follows the damped Newton step from `start` until the target is met or progress ends.

    Args:
        kinematics: the arm.
        target: Pinocchio's SE3 of the *last joint's frame* (the tool's target times the inverse of `kinematics.tool`).
        start: (7,) joints within their ranges, radians.
        steps: how many steps are taken at most.
        lower: (7,) lower ends of the joints' ranges, radians, if they are not the arm's own.
        upper: (7,) upper ends, ditto.
    """
    model, data = kinematics.model, kinematics.data
    lower = kinematics.lower if lower is None else lower
    upper = kinematics.upper if upper is None else upper
    joints, last, reached = start, np.inf, data.iMf[0]  # a view of Pinocchio's, written anew by each Jacobian
    for step in range(steps + 1):
        jacobian = pinocchio.computeJointJacobian(model, data, joints, LAST)
        error = pinocchio.log6(reached.actInv(target)).vector
        left = float(error.dot(error))
        if left < _CONVERGED:
            return Descent(joints, True, step, left)
        if step == steps or (step >= _PATIENCE and left > _PROGRESS * last):
            break
        last = left
        damping = _DAMPING + _DAMPING_BY_ERROR * left
        moved, change = _moved(joints, _solved(jacobian, error, damping), jacobian, error, damping, lower, upper)
        values = change.tolist()
        largest = max(max(values), -min(values))
        joints = moved if largest <= _LARGEST_STEP else joints + change * (_LARGEST_STEP / largest)
    return Descent(joints, left < _GOOD, step, left)


def persist(kinematics: ArmKinematics, target: Any, start: Array, steps: int = 100) -> Descent:
    """Like `descend`, but a step that leads away is taken back and damped more (Marquardt, 1963).

    Slower, and surer where the arm is nearly stretched: there the plain step overshoots. What ends within tolerances
    has reached the target: at the very edge of its reach the arm gets no closer.

    Args:
        kinematics: the arm.
        target: as for `descend`.
        start: (7,) joints within their ranges, radians.
        steps: how many steps are taken at most.
    """
    joints, damping, left = start, 1e-3, np.inf
    moved = start
    for _ in range(steps + 1):
        jacobian_there = pinocchio.computeJointJacobian(kinematics.model, kinematics.data, moved, LAST)
        error_there = pinocchio.log6(kinematics.data.iMf[0].actInv(target)).vector
        there = float(error_there.dot(error_there))
        if there < left:
            joints, jacobian, error, left = moved, jacobian_there, error_there, there
            damping = max(damping / 5, 1e-9)
        else:
            damping *= 4
        if left < _GOOD or damping > _MOST_DAMPING:
            break
        solved = _solved(jacobian, error, damping)
        moved, _ = _moved(joints, solved, jacobian, error, damping, kinematics.lower, kinematics.upper)
    return Descent(joints, left < _GOOD or _within(kinematics, target, joints), steps, left)


def drawn_to_posture(kinematics: ArmKinematics, target: Any, joints: Array, posture: Array, steps: int = 12) -> Array:
    """Moves the redundant joint towards `posture` while the tool stays at its target.

    Each step goes along the projection of the way to `posture` onto the Jacobian's nullspace, (I - J⁺ J) (posture - q)
    (Liégeois, 1977), and is corrected by `descend`; it ends when that no longer brings the arm nearer to the posture.

    Args:
        kinematics: the arm.
        target: as for `descend`.
        joints: (7,) joints that meet the target, radians.
        posture: (7,) joints to come near to, radians.
        steps: how many steps are taken at most.
    """
    distance = float(np.linalg.norm(joints - posture))
    for _ in range(steps):
        jacobian = pinocchio.computeJointJacobian(kinematics.model, kinematics.data, joints, LAST)
        free = np.linalg.svd(jacobian)[2][6]
        along = float(free.dot(posture - joints))
        if abs(along) < _SETTLED:
            break
        moved = joints + free * max(-_NULLSPACE_STEP, min(_NULLSPACE_STEP, along))
        descent = descend(kinematics, target, np.clip(moved, kinematics.lower, kinematics.upper))
        nearer = float(np.linalg.norm(descent.joints - posture))
        if not descent.reached or nearer >= distance - _SETTLED:
            break
        joints, distance = descent.joints, nearer
    return joints


def _within(kinematics: ArmKinematics, target: Any, joints: Array) -> bool:
    """Tells whether the tool is within the tolerances."""
    left = kinematics.placement(joints).actInv(target * kinematics.tool)
    distance, angle = np.linalg.norm(left.translation), np.linalg.norm(pinocchio.log3(left.rotation))
    return bool(distance < POSITION_TOLERANCE and angle < ORIENTATION_TOLERANCE)


def _solved(jacobian: Array, error: Array, damping: float) -> Array:
    square = jacobian.dot(jacobian.T)
    square.flat[::7] += damping
    return np.asarray(jacobian.T.dot(dposv(square, error)[1]))


def _moved(
    joints: Array, step: Array, jacobian: Array, error: Array, damping: float, lower: Array, upper: Array
) -> tuple[Array, Array]:
    """`joints` after `step`, within the ranges, and by how much they moved.

    What the joints that are stopped at the ends of their ranges do not do, the others do if they can.
    """
    wanted = joints + step
    clipped = np.minimum(np.maximum(wanted, lower), upper)
    if clipped.tolist() == wanted.tolist():
        return clipped, step
    stopped = clipped != wanted
    for _ in range(len(joints)):
        done = np.where(stopped, clipped - joints, 0.0)
        rest = _solved(jacobian * ~stopped, error - jacobian.dot(done), damping)
        wanted = np.where(stopped, clipped, joints + rest)
        clipped = np.minimum(np.maximum(wanted, lower), upper)
        beyond = clipped != wanted
        if not beyond.any():
            break
        stopped = stopped | beyond
    return clipped, clipped - joints
