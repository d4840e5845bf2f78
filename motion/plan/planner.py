"""Plans for a pick, a place and the way home: grasps are tried in order until one yields a plan that is verified."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from motion.errors import InvalidGoal
from motion.grasp.candidates import Grasp, grasp_candidates
from motion.grasp.targets import checked_arms, checked_target
from motion.plan.attempts import BRIEF, THOROUGH, Attempt, Effort
from motion.plan.budget import BUDGET, Budget
from motion.plan.failures import Failures
from motion.plan.goals import checked_destination, checked_lift, checked_start, heading, positions
from motion.plan.plans import Plan
from motion.plan.room import Room
from motion.plan.ways import Goals, Ways, first_plan
from motion.robot.recipe import recipe
from motion.robot.state import ARMS, RobotState
from motion.scene import LEANING, Box, Scene

LIFT = 0.10
_SHALLOWER = (0.008, 0.014, 0.0)
_QUARTERS = (0.0, np.pi / 2, -np.pi / 2, np.pi)
_FREE_TURNS = (0.0, np.pi / 4, -np.pi / 4, np.pi / 2)
"""Headings besides its own that a box may get, radians; half a turn later it looks the same."""
_MORE_STARTS = 12


def plan_pick(
    scene: Scene,
    target: str,
    *,
    arm: str = "auto",
    start: RobotState | None = None,
    rng: np.random.Generator | None = None,
    lift: float = LIFT,
    budget: float = BUDGET,
) -> Plan:
    """A verified plan that takes a box and holds it above where it stood.

    Args:
        scene: where everything is.
        target: name of the box.
        arm: "left", "right", or "auto" for whichever does it better.
        start: where the robot is; home by default.
        rng: source of all chance; a fixed seed by default. The same seed gives the same plan.
        lift: how far up, metres.
        budget: processor time that planning may take, seconds.

    Raises:
        UnknownBody: there is no such box.
        InvalidGoal: it is fixed, covered, or too wide; no hand is free; or `arm`, `start` or `lift` make no sense.
        UnreachableTarget: no hand gets there; `reason` says why.
        GraspUnavailable: every grasp is obstructed by what stands around the box.
        PlanInCollision, PathNotFound, LimitViolation: grasps exist, but no free way to them was found.
        OutOfTime: the budget was used up.
    """
    start = RobotState.home() if start is None else checked_start(start)
    rng = np.random.default_rng(0) if rng is None else rng
    checked_target(scene, target, start)
    arms, lift = checked_arms(arm, start, target), checked_lift(lift)
    failures, time = Failures(target), Budget(budget, target)
    ways = Ways(scene, start, target, rng, lift, failures)
    for effort, grasps in _rounds(scene, target, arms, failures):
        plan = first_plan((ways.picks(grasp, effort) for grasp in grasps), time)
        if plan is not None:
            return plan
    raise failures.summary()


def plan_place(
    scene: Scene,
    target: str,
    position: ArrayLike,
    *,
    yaw: float | None = None,
    arm: str = "auto",
    start: RobotState | None = None,
    rng: np.random.Generator | None = None,
    budget: float = BUDGET,
) -> Plan:
    """A verified plan that takes a box, sets it down elsewhere and goes home. A box already in a hand is only set down.

    Of several places the first one is preferred; another is taken where no hand can serve it, rather one of the first.

    Args:
        scene: where everything is.
        target: name of the box.
        position: (3,) where its centre shall be, resting on the table or on another box, metres; or (n, 3) places of
            which one will do, the best first.
        yaw: direction of its first level edge, radians (see `goals.heading`); by default the box keeps its heading if
            it can.
        arm: "left", "right", or "auto".
        start: where the robot is; home by default.
        rng: source of all chance; a fixed seed by default.
        budget: processor time that planning may take, seconds.

    Raises:
        InvalidGoal: as for `plan_pick`, or the destination is not finite, occupied, unsupported or off the table.
        MotionError: everything else as for `plan_pick`.
    """
    start = RobotState.home() if start is None else checked_start(start)
    rng = np.random.default_rng(0) if rng is None else rng
    arms = checked_arms(arm, start, target)
    box = checked_target(scene, target, start)
    places = _places(scene, box, position, yaw)
    failures, time = Failures(target), Budget(budget, target)
    ways = Ways(scene, start, target, rng, LIFT, failures)
    if target in start.held.values():
        for groups, tight in itertools.product(places, (False, True)):
            for goals in groups:
                plan = first_plan([ways.lays(arms[0], Effort(THOROUGH, tight, _MORE_STARTS), goals)], time)
                if plan is not None:
                    return plan
        raise failures.summary()
    for effort, grasps in _rounds(scene, target, arms, failures):
        room = Room(scene, box, grasps, failures)
        for groups in places:
            for goals in groups:
                free = room.releases(goals)
                plan = first_plan((ways.places(grasp, effort, there) for grasp, there in free), time)
                if plan is not None:
                    return plan
    raise failures.summary()


def plan_home(
    scene: Scene, *, arm: str = "auto", start: RobotState | None = None, rng: np.random.Generator | None = None
) -> Plan:
    """A verified plan that brings one arm home, backing out of whatever its fingers surround; what it holds it keeps.

    Args:
        scene: where everything is.
        arm: "left" or "right"; "auto" is the one that is farther from home.
        start: where the robot is; home by default.
        rng: source of all chance; a fixed seed by default.

    Raises:
        InvalidGoal: there is no such arm.
        PlanInCollision, PathNotFound: there is no free way.
    """
    start = RobotState.home() if start is None else checked_start(start)
    rng = np.random.default_rng(0) if rng is None else rng
    if arm not in ("auto", *ARMS):
        raise InvalidGoal(f"there is no arm {arm!r}; there are 'left', 'right' and 'auto'")
    if arm == "auto":
        distances = {side: float(np.max(np.abs(start.joints(side) - recipe().home[side]))) for side in ARMS}
        arm = max(ARMS, key=lambda side: distances[side])
    attempt = Attempt(scene, start, arm, start.held.get(arm), rng)
    attempt.go_home()
    return attempt.finished("home", None)


def _rounds(
    scene: Scene, target: str, arms: tuple[str, ...], failures: Failures
) -> Iterator[tuple[Effort, list[Grasp]]]:
    """Grasps to try, and how hard.

    First all of them, then the obstructed ones with the fingers opened less, at last those that only lacked a path.
    """
    grasps = grasp_candidates(scene, target, arms)
    if scene.box(target).lean > LEANING:  # upright again, it brings the fingertips nearer to the table
        grasps = [replace(grasp, tool=grasp.backed(less)) for less in _SHALLOWER for grasp in grasps]
    yield Effort(BRIEF), grasps
    yield Effort(BRIEF, tight=True, starts=_MORE_STARTS), [grasp.narrowed() for grasp in failures.obstructed()]
    yield Effort(THOROUGH, tight=True, starts=_MORE_STARTS), failures.without_path()


def _places(scene: Scene, box: Box, position: ArrayLike, yaw: float | None) -> list[tuple[Goals, ...]]:
    """The places that are free, each as the box there in every turn to be tried.

    Raises:
        InvalidGoal: none is.
    """
    found: list[tuple[Goals, ...]] = []
    first: InvalidGoal | None = None
    for place in positions(box.name, position):
        try:
            found.append(_goals(scene, box, place, yaw))
        except InvalidGoal as error:
            first = first or error
    if not found:
        assert first is not None
        raise first
    return found


def _goals(scene: Scene, box: Box, position: ArrayLike, yaw: float | None) -> tuple[Goals, ...]:
    """The box at its destination in every turn to be tried, best first, each with what it rests on.

    They come in groups: those of one group look the same from above.

    Raises:
        InvalidGoal: it cannot be there.
    """
    alike = np.array(_QUARTERS) if _square(box) else np.array([0.0, np.pi])
    groups: list[list[tuple[Box, str]]] = []
    first: InvalidGoal | None = None
    for more in (0.0,) if yaw is not None else _FREE_TURNS if not _square(box) else _FREE_TURNS[:2]:
        wanted = more if yaw is None else yaw - heading(box)
        turns = (wanted + alike + np.pi) % (2 * np.pi) - np.pi
        group: list[tuple[Box, str]] = []
        for turn in turns[np.argsort(np.abs(turns), kind="stable")]:
            try:
                group.append(checked_destination(scene, box.name, position, float(turn)))
            except InvalidGoal as error:
                first = first or error
        if group:
            groups.append(group)
    if not groups and first is not None:
        raise first
    return tuple(tuple(group) for group in groups)


def _square(box: Box) -> bool:
    """Tells whether the box looks the same from above after a quarter turn."""
    level = [i for i in range(3) if abs(box.axes[2, i]) < 0.7]
    return len(level) == 2 and abs(box.size[level[0]] - box.size[level[1]]) < 1e-4
