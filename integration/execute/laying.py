"""Setting objects down, one after the other, each until it is seen where it should be or given up."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike

from integration.errors import NoPlan
from integration.execute import checks
from integration.execute.checks import Check
from integration.execute.recovery import keep_trying, put_back, remove_leaning
from integration.execute.stage import Stage
from integration.execute.uncovering import uncover
from motion import Plan, RobotState, Scene

_ROUNDS = 2
_OF_ONE = ("at_goal", "supported", "released", "at_rest")

Spots = Callable[[], np.ndarray]
"""Places where an object may be set down as things are now, (n, 3) in [m], the best first."""


class Laying:
    """The work of one place or clear.

    Args:
        stage: where it is done.
        action: "place" or "clear".
        arm: "left", "right" or "auto".

    Attributes:
        before: everything as it was.
        goals: where each object that was set down should be, (3,) in [m].
    """

    def __init__(self, stage: Stage, action: str, arm: str) -> None:
        self.before = stage.scene
        self.goals: dict[str, np.ndarray] = {}
        self._stage, self._action, self._arm = stage, action, arm
        self._spots: dict[str, Spots] = {}
        self._yaws: dict[str, float | None] = {}
        self._given_up = False

    def put(self, name: str, spots: Spots, keep_free: Sequence[ArrayLike] = (), yaw: float | None = None) -> bool:
        """Sets an object down, and again where it was not seen there; False if it was given up.

        Args:
            name: the object.
            spots: where it may go.
            keep_free: convex outlines, (n, 2) in [m], where nothing else is to be set aside.
            yaw: heading that it is to have there [rad]; None where that does not matter.

        Raises:
            NoPlan: there is no plan for it.
        """
        self._spots[name] = spots
        self._yaws[name] = yaw

        def attempt(arm: str) -> None:
            uncover(self._stage, name, arm, lambda scene, start: self._plan(name, spots, arm, scene, start), keep_free)
            remove_leaning(self._stage, name)
            self._put(name, spots, arm)

        def check() -> tuple[Check, ...]:
            after, doubt = self._stage.look_carefully(), self._stage.doubt
            return (checks.at_goal(after, name, self.goals[name], doubt=doubt),)

        def follow(scene: Scene, start: RobotState) -> object:
            return self._plan(name, spots, self._arm, scene, start)

        done = keep_trying(self._stage, name, attempt, check, self._arm, follow=follow, room=True)
        self._given_up |= not done
        return done

    def checked(self, objects: Sequence[str], what: str) -> tuple[Check, ...]:
        """The checks of all objects; what is not as it should be is tried once more.

        Args:
            objects: what the action was about.
            what: where they should be, for people.
        """
        for count in range(_ROUNDS):
            found = self._measured(objects, what)
            broken = {one.object for one in found if not one.passed and one.name in _OF_ONE}
            if not broken and not all(one.passed for one in found):
                if put_back(self._stage, self.before, (*objects, *self._stage.moved)):
                    found = self._measured(objects, what)
                break
            if not broken or self._given_up or count + 1 == _ROUNDS:
                break
            try:
                for name in [name for name in self.goals if name in broken]:
                    self._stage.note("check", name, f"{name} did not stay at its place")
                    self.put(name, self._spots[name], yaw=self._yaws[name])
            except NoPlan as refusal:
                self._stage.note("plan", refusal.objects[0] if refusal.objects else "", str(refusal))
                break
        return found

    def _put(self, name: str, spots: Spots, arm: str) -> None:
        """Sets an object down at one of its spots, rather one of the first."""
        plans = self._plan(name, spots, arm, self._stage.scene, self._stage.simulator.state())
        assert plans[-1].goal is not None
        self.goals[name] = plans[-1].goal.position
        for plan in plans:
            self._stage.execute(plan, self._action, name)

    def _plan(self, name: str, spots: Spots, arm: str, scene: Scene, start: RobotState) -> tuple[Plan, ...]:
        """Plans that lead to one of an object's spots.

        Raises:
            NoPlan: there are none.
        """
        places = spots()
        if not len(places):
            raise NoPlan(f"there is no free room on the table to put {name}", (name,), "room")
        turned = {} if self._yaws[name] is None else {"yaw": self._yaws[name]}
        return self._stage.plan_transport(name, places, arm, scene=scene, start=start, **turned)

    def _measured(self, objects: Sequence[str], what: str) -> tuple[Check, ...]:
        stage = self._stage
        drift = stage.watch_rest()
        after, contacts, doubt = stage.look_carefully(), stage.simulator.contacts(), stage.doubt
        found: list[Check] = []
        for name in objects:
            goal = self.goals.get(name, np.full(3, np.nan))
            found.append(checks.at_goal(after, name, goal, what, doubt))
            found.append(checks.supported(after, name, doubt))
            found.append(checks.released(name, contacts, after.names))
            found.append(checks.at_rest(name, drift[name], doubt))
        return (*found, checks.others_unmoved(self.before, after, (*objects, *stage.moved), doubt))
