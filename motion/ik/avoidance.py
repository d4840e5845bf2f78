"""Keeping clear of what stands around: the check of a configuration, and mink's way out of a collision.

mink is loaded when it is first needed: most solutions are free, and importing it takes longer than finding them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Near, Rules
from motion.ik.levenberg_marquardt import Descent
from motion.poses import Array, Pose
from motion.robot.load import load_robot
from motion.robot.state import RobotState
from motion.scene import Scene

if TYPE_CHECKING:
    from motion.ik.contact_limit import ContactLimit

_STEP = 0.08
_STEPS = 30


class Avoidance:
    """Things that an arm must keep clear of while everything else stands still.

    Args:
        scene: where the boxes are.
        arm: the arm that moves.
        state: where the robot is; home by default.
        rules: what may be near to what.
        width: opening of the gripper, metres; that of `state` by default.
        held: name of the box in the hand, or None.
        grip: pose of that box in the tool frame.
        checker: the check to use where there is one already for the same arguments.
    """

    def __init__(
        self,
        scene: Scene,
        arm: str,
        *,
        state: RobotState | None = None,
        rules: Rules | None = None,
        width: float | None = None,
        held: str | None = None,
        grip: Pose | None = None,
        checker: CollisionChecker | None = None,
    ) -> None:
        load_robot().arm(arm)
        self._scene, self._arm = scene, arm
        self._state = RobotState.home() if state is None else state
        self._rules = Rules() if rules is None else rules
        self._width = width
        self._checker = (
            CollisionChecker(scene, self._state, arm, width=width, held=held, grip=grip) if checker is None else checker
        )
        self._limit: ContactLimit | None = None

    def nearest(self, joints: Array) -> Near | None:
        """The pair that is nearer than the rules allow when the arm is at `joints` (7,), or None."""
        return self._checker.nearest(joints, self._rules)

    def hopeless(self, near: Near) -> bool:
        """Tells that no other joints would help: the hand itself, which the target fixes, is too near to a box."""
        hand = (f"{self._arm[0]}_gripper", f"{self._arm}_gripper", f"{self._arm}_hand")
        others = (*self._scene.names, "floor")
        first, second = near.bodies
        return (first.startswith(hand) and second in others) or (second.startswith(hand) and first in others)

    @property
    def limit(self) -> ContactLimit:
        """The limit for mink on the arm's model."""
        if self._limit is None:
            from motion.ik.contact_limit import ContactLimit  # loads mink

            self._limit = ContactLimit(self._scene, self._arm, self._state, self._rules, self._width)
        return self._limit

    def slide(self, joints: Array, target: Pose, solver: str) -> Descent:
        """Moves from a configuration in collision to a free one with the tool at its target, if mink finds the way.

        Args:
            joints: (7,) radians.
            target: of the tool frame.
            solver: a quadratic programming solver.
        """
        from motion.ik.differential import differential_ik  # loads mink

        return differential_ik(self._arm, solver).descend(
            joints,
            target,
            _STEPS,
            more=[self.limit],
            largest=_STEP,
            accept=lambda configuration: self.nearest(configuration) is None,
        )
