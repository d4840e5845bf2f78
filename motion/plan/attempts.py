"""One attempt at a plan: phases are added one by one, each timed and verified, free of contact where none is meant."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from motion.collision.checker import CollisionChecker
from motion.collision.clearance import CLEARANCE, CLOSE, Rules
from motion.grasp.approaches import APPROACH, RESTING, STARTS, Approaches, Putting, Taking, line
from motion.grasp.candidates import Grasp
from motion.path.trajectory import Trajectory, rest
from motion.path.travel import travel, verified
from motion.plan.plans import Phase, Plan
from motion.poses import Array, Pose
from motion.robot.load import load_robot
from motion.robot.recipe import recipe
from motion.robot.state import RobotState
from motion.scene import Scene

BRIEF, THOROUGH = 40, 400
"""Expansions of a search for a path: at first, to see whether another grasp does better, and at last."""
_GLANCE = 0.06
"""Longest step of any joint, radians, where it is only to be seen which of several ways is likely to be free."""
_AT_HOME = 1e-3
_CLOSING_TIME = 0.4
_OPENING_TIME = 0.3
_HOLDING_TIME = 0.2


class Effort(NamedTuple):
    """The effort of an attempt.

    Attributes:
        expansions: bound of each search for a path whose straight line is not free.
        tight: whether near its grasp the hand may come closer to the box's neighbours than everywhere else.
        starts: from how many starts joints are looked for.
    """

    expansions: int
    tight: bool = False
    starts: int = STARTS


class Attempt:
    """A plan in the making.

    Args:
        scene: where everything is.
        state: where the robot is.
        arm: the arm that moves.
        target: the box it is about, or None.
        rng: source of all chance.
        effort: how hard to try.

    Attributes:
        approaches: the lines to grasps and releases that the arm can follow.
    """

    def __init__(
        self,
        scene: Scene,
        state: RobotState,
        arm: str,
        target: str | None,
        rng: np.random.Generator,
        effort: Effort | None = None,
    ) -> None:
        self.scene, self.state, self.arm, self.target, self.rng = scene, state, arm, target, rng
        self.effort = effort = Effort(THOROUGH) if effort is None else effort
        self.clearance = CLOSE if effort.tight else CLEARANCE
        self.approaches = Approaches(scene, state, arm, rng, self.clearance, effort.starts)
        self.joints: Array = state.joints(arm)
        self.width = state.widths[arm]
        self.grasp: Grasp | None = None
        self.grip: Pose | None = None
        self.taken = False
        self._home = recipe().home[arm]
        self._robot = load_robot()
        self._phases: list[Phase] = []

    def copy(self) -> Attempt:
        """An attempt that begins with the same phases."""
        twin = copy.copy(self)
        twin._phases = list(self._phases)
        return twin

    # The steps of a pick.

    def takings(self, grasp: Grasp, lift: float) -> Iterator[Taking]:
        """The ways to take a box; see `Approaches.takings`."""
        return self.approaches.takings(grasp, lift, self.joints)

    def take(self, taking: Taking) -> None:
        """Adds the phases from where the robot is to the box lifted, timed and verified."""
        grasp, empty = taking.grasp, taking.empty
        self.grasp = grasp
        self._home_first()
        self._travel("pregrasp", taking.back[-1], empty, Rules(), grasp.opening)
        self._line("approach", taking.back[::-1], empty, taking.near, grasp.opening)
        self._pause("close", _CLOSING_TIME, grasp.width - recipe().gripper.squeeze)
        self.grip, self.taken = taking.grip, True
        self._line("lift", taking.up, taking.full, taking.rising, self.width)

    def already_holding(self) -> None:
        """The box is in the hand from the start."""
        tool = self._robot.tool_pose(self.arm, self.joints)
        assert self.target is not None
        self.grip = tool.inverse() @ self.scene.box(self.target).pose
        self.width = self.held_width() - recipe().gripper.squeeze
        self.taken = True

    # The steps of a place.

    def put(self, putting: Putting) -> None:
        """Adds the phases from the held box to the box at its destination and the arm at home, timed and verified."""
        full, empty, opening = putting.full, putting.empty, putting.opening
        self._rise(full)
        rising = Rules(resting=full.around_held(self.joints, RESTING))
        self._travel("transfer", putting.down[0], full, rising, self.width)
        self._line("lower", putting.down, full, putting.lowering, self.width)
        self._pause("open", _OPENING_TIME, opening)
        self.scene, self.grip, self.taken = putting.placed, None, False
        self._line("retreat", putting.away, empty, putting.leaving, opening)
        self._travel("home", self._home, empty, Rules(), opening)

    def go_home(self) -> None:
        """Adds the phases that bring the arm home from wherever it is."""
        held = self.state.held.get(self.arm)
        if held is not None:
            self.already_holding()
        checker = self.approaches.checker(width=self.state.widths[self.arm], held=held, grip=self.grip)
        self._back_out(checker)
        self._travel("home", self._home, checker, Rules(), self.width)

    # Which of several ways is direct.

    def leads_straight_to(self, taking: Taking) -> bool:
        """Tells whether the straight line in joint space to the beginning of the approach is free."""
        return taking.empty.free(self._home, taking.back[-1], Rules(), _GLANCE)

    def detours_on(self, lifted: Array, putting: Putting) -> int:
        """On how many of the ways from the lifted box to above its destination, and home from there, none is straight.

        Args:
            lifted: (7,) radians.
            putting: the way to put it down.
        """
        rules = Rules(resting=putting.full.around_held(lifted, RESTING))
        across = putting.full.free(lifted, putting.down[0], rules, _GLANCE)
        back = putting.empty.free(putting.away[-1], self._home, Rules(), _GLANCE)
        return 2 - across - back

    # The whole.

    def finished(self, kind: str, goal: Pose | None) -> Plan:
        """The plan. Every phase was checked against limits and contact, sample by sample, when it was added."""
        if self.taken:
            self._phases.append(self._still("hold", _HOLDING_TIME, self.width))
        widths = {**self.state.widths, self.arm: self.held_width() if self.taken else self.width}
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

    def held_width(self) -> float:
        """Opening of the gripper with the box in it, metres."""
        return self.state.widths[self.arm] if self.grasp is None else self.grasp.width

    # Helpers.

    def _home_first(self) -> None:
        """Brings an empty hand home, unless it is there."""
        if np.max(np.abs(self.joints - self._home)) <= _AT_HOME:
            self._phases.append(self._still("home", 0.0, self.width))
            return
        checker = self.approaches.checker(width=self.width)
        self._back_out(checker)
        self._travel("home", self._home, checker, Rules(), self.width)

    def _rise(self, full: CollisionChecker) -> None:
        """Adds a lift if the held box still stands where it was taken, too near to something to move freely."""
        touched = full.around_held(self.joints, RESTING)
        if self.target is None or full.nearest(self.joints, Rules(resting=touched)) is None:
            return
        close = touched | full.around_held(self.joints, CLEARANCE) | self.scene.below(self.target)
        rules = Rules(hand_clearance=CLOSE, resting=touched, close=close)
        tool = self._robot.tool_pose(self.arm, self.joints)
        top = Pose(tool.position + np.array([0, 0, APPROACH]), tool.orientation)
        self._line("lift", line(self.arm, tool, top, self.joints, full, rules, "lift"), full, rules, self.width)

    def _back_out(self, checker: CollisionChecker) -> None:
        """Adds a straight retreat along the approach if the hand is too near to something to move freely."""
        if checker.nearest(self.joints, Rules()) is None:
            return
        tool = self._robot.tool_pose(self.arm, self.joints)
        rules = Rules(
            touching=frozenset(box.name for box in self.scene.boxes if not box.fixed),
            resting=checker.around_held(self.joints, RESTING),
            hand_clearance=-0.002,
        )
        back = Pose(tool.position - APPROACH * tool.rotation[:, 2], tool.orientation)
        path = line(self.arm, tool, back, self.joints, checker, rules, "retreat")
        self._line("retreat", path, checker, rules, self.width)

    def _travel(self, phase: str, last: Array, checker: CollisionChecker, rules: Rules, width: float) -> None:
        """Adds the way from where the arm is to `last`, whatever is between."""
        found = travel(
            self.arm, phase, self.joints, last, checker, rules, self.rng, self.effort.expansions, self._speed
        )
        self._add(phase, found, width)

    def _line(self, phase: str, path: list[Array], checker: CollisionChecker, rules: Rules, width: float) -> None:
        """Adds the way along a straight line of the tool."""
        self._add(phase, verified(self.arm, phase, [path], checker, rules, self._speed), width)

    @property
    def _speed(self) -> float:
        return recipe().carrying_speed if self.taken else 1.0

    def _add(self, name: str, trajectory: Trajectory, width: float) -> None:
        self._phases.append(Phase(name, trajectory, width, self.target if self.taken else None))
        self.joints, self.width = trajectory.positions[-1], width

    def _pause(self, name: str, duration: float, width: float) -> None:
        self._phases.append(self._still(name, duration, width))
        self.width = width

    def _still(self, name: str, duration: float, width: float) -> Phase:
        return Phase(name, rest(self.joints, duration), width, self.target if self.taken else None)
