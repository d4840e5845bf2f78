"""Reasons why a pose is out of reach: too far, the end of some joint's range, or bodies in each other's way."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from motion.collision.clearance import Near
from motion.errors import UnreachableTarget
from motion.ik.levenberg_marquardt import Descent, descend
from motion.ik.problem import Problem
from motion.poses import Array, Pose
from motion.robot.load import Arm

_STARTS = 6
_UNBOUNDED = np.full(7, np.inf)


def checked_distance(arm: Arm, target: Pose) -> None:
    """Refuses a target whose wrist would be farther from the shoulder than the arm is long.

    Raises:
        UnreachableTarget: "too far".
    """
    distance = _stretch(arm, target)
    if distance > arm.reach:
        raise UnreachableTarget(
            f"the {arm.name} arm cannot reach {place(target)}: too far, its wrist would be "
            f"{distance:.3f} m from the shoulder and the arm is {arm.reach:.3f} m long",
            "too far",
        )


def too_far(arm: Arm, target: Pose) -> bool:
    """Tells whether the wrist would be farther from the shoulder than the arm is long."""
    return _stretch(arm, target) > arm.reach


def in_collision(arm: Arm, target: Pose, conflicts: Sequence[Near], refused: int, starts: int) -> UnreachableTarget:
    """The target was reached, but each time something was in the way.

    Args:
        arm: the arm.
        target: of the tool frame.
        conflicts: the pairs that were too near, one for each refused configuration; none if another condition refused.
        refused: how many configurations were refused.
        starts: how many starts were used.
    """
    if not conflicts:
        return UnreachableTarget(
            f"the {arm.name} arm reaches {place(target)} only in configurations that are refused "
            f"({refused} of {starts} starts)",
            "collision",
        )
    bodies = Counter(near.bodies for near in conflicts).most_common(1)[0][0]
    mildest = max((near for near in conflicts if near.bodies == bodies), key=lambda near: near.distance)
    first, second = bodies
    how = (
        f"{first} and {second} overlap by {-1000 * mildest.distance:.1f} mm"
        if mildest.distance < 0
        else f"{first} and {second} are {1000 * mildest.distance:.1f} mm apart"
    )
    return UnreachableTarget(
        f"the {arm.name} arm reaches {place(target)} only in collision ({refused} configurations): {how} at best",
        "collision",
        bodies=bodies,
    )


def out_of_reach(problem: Problem, starts: Sequence[Array], tried: int) -> UnreachableTarget:
    """No start led there: would one without the joints' ranges?

    The ranges are dropped and the target is sought once more. Where it is met, the joints that leave their range, by
    as little as possible, are what keeps the arm from it; else the target is too far.

    Args:
        problem: what was to be solved.
        starts: joints to start from, the most promising first.
        tried: how many starts were used before.
    """
    arm, kinematics, target = problem.arm, problem.kinematics, problem.target
    best: tuple[float, Array] | None = None
    nearest: Descent | None = None
    for start in starts[:_STARTS]:
        descent = descend(kinematics, problem.last, start, lower=-_UNBOUNDED, upper=_UNBOUNDED)
        if descent.reached:
            joints = (descent.joints + np.pi) % (2 * np.pi) - np.pi
            beyond = np.maximum(arm.lower - joints, 0) + np.maximum(joints - arm.upper, 0)
            if best is None or float(beyond.sum()) < best[0]:
                best = float(beyond.sum()), joints
        elif nearest is None or descent.left < nearest.left:
            nearest = descent
    if best is not None:
        return _limited(arm, target, best[1], tried)
    assert nearest is not None
    short = kinematics.pose(nearest.joints).distance(target)[0]
    return UnreachableTarget(
        f"the {arm.name} arm cannot reach {place(target)}: too far even without the ends of the joints' ranges, "
        f"{1000 * short:.0f} mm short in the best of {min(len(starts), _STARTS)} starts",
        "too far",
    )


def place(target: Pose) -> str:
    """The position in words."""
    x, y, z = target.position
    return f"({x:.3f}, {y:.3f}, {z:.3f})"


def _stretch(arm: Arm, target: Pose) -> float:
    """Distance from the shoulder to the wrist's centre, metres."""
    return float(np.linalg.norm(target.position - arm.wrist * target.rotation[:, 2] - arm.shoulder))


def _limited(arm: Arm, target: Pose, joints: Array, tried: int) -> UnreachableTarget:
    parts, names = [], []
    for name, value, lower, upper in zip(arm.joints, joints, arm.lower, arm.upper, strict=True):
        if lower <= value <= upper:
            continue
        names.append(name)
        parts.append(f"{name} would have to be at {value:.2f} rad, and its range is {lower:.2f} to {upper:.2f}")
    how = "; ".join(parts) or "the ends of the joints' ranges are in the way"
    return UnreachableTarget(
        f"the {arm.name} arm cannot reach {place(target)} within its joints' ranges ({tried} starts): {how}",
        "joint limit",
        names,
    )
