"""Grasps of a box that an arm can really make: joints at the grasp, and free straight lines to it and up from it.

Whoever plans a pick still needs a way from where the arm is to the beginning of the approach; all else is settled here.
"""

from __future__ import annotations

import itertools
from collections import Counter
from typing import NamedTuple

import numpy as np

from motion.collision.checker import CollisionChecker
from motion.collision.clearance import CLOSE, Near, Rules
from motion.collision.grid import SEARCH_GRID
from motion.errors import GraspUnavailable, UnreachableTarget
from motion.grasp.approaches import APPROACH
from motion.grasp.candidates import Grasp, grasp_candidates
from motion.grasp.targets import checked_target
from motion.ik.avoidance import Avoidance
from motion.ik.solver import solve_ik
from motion.path.search import describe, straight
from motion.poses import Array, Pose
from motion.robot.state import ARMS, RobotState
from motion.scene import Scene

Checkers = dict[tuple[str, float], CollisionChecker]
LIFT = 0.10
RESTARTS = 8
_RESTING = 0.003


class Reach(NamedTuple):
    """A grasp that an arm can make.

    Attributes:
        grasp: the grasp.
        joints: (7,) at the grasp, radians.
        approach: configurations along the straight line from before the grasp to it.
        lift: configurations along the straight line from the grasp upwards, the box in the hand.
    """

    grasp: Grasp
    joints: Array
    approach: tuple[Array, ...]
    lift: tuple[Array, ...]


def reach_box(
    scene: Scene, name: str, *, arms: tuple[str, ...] = ARMS, state: RobotState | None = None, every: bool = False
) -> tuple[Reach, ...]:
    """The grasps of a box that can be made among what stands around it, best first.

    Args:
        scene: where everything is.
        name: the box.
        arms: the hands to consider.
        state: where the robot is; home by default. Only the other arm's place, and what it holds, matter.
        every: whether to look for all of them; by default one for each hand and each tilt.

    Raises:
        UnknownBody: there is no such box.
        InvalidGoal: it is fixed, too wide or too narrow, or under another box.
        GraspUnavailable: the fingers overlap a neighbour in every grasp, or every grasp within reach is obstructed.
        UnreachableTarget: no hand gets there; `reason` says why.
    """
    state = RobotState.home() if state is None else state
    checked_target(scene, name, state)
    candidates = grasp_candidates(scene, name, arms)
    found: dict[int, Reach] = {}
    done: set[tuple[str, float]] = set()
    failures: list[UnreachableTarget] = []
    obstructed: list[tuple[int, Grasp]] = []
    checkers: Checkers = {}
    for index, grasp in itertools.chain(enumerate(candidates), obstructed):  # the second grows while the first is used
        kind = (grasp.arm, abs(grasp.tilt))
        if kind in done:
            continue
        try:
            found[index] = _reached(scene, grasp, state, LIFT, RESTARTS, checkers)
        except UnreachableTarget as error:
            failures.append(error)
            narrow = grasp.narrowed()
            if error.reason == "collision" and narrow.opening < grasp.opening:
                obstructed.append((index, narrow))
            continue
        if not every:
            done.add(kind)
    if not found:
        raise _why_none(name, failures)
    return tuple(found[index] for index in sorted(found))


def reach_grasp(
    scene: Scene, grasp: Grasp, *, state: RobotState | None = None, lift: float = LIFT, restarts: int = RESTARTS
) -> Reach:
    """Joints and lines of one grasp.

    Of the arm's many postures at the grasp, the first is taken from which the hand can back off along the approach and
    rise with the box, keeping clear of everything.

    Args:
        scene: where everything is.
        grasp: one of `grasp_candidates`.
        state: where the robot is; home by default.
        lift: how far up, metres.
        restarts: as for `solve_ik`.

    Raises:
        UnreachableTarget: there is none; `reason` says why.
    """
    return _reached(scene, grasp, RobotState.home() if state is None else state, lift, restarts, {})


def _reached(scene: Scene, grasp: Grasp, state: RobotState, lift: float, restarts: int, checkers: Checkers) -> Reach:
    lines = _Lines(scene, grasp, state, lift, checkers)
    avoid = Avoidance(scene, grasp.arm, state=state, rules=lines.near, width=grasp.opening, checker=lines.empty)
    try:
        seed = state.joints(grasp.arm)
        solution = solve_ik(grasp.arm, grasp.tool, seed=seed, restarts=restarts, avoid=avoid, accept=lines.free)
    except UnreachableTarget as error:
        if lines.conflict is None or error.bodies is not None:
            raise
        raise UnreachableTarget(
            f"the {grasp.arm} hand gets to {grasp.box!r}, but not straight there and up: {lines.conflict}",
            "joint limit" if lines.bodies is None else "collision",
            bodies=lines.bodies,
        ) from error
    return Reach(grasp, solution.joints, tuple(lines.approach), tuple(lines.lift))


class _Lines:
    """The straight lines that belong to a grasp, found for one posture after the other."""

    def __init__(self, scene: Scene, grasp: Grasp, state: RobotState, lift: float, checkers: Checkers) -> None:
        self._grasp = grasp
        self._scene, self._state = scene, state
        self._below = scene.below(grasp.box)
        self._top = Pose(grasp.tool.position + np.array([0, 0, lift]), grasp.tool.orientation)
        self.near = Rules(hand_clearance=CLOSE, touching=frozenset({grasp.box}), close=self._below)
        key = (grasp.arm, grasp.opening)
        if key not in checkers:
            checkers[key] = CollisionChecker(scene, state, grasp.arm, width=grasp.opening)
        self.empty = checkers[key]
        self._full: CollisionChecker | None = None
        self.approach: list[Array] = []
        self.lift: list[Array] = []
        self.conflict: str | None = None
        self.bodies: tuple[str, str] | None = None

    def free(self, joints: Array) -> bool:
        """Finds both lines from `joints` (7,), keeps them, and tells whether they can be followed and are free."""
        grasp = self._grasp
        back = self._followed(grasp.backed(APPROACH), joints, self.empty, self.near, "the approach")
        if back is None:
            return False
        if self._full is None:
            grip = grasp.tool.inverse() @ self._scene.box(grasp.box).pose
            self._full = CollisionChecker(
                self._scene, self._state, grasp.arm, width=grasp.width, held=grasp.box, grip=grip
            )
        resting = self._full.around_held(joints, _RESTING)
        beside = self._full.around_held(joints, 0.005)
        rules = Rules(hand_clearance=CLOSE, resting=resting, close=self._below | beside)
        up = self._followed(self._top, joints, self._full, rules, "the lift")
        if up is None:
            return False
        self.approach, self.lift = back[::-1], up
        return True

    def _followed(
        self, last: Pose, joints: Array, checker: CollisionChecker, rules: Rules, what: str
    ) -> list[Array] | None:
        path = straight(self._grasp.arm, self._grasp.tool, last, joints)
        if path is None:
            self.conflict = f"the arm cannot follow the line of {what}"
            return None
        near: Near | None = checker.first_conflict(path, rules, SEARCH_GRID)
        if near is not None:
            self.conflict, self.bodies = f"on {what} {describe(near)}", near.bodies
            return None
        return path


def _why_none(name: str, failures: list[UnreachableTarget]) -> UnreachableTarget | GraspUnavailable:
    """The reason that tells most: obstructions before limits before distance."""
    blocked = [error for error in failures if error.reason == "collision" and error.bodies]
    if blocked:
        bodies = Counter(error.bodies for error in blocked if error.bodies).most_common(1)[0][0]
        example = next(error for error in blocked if error.bodies == bodies)
        return GraspUnavailable(
            f"every grasp of {name!r} that an arm reaches is obstructed, mostly {bodies[0]} by {bodies[1]}; for "
            f"example {example}",
            name,
            bodies,
        )
    limited = [error for error in failures if error.reason == "joint limit"]
    chosen = (limited or failures)[0]
    return UnreachableTarget(
        f"{name!r} cannot be reached by any of {len(failures)} grasps; for example {chosen}",
        chosen.reason,
        chosen.joints,
    )
