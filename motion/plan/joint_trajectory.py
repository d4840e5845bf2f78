"""Plans for other controllers: the joints of one arm over time, and the gripper's commands apart."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from numbers import Real
from typing import Any

import numpy as np

from motion.errors import InvalidGoal
from motion.path.resampling import sampled_at
from motion.path.trajectory import Trajectory
from motion.poses import Array, frozen
from motion.robot.load import load_robot


@dataclass(frozen=True)
class GripperCommand:
    """A command to a gripper.

    Attributes:
        time_from_start: when it begins, seconds.
        duration: how long the fingers take at least, seconds; 0 where they move beside the arm.
        width: opening that they are told to have, metres.
    """

    time_from_start: float
    duration: float
    width: float


@dataclass(frozen=True, eq=False)
class JointTrajectory:
    """A plan as ROS's `trajectory_msgs/JointTrajectory` has it, with the gripper's commands apart.

    Attributes:
        arm: "left" or "right".
        joint_names: of the seven joints, in the order of the columns.
        time_from_start: (n,) seconds, growing strictly from 0.
        positions: (n, 7) radians.
        velocities: (n, 7) rad/s.
        accelerations: (n, 7) rad/s².
        gripper: commands to the arm's gripper, in order.
    """

    arm: str
    joint_names: tuple[str, ...]
    time_from_start: Array
    positions: Array
    velocities: Array
    accelerations: Array
    gripper: tuple[GripperCommand, ...]

    def __post_init__(self) -> None:
        for name in ("time_from_start", "positions", "velocities", "accelerations"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    @property
    def duration(self) -> float:
        """Seconds."""
        return float(self.time_from_start[-1])

    def to_json(self) -> dict[str, Any]:
        """Plain values, with the field names of the message."""
        rows = zip(self.time_from_start, self.positions, self.velocities, self.accelerations, strict=True)
        return {
            "joint_names": list(self.joint_names),
            "points": [
                {
                    "time_from_start": round(float(time), 9),
                    "positions": q.tolist(),
                    "velocities": qd.tolist(),
                    "accelerations": qdd.tolist(),
                }
                for time, q, qd, qdd in rows
            ],
            "gripper": [
                {"time_from_start": round(one.time_from_start, 9), "duration": one.duration, "width": one.width}
                for one in self.gripper
            ],
        }


def joined(arm: str, phases: Iterable[tuple[Trajectory, float]], width: float, rate: float) -> JointTrajectory:
    """Phases as one trajectory.

    The phases follow one another without a break; while the gripper closes or opens the arm stands still. Points lie on
    an even grid, and each phase ends with one of its own, so that nothing is cut where it has to be exact.

    Args:
        arm: "left" or "right".
        phases: the trajectory of each, and the opening that its gripper is told to have at its end, metres.
        width: opening that the gripper was told to have before, metres.
        rate: points a second.

    Raises:
        InvalidGoal: the rate is no finite number above 0.
    """
    if not (isinstance(rate, Real) and math.isfinite(rate) and rate > 0):
        raise InvalidGoal(f"a rate is a finite number of points a second above 0, not {rate!r}")
    start, times, values = 0.0, list[Array](), list[tuple[Array, Array, Array]]()
    commands: list[GripperCommand] = []
    for trajectory, opening in phases:
        if opening != width:
            moving = bool(np.any(trajectory.velocities))
            commands.append(GripperCommand(start, 0.0 if moving else trajectory.duration, opening))
            width = opening
        local = _grid(trajectory, rate, first=not times)
        times.append(start + local)
        values.append(sampled_at(trajectory, local))
        start += trajectory.duration
    q, qd, qdd = (np.concatenate([value[k] for value in values]) for k in range(3))
    names = load_robot().arm(arm).joints
    return JointTrajectory(arm, names, np.concatenate(times), q, qd, qdd, tuple(commands))


def _grid(trajectory: Trajectory, rate: float, *, first: bool) -> Array:
    """Times of a phase's points, its end among them; its beginning only where nothing was before."""
    count = int(np.floor(trajectory.duration * rate - 1e-6))
    inner: Sequence[float] = [k / rate for k in range(1, count + 1)]
    ends = [trajectory.duration] if trajectory.duration > 0 else []
    return np.array([*([0.0] if first else []), *inner, *ends])
