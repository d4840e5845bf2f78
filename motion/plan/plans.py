"""Plans as frozen values: phases with timed trajectories and gripper commands."""

from __future__ import annotations

from dataclasses import dataclass

from motion.grasp.candidates import Grasp
from motion.path.trajectory import Trajectory
from motion.plan.joint_trajectory import JointTrajectory, joined
from motion.poses import Pose
from motion.robot.state import RobotState


@dataclass(frozen=True, eq=False)
class Phase:
    """One step of a plan.

    Attributes:
        name: home, pregrasp, approach, close, lift, hold, transfer, lower, open or retreat.
        trajectory: of the plan's arm.
        gripper: opening that its gripper is told to have at the end, metres; the command runs there evenly.
        held: name of the box in the hand during the phase, or None.
    """

    name: str
    trajectory: Trajectory
    gripper: float
    held: str | None = None

    @property
    def duration(self) -> float:
        """Seconds."""
        return self.trajectory.duration


@dataclass(frozen=True, eq=False)
class Plan:
    """Phases of one arm, from rest to rest, verified as a whole.

    Attributes:
        kind: "pick", "place" or "home".
        arm: "left" or "right"; the other arm keeps still.
        target: the box it is about, or None.
        phases: in order.
        grasp: how the box is taken, or None (a plan to go home, or a box already in the hand).
        goal: where the box's centre is at the end, or None.
        start: the robot before.
        end: the robot after.
        clearance: the smallest distance, where no contact is meant, that the verification asked for, metres.
    """

    kind: str
    arm: str
    target: str | None
    phases: tuple[Phase, ...]
    grasp: Grasp | None
    goal: Pose | None
    start: RobotState
    end: RobotState
    clearance: float

    @property
    def duration(self) -> float:
        """Seconds of all phases."""
        return sum(phase.duration for phase in self.phases)

    def to_joint_trajectory(self, rate: float = 100.0) -> JointTrajectory:
        """The plan for other controllers, with the fields of ROS's `trajectory_msgs/JointTrajectory`.

        Args:
            rate: points a second; each phase ends with a point of its own besides.

        Raises:
            InvalidGoal: the rate is no finite number above 0.
        """
        phases = ((phase.trajectory, phase.gripper) for phase in self.phases)
        return joined(self.arm, phases, self.start.widths[self.arm], rate)
