"""The contract of whatever carries plans out: a simulator, a recording, a bridge to a robot."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from motion.plan.plans import Phase, Plan
from motion.poses import Array, Pose
from motion.robot.state import RobotState
from motion.scene import Scene
from motion.sim.execution import PhaseRecord
from motion.sim.faults import Fault

OnStep = Callable[[Any], None]
"""Called with the backend after every time step."""
Watching = Callable[[Any], str | None]
"""Called with the backend every 10 ms of a phase; what it returns, unless None, is why the phase is left."""


class Backend(Protocol):
    """A robot, or what stands for one, that keeps still unless it is told to move.

    Positions are in the world's frame in metres, joints in radians, widths in metres, times in seconds.
    """

    @property
    def time(self) -> float:
        """Seconds since the beginning."""

    def scene(self) -> Scene:
        """Everything where it is observed now."""

    def poses(self) -> dict[str, Pose]:
        """The observed pose of every box, by name."""

    def pose(self, name: str) -> Pose:
        """The observed pose of one box."""

    def state(self) -> RobotState:
        """The robot, for the next plan: joints as commanded, widths and what is held as measured."""

    def joints(self, arm: str) -> Array:
        """(7,) measured joints."""

    def tool_pose(self, arm: str) -> Pose:
        """The pose of a tool frame by the measured joints."""

    def gripper_width(self, arm: str) -> float:
        """The measured opening of a gripper."""

    def tracking_error(self, arm: str) -> float:
        """The largest deviation of a joint from where it should be."""

    def holding(self, arm: str) -> tuple[str, ...]:
        """Names of the boxes between the fingers of an arm."""

    def contacts(self) -> tuple[tuple[str, str], ...]:
        """Pairs of bodies that touch now, sorted; () where that cannot be known."""

    def check_start(self, plan: Plan) -> None:
        """Refuses a plan that does not begin where the robot is, with `InvalidGoal`."""

    def run_phase(
        self, arm: str, target: str | None, phase: Phase, on_step: OnStep | None = None, until: Watching | None = None
    ) -> PhaseRecord:
        """Carries out one phase: the arm along its trajectory in its time, the gripper evenly to its width.

        Where `until` gives a reason on the way, the arm brakes on the path within its limits, and the record has it.
        """

    def hold(self, seconds: float, on_step: OnStep | None = None) -> None:
        """Lets time pass while the robot keeps still."""

    def settle(self, seconds: float = 2.0) -> bool:
        """Lets time pass until nothing moves any more, `seconds` at most; whether nothing does."""

    def stop(self) -> None:
        """Makes everything stand still at once, from any thread, also while something else is being done."""

    def close(self) -> None:
        """Ends it; nothing is asked afterwards."""


MakeBackend = Callable[[Scene, RobotState | None, Sequence[Fault]], Backend]
"""Makes a backend from a scene, the robot's state (home by default) and faults that are to be injected."""
