"""Ways of a hand to a grasp or a release and away from it: joints and lines, free of contact, not yet timed.

The arm has many postures at a pose of its hand. Each is tried until the lines from it are free as well, and whoever
asks may go on to the next: what the arm cannot reach with the elbow up it may reach with the elbow down.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np

from motion.collision.checker import CollisionChecker
from motion.collision.clearance import CLEARANCE, Near, Rules
from motion.collision.grid import SEARCH_GRID
from motion.errors import MotionError, UnreachableTarget
from motion.grasp.candidates import Grasp
from motion.ik.postures import solutions
from motion.path.search import describe, straight
from motion.path.travel import phase_in_collision
from motion.poses import Array, Pose
from motion.robot.recipe import recipe
from motion.robot.state import RobotState
from motion.scene import Box, Scene

APPROACH = 0.08
"""Length of the straight approach to a grasp, and of the straight way down to a release, metres."""
RESTING = 0.003
"""Within this distance from a held box bodies count as touching it, metres."""
STARTS = 4
"""From how many starts joints are looked for, until there is need to look for more."""
POSTURES = 3
"""Number of postures of the arm that are tried at a pose."""
_RELEASE_HEIGHT = 0.001
_RELEASE_ROOM = 0.007


class Taking(NamedTuple):
    """A grasp that is free, and the lines to it and away from it.

    Attributes:
        grasp: the grasp.
        grip: pose of the box in the tool frame.
        empty: the check of the open hand.
        full: the check of the hand with the box.
        near: rules of the approach.
        rising: rules of the lift.
        back: configurations from the grasp back to where the approach begins.
        up: configurations from the grasp to where the lift ends.
    """

    grasp: Grasp
    grip: Pose
    empty: CollisionChecker
    full: CollisionChecker
    near: Rules
    rising: Rules
    back: list[Array]
    up: list[Array]


class Putting(NamedTuple):
    """A release that is free, and the lines to it and away from it.

    Attributes:
        goal: the box at its destination.
        placed: the scene with the box there.
        opening: of the gripper after the release, metres.
        full: the check of the hand with the box.
        empty: the check of the open hand.
        lowering: rules of the way down.
        leaving: rules of the retreat.
        down: configurations from above the destination to the release.
        away: configurations from the release back along the hand's axis.
    """

    goal: Box
    placed: Scene
    opening: float
    full: CollisionChecker
    empty: CollisionChecker
    lowering: Rules
    leaving: Rules
    down: list[Array]
    away: list[Array]


class Approaches:
    """The lines of one arm among what stands around.

    Args:
        scene: where everything is.
        state: where the robot is.
        arm: the arm that moves.
        rng: source of all chance.
        clearance: distance the hand keeps, near a grasp or a release, from the box's neighbours, metres.
        starts: from how many starts joints are looked for.
    """

    def __init__(
        self,
        scene: Scene,
        state: RobotState,
        arm: str,
        rng: np.random.Generator,
        clearance: float = CLEARANCE,
        starts: int = STARTS,
    ) -> None:
        self._scene, self._state, self._arm, self._rng = scene, state, arm, rng
        self._clearance, self._starts = clearance, starts

    def takings(self, grasp: Grasp, lift: float, seed: Array) -> Iterator[Taking]:
        """Ways of the hand to a box and away with it, by different postures of the arm, the most promising first.

        Args:
            grasp: how the box is taken.
            lift: how far up, metres.
            seed: (7,) joints that the search begins with, radians.

        Raises:
            UnreachableTarget, PlanInCollision: there is none; raised by the first step.
        """
        empty = self.checker(width=grasp.opening)
        below = self._scene.below(grasp.box)
        near = Rules(hand_clearance=self._clearance, touching=frozenset({grasp.box}), close=below)
        grip = grasp.tool.inverse() @ self._scene.box(grasp.box).pose
        top = Pose(grasp.tool.position + np.array([0, 0, lift]), grasp.tool.orientation)
        full: CollisionChecker | None = None
        failures = _Failures(self._arm)
        for joints in failures.free(self._postures(grasp.tool, seed), empty, near):
            try:
                back = line(self._arm, grasp.tool, grasp.backed(APPROACH), joints, empty, near, "approach")
                if full is None:
                    full = self.checker(width=grasp.width, held=grasp.box, grip=grip)
                resting, beside = full.around_held(joints, RESTING), full.around_held(joints, CLEARANCE)
                rising = Rules(hand_clearance=self._clearance, resting=resting, close=below | beside)
                up = line(self._arm, grasp.tool, top, joints, full, rising, "lift")
            except MotionError as error:
                failures.note(error)
                continue
            failures.none = False
            yield Taking(grasp, grip, empty, full, near, rising, back, up)
        failures.tell()

    def puttings(self, goal: Box, support: str, grip: Pose, full: CollisionChecker, width: float) -> Iterator[Putting]:
        """Ways of the hand to a destination and away from it, by different postures of the arm.

        Args:
            goal: the box at its destination.
            support: name of what it will rest on.
            grip: pose of the box in the tool frame.
            full: of the hand with the box.
            width: opening of the gripper with the box in it, metres.

        Raises:
            UnreachableTarget, PlanInCollision: there is none; raised by the first step.
        """
        tool = goal.pose @ grip.inverse()
        release = Pose(tool.position + np.array([0, 0, _RELEASE_HEIGHT]), tool.orientation)
        above = Pose(release.position + np.array([0, 0, APPROACH]), tool.orientation)
        back = Pose(release.position - APPROACH * release.rotation[:, 2], release.orientation)
        below = frozenset({support})
        lowering = Rules(hand_clearance=self._clearance, resting=below, close=below)
        leaving = Rules(hand_clearance=self._clearance, touching=frozenset({goal.name}), close=below)
        placed = self._scene.moved({goal.name: goal.pose})
        opening = release_opening(width)
        empty: CollisionChecker | None = None
        failures = _Failures(self._arm)
        for joints in failures.free(self._postures(release, None), full, lowering):
            try:
                down = line(self._arm, release, above, joints, full, lowering, "lower")[::-1]
                if empty is None:
                    empty = self.checker(width=opening, scene=placed)
                away = line(self._arm, release, back, joints, empty, leaving, "retreat")
            except MotionError as error:
                failures.note(error)
                continue
            failures.none = False
            yield Putting(goal, placed, opening, full, empty, lowering, leaving, down, away)
        failures.tell()

    def checker(
        self, *, width: float, held: str | None = None, grip: Pose | None = None, scene: Scene | None = None
    ) -> CollisionChecker:
        """A check of the arm with so wide a gripper and what it holds."""
        return CollisionChecker(
            self._scene if scene is None else scene, self._state, self._arm, width=width, held=held, grip=grip
        )

    def _postures(self, tool: Pose, seed: Array | None) -> Iterator[Array]:
        return islice(solutions(self._arm, tool, seed=seed, rng=self._rng, restarts=self._starts), POSTURES)


def release_opening(width: float) -> float:
    """The opening of the gripper after it let a box of this width go, metres."""
    return min(recipe().gripper.opened, width + 2 * _RELEASE_ROOM)


def line(
    arm: str, first: Pose, last: Pose, joints: Array, checker: CollisionChecker, rules: Rules, phase: str
) -> list[Array]:
    """Configurations along a straight line of the tool that is free by `rules`.

    Args:
        arm: "left" or "right".
        first: pose of the tool at the beginning; its orientation is kept.
        last: at the end.
        joints: (7,) at `first`, radians.
        checker: the world around, and what the hand holds.
        rules: what may be near to what.
        phase: its name, for errors.

    Raises:
        UnreachableTarget: the arm cannot follow.
        PlanInCollision: the line comes too near to something.
    """
    path = straight(arm, first, last, joints)
    if path is None:
        raise UnreachableTarget(f"the {arm} arm cannot follow the straight line of {phase}", "joint limit")
    near = checker.first_conflict(path, rules, SEARCH_GRID)
    if near is not None:
        raise phase_in_collision(phase, near, rules)
    return path


class _Failures:
    """Reasons why no posture would do: conflicts of the postures themselves, else what was wrong with the lines."""

    def __init__(self, arm: str) -> None:
        self._arm = arm
        self._conflicts: list[Near] = []
        self._errors: list[MotionError] = []
        self.none = True

    def free(self, postures: Iterator[Array], checker: CollisionChecker, rules: Rules) -> Iterator[Array]:
        """Those of the postures that are free."""
        for joints in postures:
            near = checker.nearest(joints, rules)
            if near is None:
                yield joints
                continue
            self._conflicts.append(near)
            if checker.of_hand(near):  # the hand is where it must be, whatever the posture
                return

    def note(self, error: MotionError) -> None:
        """The lines of a posture are not free."""
        self._errors.append(error)

    def tell(self) -> None:
        """Raises the reason, unless something was found.

        Raises:
            UnreachableTarget, PlanInCollision: nothing was found.
        """
        if not self.none:
            return
        if self._errors:
            raise self._errors[0]
        bodies = Counter(near.bodies for near in self._conflicts).most_common(1)[0][0]
        near = next(near for near in self._conflicts if near.bodies == bodies)
        raise UnreachableTarget(
            f"the {self._arm} arm gets there only in collision ({len(self._conflicts)} postures): {describe(near)}",
            "collision",
            bodies=bodies,
        )
