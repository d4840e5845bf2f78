"""Inverse kinematics of one arm: joints that bring a frame of the hand to its target, or the reason why none do.

Starts come from a table of configurations close to the target (`seeds`), then at random; each is led to the target by
Levenberg-Marquardt within the joints' ranges (`levenberg_marquardt`) or by mink with a solver of one's choice
(`differential`). Where every solution is in collision, mink moves the arm along its redundant joint, kept clear of what
stands around (`avoidance`). What remains unreachable is explained (`reasons`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import islice
from typing import Any, NamedTuple

import numpy as np
import pinocchio
from numpy.typing import ArrayLike

from motion.collision.checker import Near
from motion.errors import InvalidGoal
from motion.ik.avoidance import Avoidance
from motion.ik.levenberg_marquardt import ORIENTATION_TOLERANCE, POSITION_TOLERANCE, Descent, descend, persist, settle
from motion.ik.reasons import checked_distance, in_collision, out_of_reach, too_far
from motion.ik.seeds import NEIGHBOURS, SeedTable
from motion.poses import Array, Pose, frozen
from motion.robot.load import load_robot
from motion.robot.recipe import recipe

LM = "lm"
"""The name of the solver that is not mink's: Levenberg-Marquardt on Pinocchio."""
RESTARTS = 150
"""Starts at most, by default; nine in ten targets need one, and what is far out of reach is given up after thirty."""
_RANDOM = 6
_CLOSE = 0.03
"""Only where some start ends with less than this left (squared metres and radians) there are more than thirty."""
_NEARLY = 1e-2
"""Starts that end with less than this left (squared metres and radians) are worth a slower, surer descent."""
_PERSISTENT = 3
_SLIDES = 2
_SLIDING_SOLVER = "daqp"
_LINE_STEPS = 8
_LARGEST_JUMP = 0.25
_DIFFERENT = 0.2

__all__ = [
    "LM",
    "ORIENTATION_TOLERANCE",
    "POSITION_TOLERANCE",
    "IkSolution",
    "reachable",
    "solutions",
    "solve_ik",
    "track",
]


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
    _check_target(target)
    robot = load_robot()
    data, kinematics = robot.arm(arm), robot.kinematics(arm)
    first = None if seed is None else _checked_joints(seed, "seed", data.lower, data.upper)
    wished = None if posture is None else _checked_joints(posture, "posture", data.lower, data.upper)
    if restarts < 1:
        raise InvalidGoal(f"inverse kinematics needs at least one start, not restarts={restarts!r}")
    if tool is not None:
        _check_target(tool, "the frame in the hand")
        target = target @ tool.inverse()
    placement = _placement(target)
    last = placement * kinematics.tool_inverse
    lead = _leader(arm, solver, target, last, wished)
    preferred = first if wished is None else wished
    preferred = recipe().home[arm] if preferred is None else preferred
    conflicts: list[Near] = []
    refused: list[Array] = []
    missed: list[Descent] = []
    tried = 0
    for start, surely in _starts(arm, placement, first, preferred, rng, restarts, missed):
        tried += not surely
        descent = persist(kinematics, last, start) if surely else lead(start)
        if not descent.reached:
            if tried == 1:
                checked_distance(data, target)
            missed.append(descent)
            continue
        joints = descent.joints if wished is None else settle(kinematics, last, descent.joints, wished)
        near = None if avoid is None else avoid.nearest(joints)
        if near is None and (accept is None or accept(joints)):
            return _solution(kinematics, joints, placement, tried)
        refused.append(joints)
        if near is not None:
            conflicts.append(near)
            if avoid is not None and avoid.hopeless(near):
                raise in_collision(data, target, [near], len(refused), tried)
    if avoid is not None and conflicts:
        for joints in _mildest(refused, conflicts):
            descent = avoid.slide(joints, target, _SLIDING_SOLVER if solver == LM else solver)
            if descent.reached and avoid.nearest(descent.joints) is None and (accept is None or accept(descent.joints)):
                return _solution(kinematics, descent.joints, placement, tried)
    if refused:
        raise in_collision(data, target, conflicts, len(refused), tried)
    starts = list(_table(arm).starts(placement.translation, placement.rotation, preferred))
    raise out_of_reach(data, kinematics, target, last, starts, tried)


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
    _check_target(target)
    robot = load_robot()
    data, kinematics = robot.arm(arm), robot.kinematics(arm)
    first = None if seed is None else _checked_joints(seed, "seed", data.lower, data.upper)
    preferred = recipe().home[arm] if first is None else first
    placement = _placement(target)
    last = placement * kinematics.tool_inverse
    found: list[Array] = []
    missed: list[Descent] = []
    tried = 0
    for start, surely in _starts(arm, placement, first, preferred, rng, restarts, missed):
        if surely and found:
            return
        tried += not surely
        descent = persist(kinematics, last, start) if surely else descend(kinematics, last, start)
        if not descent.reached:
            if tried == 1:
                checked_distance(data, target)
            missed.append(descent)
        elif all(np.max(np.abs(descent.joints - other)) > _DIFFERENT for other in found):
            found.append(descent.joints)
            yield frozen(descent.joints)
    if not found:
        starts = list(_table(arm).starts(placement.translation, placement.rotation, preferred))
        raise out_of_reach(data, kinematics, target, last, starts, tried)


def reachable(arm: str, targets: Sequence[Pose], *, restarts: int = RESTARTS) -> Array:
    """Which of many targets an arm reaches, boxes and the robot's own body aside.

    Args:
        arm: "left" or "right".
        targets: of the tool frame, in the world's frame.
        restarts: how many starts are tried at most for each.

    Returns:
        (n, 7) joints in radians; a row of NaN for a target that is not reached.

    Raises:
        InvalidGoal: a target is not finite, or there is no such arm.
    """
    robot = load_robot()
    kinematics, home = robot.kinematics(arm), recipe().home[arm]
    found = np.full((len(targets), 7), np.nan)
    for row, target in enumerate(targets):
        _check_target(target)
        placement = _placement(target)
        last = placement * kinematics.tool_inverse
        missed: list[Descent] = []
        for start, surely in _starts(arm, placement, None, home, None, restarts, missed):
            descent = persist(kinematics, last, start) if surely else descend(kinematics, last, start)
            if descent.reached:
                found[row] = descent.joints
                break
            if not missed and too_far(robot.arm(arm), target):
                break
            missed.append(descent)
    return found


def track(arm: str, targets: Sequence[Pose], start: ArrayLike, solver: str = LM) -> list[Array] | None:
    """Joints along a line of nearby targets, each solved from the one before; None when the arm cannot follow.

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
            descent = descend(kinematics, _placement(target) * kinematics.tool_inverse, joints, _LINE_STEPS)
        else:
            from motion.ik.differential import differential_ik  # loads mink

            descent = differential_ik(arm, solver).descend(joints, target, 12)
        if not descent.reached or np.max(np.abs(descent.joints - joints)) > _LARGEST_JUMP:
            return None
        joints = descent.joints
        path.append(joints)
    return path


@lru_cache(maxsize=2)
def _table(arm: str) -> SeedTable:
    robot = load_robot()
    return SeedTable(robot.kinematics(arm), robot.arm(arm).wrist, recipe().home[arm])


def _starts(
    arm: str,
    placement: Any,
    seed: Array | None,
    preferred: Array,
    rng: np.random.Generator | None,
    restarts: int,
    missed: Sequence[Descent],
) -> Iterator[tuple[Array, bool]]:
    """The seed, then the table's configurations near the target, then random ones, then more of the table's.

    The last ones are worth their time only where some start came close; elsewhere there are none. After all of them
    come the best that missed, with True: for a slower, surer descent.
    """
    data, table = load_robot().arm(arm), _table(arm)
    left = restarts
    if seed is not None:
        yield seed, False
        left -= 1
    if left > 0:
        for start in islice(table.starts(placement.translation, placement.rotation, preferred), left):
            yield start, False
            left -= 1
    rng = np.random.default_rng(0) if rng is None else rng
    for _ in range(min(left, _RANDOM)):
        yield rng.uniform(data.lower, data.upper), False
        left -= 1
    if left > 0 and any(descent.left < _CLOSE for descent in missed):
        more = table.starts(placement.translation, placement.rotation, preferred, NEIGHBOURS + left)
        for start in islice(more, NEIGHBOURS, None):
            yield start, False
    nearly = sorted((descent for descent in missed if descent.left < _NEARLY), key=lambda descent: descent.left)
    for descent in nearly[:_PERSISTENT]:
        yield descent.joints, True


def _leader(arm: str, solver: str, target: Pose, last: Any, posture: Array | None) -> Callable[[Array], Descent]:
    """How a start is led to the target."""
    if solver == LM:
        kinematics = load_robot().kinematics(arm)
        return lambda start: descend(kinematics, last, start)
    from motion.ik.differential import differential_ik  # loads mink

    differential = differential_ik(arm, solver)
    return lambda start: differential.descend(start, target, posture=posture)


def _mildest(refused: list[Array], conflicts: list[Near]) -> list[Array]:
    """Of the refused configurations, those in the mildest collisions."""
    order = sorted(range(len(conflicts)), key=lambda index: -conflicts[index].distance)
    return [refused[index] for index in order[:_SLIDES]] if len(refused) == len(conflicts) else []


def _solution(kinematics: Any, joints: Array, placement: Any, tried: int) -> IkSolution:
    left = kinematics.placement(joints).actInv(placement)
    distance, angle = math.hypot(*left.translation.tolist()), math.hypot(*pinocchio.log3(left.rotation).tolist())
    return IkSolution(frozen(joints), distance, angle, tried)


def _placement(target: Pose) -> Any:
    w, x, y, z = target.orientation.tolist()
    unit = (w * w + x * x + y * y + z * z) ** -0.5
    return pinocchio.XYZQUATToSE3(np.array([*target.position.tolist(), x * unit, y * unit, z * unit, w * unit]))


def _check_target(target: Pose, what: str = "the target of inverse kinematics") -> None:
    values = [*target.position.tolist(), *target.orientation.tolist()]
    total = sum(values)
    if len(values) != 7 or total - total != 0:  # NaN and infinity are what differ from themselves
        raise InvalidGoal(f"{what} is not finite, or no position with a quaternion: {target}")
    norm = sum(value * value for value in values[3:]) ** 0.5
    if abs(norm - 1) > 1e-3:
        raise InvalidGoal(f"the orientation of {what} has norm {norm:.6g}; a unit quaternion w, x, y, z is needed")


def _checked_joints(values: ArrayLike, what: str, lower: Array, upper: Array) -> Array:
    joints = np.asarray(values, dtype=np.float64)
    if joints.shape != (7,) or not np.all(np.isfinite(joints)):
        raise InvalidGoal(f"a {what} of inverse kinematics is seven finite joints in radians, not {joints.tolist()}")
    return np.minimum(np.maximum(joints, lower), upper)
