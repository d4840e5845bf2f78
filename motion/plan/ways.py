"""The ways to carry out a goal, and the order in which they are worked out: those without a detour first.

A way is a grasp, a posture of the arm at it, one at the release, and what is between. Where the straight line in joint
space is not free, another posture, another grasp, or another of the turns in which the box looks the same, is often all
it takes; a search for a path costs more than all of them, and what it finds takes longer to run along.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from motion.collision.checker import CollisionChecker
from motion.errors import MotionError, UnreachableTarget
from motion.grasp.approaches import Putting, Taking
from motion.grasp.candidates import Grasp
from motion.ik.solver import solve_ik
from motion.plan.attempts import Attempt, Effort
from motion.plan.budget import Budget
from motion.plan.failures import Failures
from motion.plan.plans import Plan
from motion.poses import Array, Pose
from motion.robot.state import RobotState
from motion.scene import Box, Scene

Goals = tuple[tuple[Box, str], ...]
"""Destinations that look the same, best first: the box there, and the name of what it rests on."""

_DETOURS = 2
"""Of the ways of one grasp that are not direct, how many are searched for a path."""
_WINDOW = 8
"""Number of grasps that are looked at for a direct way before paths are searched for."""
_FAR = 0.5
"""Movement of a joint, in radians, that the line of an approach or a lift exceeds only near a singular posture."""
_QUICK = 2
"""Starts of a first look at whether a destination can be reached."""
_Item = TypeVar("_Item")


class Way(NamedTuple):
    """One way to carry out a goal.

    Attributes:
        detours: on how many of its parts the straight line in joint space is not free, or that of the tool is strained.
        plan: works it out; None where that fails.
    """

    detours: int
    plan: Callable[[], Plan | None]


class Ways:
    """The ways to pick a box up or to put it down; what one of them needs is remembered for the others.

    Args:
        scene: where everything is.
        start: where the robot is.
        target: name of the box.
        rng: source of all chance.
        lift: how far it is lifted before anything else, metres.
        failures: where failures are noted.
    """

    def __init__(
        self, scene: Scene, start: RobotState, target: str, rng: np.random.Generator, lift: float, failures: Failures
    ) -> None:
        self._scene, self._start, self._target, self._rng = scene, start, target, rng
        self._lift, self._failures = lift, failures
        self._grasped: dict[tuple[int, Effort], tuple[Grasp, Attempt, _Remembered[Taking]]] = {}
        self._releases: dict[Hashable, MotionError] = {}
        self._unreached: dict[Hashable, MotionError] = {}

    def picks(self, grasp: Grasp, effort: Effort) -> Iterator[Way]:
        """The ways to take the box with this grasp."""
        attempt, takings = self._takings(grasp, effort)

        def worked_out(taking: Taking) -> Plan | None:
            taken = self._taken(attempt, taking)
            box = self._scene.box(self._target)
            goal = Pose(box.position + np.array([0, 0, self._lift]), box.orientation)
            return None if taken is None else taken.finished("pick", goal)

        for taking in takings:
            detours = int(not attempt.leads_straight_to(taking)) + _strained(taking.back, taking.up)
            yield Way(detours, lambda taking=taking: worked_out(taking))  # type: ignore[misc]

    def places(self, grasp: Grasp, effort: Effort, goals: Goals) -> Iterator[Way]:
        """The ways to take the box with this grasp and to set it down at one of the goals."""
        if not self._within_reach(grasp, goals):
            return
        attempt, takings = self._takings(grasp, effort)
        puttings: _Remembered[Putting] | None = None
        for taking in takings:
            if puttings is None:  # they depend on the grip alone, not on the posture in which the box is taken
                found = self._puttings(attempt, goals, taking.grip, taking.full, grasp.width, grasp)
                puttings = _Remembered(found)
            to = int(not attempt.leads_straight_to(taking)) + _strained(taking.back, taking.up)
            taken = _Once(lambda taking=taking: self._taken(attempt, taking))  # type: ignore[misc]
            for putting in puttings:
                detours = to + attempt.detours_on(taking.up[-1], putting) + _strained(putting.down, putting.away)
                yield Way(detours, lambda putting=putting, taken=taken: self._put(taken(), putting, grasp))  # type: ignore[misc]
            if not puttings:
                break

    def lays(self, arm: str, effort: Effort, goals: Goals) -> Iterator[Way]:
        """The ways to set down, at one of the goals, what the hand holds from the start."""
        attempt = Attempt(self._scene, self._start, arm, self._target, self._rng, effort)
        attempt.already_holding()
        assert attempt.grip is not None
        width = attempt.held_width()
        full = attempt.approaches.checker(width=width, held=self._target, grip=attempt.grip)
        for putting in self._puttings(attempt, goals, attempt.grip, full, width, None):
            detours = attempt.detours_on(attempt.joints, putting) + _strained(putting.down, putting.away)
            yield Way(detours, lambda putting=putting: self._put(attempt, putting, None))  # type: ignore[misc]

    def _within_reach(self, grasp: Grasp, goals: Goals) -> bool:
        """Tells whether the hand gets to where one of the goals would have it: a quick look before all else."""
        grip = grasp.tool.inverse() @ self._scene.box(self._target).pose
        error: MotionError | None = None
        for goal, _ in goals:
            tool = goal.pose @ grip.inverse()
            key = _place_of_hand(grasp.arm, tool)
            if key not in self._unreached:
                try:
                    solve_ik(grasp.arm, tool, rng=self._rng, restarts=_QUICK)
                    return True
                except UnreachableTarget as unreachable:
                    self._unreached[key] = unreachable
            error = self._unreached[key]
        if error is not None:
            self._failures.note(grasp, error)
        return False

    def _takings(self, grasp: Grasp, effort: Effort) -> tuple[Attempt, _Remembered[Taking]]:
        key = (id(grasp), effort)
        if key not in self._grasped:  # with the grasp itself, so that its id stays its own
            attempt = Attempt(self._scene, self._start, grasp.arm, self._target, self._rng, effort)
            self._grasped[key] = grasp, attempt, _Remembered(self._found(attempt, grasp))
        return self._grasped[key][1:]

    def _found(self, attempt: Attempt, grasp: Grasp) -> Iterator[Taking]:
        try:
            yield from attempt.takings(grasp, self._lift)
        except MotionError as error:
            self._failures.note(grasp, error)

    def _puttings(
        self, attempt: Attempt, goals: Goals, grip: Pose, full: CollisionChecker, width: float, grasp: Grasp | None
    ) -> Iterator[Putting]:
        for goal, support in goals:
            # A cube has many grasps that put the hand at the same place: where that failed, it fails again.
            key = attempt.effort, width, *_place_of_hand(attempt.arm, goal.pose @ grip.inverse())
            if key in self._releases:
                self._failures.note(grasp, self._releases[key])
                continue
            try:
                yield from attempt.approaches.puttings(goal, support, grip, full, width)
            except MotionError as error:
                self._releases[key] = error
                self._failures.note(grasp, error)

    def _taken(self, attempt: Attempt, taking: Taking) -> Attempt | None:
        branch = attempt.copy()
        try:
            branch.take(taking)
        except MotionError as error:
            self._failures.note(taking.grasp, error)
            return None
        return branch

    def _put(self, attempt: Attempt | None, putting: Putting, grasp: Grasp | None) -> Plan | None:
        if attempt is None:
            return None
        branch = attempt.copy()
        try:
            branch.put(putting)
        except MotionError as error:
            self._failures.note(grasp, error)
            return None
        return branch.finished("place", putting.goal.pose)


def first_plan(grasps: Iterable[Iterator[Way]], time: Budget) -> Plan | None:
    """The first plan that works out, or None.

    Direct ways are worked out as they are found. The others wait until some grasps have been looked at; then those with
    the fewest detours go first.

    Args:
        grasps: the ways of each grasp, the best grasp first.
        time: that may be taken.

    Raises:
        OutOfTime: it was used up.
    """
    waiting: list[Way] = []
    for number, ways in enumerate(time.spend(grasps), start=1):
        others: list[Way] = []
        for way in time.spend(ways):
            if way.detours:
                others.append(way)
            elif (plan := way.plan()) is not None:
                return plan
        waiting += sorted(others, key=_detours)[:_DETOURS]
        if number % _WINDOW == 0:
            plan = _worked_out(waiting, time)
            if plan is not None:
                return plan
            waiting = []
    return _worked_out(waiting, time)


def _worked_out(ways: Sequence[Way], time: Budget) -> Plan | None:
    for way in time.spend(sorted(ways, key=_detours)):
        plan = way.plan()
        if plan is not None:
            return plan
    return None


def _detours(way: Way) -> int:
    return way.detours


def _strained(*lines: Sequence[Array]) -> int:
    """On how many straight lines of the tool some joint moves far: near a singular posture that takes seconds."""
    return sum(float(np.sum(np.abs(np.diff(line, axis=0)), axis=0).max()) > _FAR for line in lines)


def _place_of_hand(arm: str, tool: Pose) -> tuple[Hashable, ...]:
    """The hand and where it is, to a tenth of a millimetre."""
    values: Array = np.round([*tool.position, *tool.rotation[:, 1], *tool.rotation[:, 2]], 4) + 0.0
    return arm, *values.tolist()


class _Remembered(Generic[_Item]):
    """Items of an iterator, asked for when they are first needed, and remembered. True once there is one."""

    def __init__(self, items: Iterator[_Item]) -> None:
        self._items, self._known = items, list[_Item]()

    def __iter__(self) -> Iterator[_Item]:
        yield from self._known
        for item in self._items:
            self._known.append(item)
            yield item

    def __bool__(self) -> bool:
        return bool(self._known)


class _Once(Generic[_Item]):
    """A value that is worked out when it is first asked for."""

    def __init__(self, work: Callable[[], _Item]) -> None:
        self._work, self._value = work, list[_Item]()

    def __call__(self) -> _Item:
        if not self._value:
            self._value.append(self._work())
        return self._value[0]
