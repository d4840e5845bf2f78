"""One attempt at a plan: phases are added one by one, each timed and verified, free of contact where none is meant."""

from __future__ import annotations

import copy
from collections import Counter
from functools import partial
from typing import NamedTuple

import numpy as np

from motion.collisions import CLEARANCE, CLOSE, GRID, SEARCH_GRID, CollisionChecker, Near, Rules
from motion.errors import MotionError, PlanInCollision, UnreachableTarget
from motion.grasps import Grasp
from motion.ik import solve_ik
from motion.paths import connect, describe, straight
from motion.plans import Phase, Plan
from motion.poses import Array, Pose
from motion.recipe import recipe
from motion.robot import load_robot
from motion.scene import Box, Scene
from motion.smoothing import smoothed
from motion.state import RobotState
from motion.timing import KNOT_SPACINGS, LINE_SPACING, Trajectory, check_limits, rest, timed

APPROACH = 0.08
BRIEF, THOROUGH = 40, 400
"""Expansions of a search for a path: at first, to see whether another grasp does better, and at last."""
_RESTING = 0.003
_RELEASE_HEIGHT = 0.001
_RELEASE_ROOM = 0.007
_AT_HOME = 1e-3
_CLOSING_TIME = 0.4
_OPENING_TIME = 0.3
_HOLDING_TIME = 0.2
_RESTARTS = 4
_TURNS_CHECKED = 4
_LINES = ("approach", "lift", "lower", "retreat")


class Taking(NamedTuple):
    """A grasp that is free, and the lines to it and away from it; see `Attempt.prepare_take`."""

    grasp: Grasp
    grip: Pose
    empty: CollisionChecker
    full: CollisionChecker
    near: Rules
    rising: Rules
    back: list[Array]
    up: list[Array]


class Putting(NamedTuple):
    """A release that is free, and the lines to it and away from it; see `Attempt.prepare_put`."""

    placed: Scene
    opening: float
    full: CollisionChecker
    empty: CollisionChecker
    lowering: Rules
    leaving: Rules
    down: list[Array]
    away: list[Array]


class Attempt:
    """A plan in the making.

    Args:
        scene: where everything is.
        state: where the robot is.
        arm: the arm that moves.
        target: the box it is about, or None.
        rng: source of all chance.
        expansions: bound of each search for a path whose straight line is not free.
        tight: whether near its grasp the hand may come closer to the box's neighbours than everywhere else.
    """

    def __init__(
        self,
        scene: Scene,
        state: RobotState,
        arm: str,
        target: str | None,
        rng: np.random.Generator,
        expansions: int = THOROUGH,
        tight: bool = False,
    ) -> None:
        self.scene, self.state, self.arm, self.target, self.rng = scene, state, arm, target, rng
        self.expansions = expansions
        self.clearance = CLOSE if tight else CLEARANCE
        self.joints: Array = state.joints(arm)
        self.width = state.widths[arm]
        self.grasp: Grasp | None = None
        self.grip: Pose | None = None
        self.taken = False
        self._robot = load_robot()
        self._phases: list[Phase] = []

    def copy(self) -> Attempt:
        """An attempt that begins with the same phases."""
        twin = copy.copy(self)
        twin._phases = list(self._phases)
        return twin

    # The steps of a pick.

    def take(self, grasp: Grasp, lift: float) -> None:
        """Adds the phases from where the robot is to the box lifted."""
        self.commit_take(self.prepare_take(grasp, lift))

    def prepare_take(self, grasp: Grasp, lift: float) -> Taking:
        """How the hand comes to the box and away with it: joints and straight lines, free of contact, not yet timed."""
        empty = self._checker(width=grasp.opening)
        below = self.scene.below(grasp.box)
        near = Rules(hand_clearance=self.clearance, touching=frozenset({grasp.box}), close=below)
        at_grasp = self._reach(grasp.tool, empty, near, self.joints)
        back = self._line(grasp.tool, grasp.backed(APPROACH), at_grasp, empty, near, "approach")
        grip = grasp.tool.inverse() @ self.scene.box(grasp.box).pose
        full = self._checker(width=grasp.width, held=grasp.box, grip=grip)
        beside = full.around_held(at_grasp, CLEARANCE)
        rising = Rules(hand_clearance=self.clearance, resting=self._touched(full, at_grasp), close=below | beside)
        top = Pose(grasp.tool.position + np.array([0, 0, lift]), grasp.tool.orientation)
        up = self._line(grasp.tool, top, at_grasp, full, rising, "lift")
        return Taking(grasp, grip, empty, full, near, rising, back, up)

    def commit_take(self, taking: Taking) -> None:
        """Adds what was prepared, timed and verified."""
        grasp, empty = taking.grasp, taking.empty
        self.grasp = grasp
        self._home_first()
        self._add("pregrasp", self._travel("pregrasp", self.joints, taking.back[-1], empty, Rules()), grasp.opening)
        self._add("approach", self._verified("approach", taking.back[::-1], empty, taking.near), grasp.opening)
        self._pause("close", _CLOSING_TIME, grasp.width - recipe().gripper.squeeze)
        self.grip, self.taken = taking.grip, True
        self._add("lift", self._verified("lift", taking.up, taking.full, taking.rising), self.width)

    def already_holding(self) -> None:
        """The box is in the hand from the start."""
        tool = self._robot.tool_pose(self.arm, self.joints)
        assert self.target is not None
        self.grip = tool.inverse() @ self.scene.box(self.target).pose
        self.width = self._held_width() - recipe().gripper.squeeze
        self.taken = True

    def check_put(self, grasp: Grasp, goals: list[tuple[Box, str]]) -> None:
        """Refuses a grasp early when its hand cannot be where the best of the destinations would have it.

        Raises:
            UnreachableTarget: for all of them.
        """
        grip = grasp.tool.inverse() @ self.scene.box(grasp.box).pose
        error: MotionError | None = None
        for goal, _ in goals[:_TURNS_CHECKED]:
            try:
                solve_ik(self.arm, goal.pose @ grip.inverse(), rng=self.rng, restarts=2)
                return
            except UnreachableTarget as unreachable:
                error = unreachable
        if error is not None:
            raise error

    # The steps of a place.

    def put(self, goal: Box, support: str) -> None:
        """Adds the phases from the held box to the box at its destination and the arm at home."""
        assert self.grip is not None
        full = self._checker(width=self._held_width(), held=self.target, grip=self.grip)
        self.commit_put(self.prepare_put(goal, support, self.grip, full, self._held_width()))

    def prepare_put(self, goal: Box, support: str, grip: Pose, full: CollisionChecker, width: float) -> Putting:
        """How the hand comes to the destination and away from it: joints and straight lines, not yet timed.

        Args:
            goal: the box at its destination.
            support: name of what it will rest on.
            grip: pose of the box in the tool frame.
            full: of the hand with the box.
            width: opening of the gripper with the box in it, metres.
        """
        assert self.target is not None
        tool = goal.pose @ grip.inverse()
        release = Pose(tool.position + np.array([0, 0, _RELEASE_HEIGHT]), tool.orientation)
        above = Pose(release.position + np.array([0, 0, APPROACH]), tool.orientation)
        below = frozenset({support})
        lowering = Rules(hand_clearance=self.clearance, resting=below, close=below)
        at_release = self._reach(release, full, lowering, None)
        down = self._line(release, above, at_release, full, lowering, "lower")[::-1]
        placed = self.scene.moved({self.target: goal.pose})
        opening = min(recipe().gripper.opened, width + 2 * _RELEASE_ROOM)
        empty = self._checker(width=opening, scene=placed)
        leaving = Rules(hand_clearance=self.clearance, touching=frozenset({self.target}), close=below)
        back = Pose(release.position - APPROACH * release.rotation[:, 2], release.orientation)
        away = self._line(release, back, at_release, empty, leaving, "retreat")
        return Putting(placed, opening, full, empty, lowering, leaving, down, away)

    def commit_put(self, putting: Putting) -> None:
        """Adds what was prepared, timed and verified."""
        full, empty, opening = putting.full, putting.empty, putting.opening
        self._rise(full)
        rising = Rules(resting=self._touched(full, self.joints))
        across = self._travel("transfer", self.joints, putting.down[0], full, rising)
        self._add("transfer", across, self.width)
        self._add("lower", self._verified("lower", putting.down, full, putting.lowering), self.width)
        self._pause("open", _OPENING_TIME, opening)
        self.scene, self.grip, self.taken = putting.placed, None, False
        self._add("retreat", self._verified("retreat", putting.away, empty, putting.leaving), opening)
        self._add("home", self._travel("home", self.joints, recipe().home[self.arm], empty, Rules()), opening)

    def go_home(self) -> None:
        """Adds the phases that bring the arm home from wherever it is."""
        home = recipe().home[self.arm]
        held = self.state.held.get(self.arm)
        if held is not None:
            self.already_holding()
        checker = self._checker(width=self.state.widths[self.arm], held=held, grip=self.grip)
        self._back_out(checker)
        self._add("home", self._travel("home", self.joints, home, checker, Rules()), self.width)

    # The whole.

    def finished(self, kind: str, goal: Pose | None) -> Plan:
        """The plan. Every phase was checked against limits and contact, sample by sample, when it was added."""
        if self.taken:
            self._phases.append(self._still("hold", _HOLDING_TIME, self.width))
        widths = {**self.state.widths, self.arm: self._held_width() if self.taken else self.width}
        held = {side: name for side, name in self.state.held.items() if side != self.arm}
        if self.taken and self.target is not None:
            held[self.arm] = self.target
        ends = {"left": self.state.left, "right": self.state.right, self.arm: self.joints}
        return Plan(
            kind=kind,
            arm=self.arm,
            target=self.target,
            phases=tuple(self._phases),
            grasp=self.grasp,
            goal=goal,
            start=self.state,
            end=RobotState(ends["left"], ends["right"], widths, held),
            clearance=self.clearance,
        )

    # Helpers.

    def _checker(
        self, *, width: float, held: str | None = None, grip: Pose | None = None, scene: Scene | None = None
    ) -> CollisionChecker:
        return CollisionChecker(
            self.scene if scene is None else scene, self.state, self.arm, width=width, held=held, grip=grip
        )

    def _reach(self, tool: Pose, checker: CollisionChecker, rules: Rules, seed: Array | None) -> Array:
        """Joints at `tool` that `rules` allow, looked for from `seed` first."""
        conflicts: list[Near] = []

        def accept(joints: Array) -> bool:
            near = checker.nearest(joints, rules)
            if near is not None:
                conflicts.append(near)
            return near is None

        try:
            return solve_ik(self.arm, tool, seed=seed, rng=self.rng, restarts=_RESTARTS, accept=accept).joints
        except UnreachableTarget as error:
            if not conflicts:
                raise
            bodies = Counter(near.bodies for near in conflicts).most_common(1)[0][0]
            near = next(near for near in conflicts if near.bodies == bodies)
            raise UnreachableTarget(f"{error}: {describe(near)}", "collision", bodies=bodies) from error

    def _line(
        self, first: Pose, last: Pose, joints: Array, checker: CollisionChecker, rules: Rules, phase: str
    ) -> list[Array]:
        """A straight line of the tool that is free by `rules`."""
        path = straight(self.arm, first, last, joints)
        if path is None:
            raise UnreachableTarget(f"the {self.arm} arm cannot follow the straight line of {phase}", "joint limit")
        near = checker.first_conflict(path, rules, SEARCH_GRID)
        if near is not None:
            raise _in_collision(phase, near, rules)
        return path

    def _travel(self, phase: str, first: Array, last: Array, checker: CollisionChecker, rules: Rules) -> Trajectory:
        """A verified trajectory from `first` to `last`, searched for on the coarse grid first, then on the fine.

        A path that is not straight is smoothed; of both, the one with the quicker trajectory is taken.
        """
        arm = self._robot.arm(self.arm)
        error: PlanInCollision | None = None
        for grid in (SEARCH_GRID, GRID):
            path = connect(checker, self.arm, first, last, rules, self.rng, phase, self.expansions, grid)
            options = [path]
            if len(path) > 2:
                options.insert(0, smoothed(path, checker, rules, arm, partial(checker.free, rules=rules, grid=grid)))
            found = []
            for option in options:
                try:
                    found.append(self._verified(phase, option, checker, rules))
                except PlanInCollision as refusal:
                    error = refusal
            if found:
                return min(found, key=lambda trajectory: trajectory.duration)
        assert error is not None
        raise error

    def _touched(self, checker: CollisionChecker, joints: Array) -> frozenset[str]:
        """Names of what the held box touches at `joints`."""
        return checker.around_held(joints, _RESTING)

    def _home_first(self) -> None:
        """Brings an empty hand home, unless it is there."""
        home = recipe().home[self.arm]
        if np.max(np.abs(self.joints - home)) <= _AT_HOME:
            self._phases.append(self._still("home", 0.0, self.width))
            return
        checker = self._checker(width=self.width)
        self._back_out(checker)
        self._add("home", self._travel("home", self.joints, home, checker, Rules()), self.width)

    def _rise(self, full: CollisionChecker) -> None:
        """Adds a lift if the held box still stands where it was taken, too near to something to move freely."""
        touched = self._touched(full, self.joints)
        if self.target is None or full.nearest(self.joints, Rules(resting=touched)) is None:
            return
        close = touched | full.around_held(self.joints, CLEARANCE) | self.scene.below(self.target)
        rules = Rules(hand_clearance=CLOSE, resting=touched, close=close)
        tool = self._robot.tool_pose(self.arm, self.joints)
        top = Pose(tool.position + np.array([0, 0, APPROACH]), tool.orientation)
        line = self._line(tool, top, self.joints, full, rules, "lift")
        self._add("lift", self._verified("lift", line, full, rules), self.width)

    def _back_out(self, checker: CollisionChecker) -> None:
        """Adds a straight retreat along the approach if the hand is too near to something to move freely."""
        if checker.nearest(self.joints, Rules()) is None:
            return
        tool = self._robot.tool_pose(self.arm, self.joints)
        rules = Rules(
            touching=frozenset(box.name for box in self.scene.boxes if not box.fixed),
            resting=self._touched(checker, self.joints),
            hand_clearance=-0.002,
        )
        back = Pose(tool.position - APPROACH * tool.rotation[:, 2], tool.orientation)
        line = self._line(tool, back, self.joints, checker, rules, "retreat")
        self._add("retreat", self._verified("retreat", line, checker, rules), self.width)

    def _add(self, name: str, trajectory: Trajectory, width: float) -> None:
        self._phases.append(Phase(name, trajectory, width, self.target if self.taken else None))
        self.joints, self.width = trajectory.positions[-1], width

    def _verified(self, name: str, path: list[Array], checker: CollisionChecker, rules: Rules) -> Trajectory:
        """The quickest trajectory along `path` that keeps all limits and, sample by sample, all distances."""
        arm = self._robot.arm(self.arm)
        speed = recipe().carrying_speed if self.taken else 1.0
        near: Near | None = None
        for spacing in (LINE_SPACING,) if name in _LINES else KNOT_SPACINGS:
            trajectory = timed(path, arm.limits, speed, spacing)
            check_limits(trajectory, arm.joints, arm.lower, arm.upper, arm.limits)
            near = checker.conflict_of(trajectory.positions, rules)
            if near is None:
                return trajectory
        assert near is not None
        raise _in_collision(name, near, rules)

    def _pause(self, name: str, duration: float, width: float) -> None:
        self._phases.append(self._still(name, duration, width))
        self.width = width

    def _still(self, name: str, duration: float, width: float) -> Phase:
        return Phase(name, rest(self.joints, duration), width, self.target if self.taken else None)

    def _held_width(self) -> float:
        if self.grasp is not None:
            return self.grasp.width
        return self.state.widths[self.arm]


def _in_collision(phase: str, near: Near, rules: Rules) -> PlanInCollision:
    return PlanInCollision(
        f"during {phase} {describe(near)}; {1000 * rules.clearance:.0f} mm are kept, "
        f"{1000 * rules.hand_clearance:.1f} mm between hand and boxes",
        phase,
        near.bodies,
        near.distance,
        near.place,
    )
