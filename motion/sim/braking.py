"""Stopping on the way: the arm keeps to the path that was verified and runs along it ever more slowly.

The way that is left is measured by what the joints may do, as for planned trajectories, and Ruckig brings the speed
along it to zero within one bound on acceleration and jerk. Where the path bends, that bound is lowered until every
joint keeps its limits.
"""

from __future__ import annotations

import numpy as np
import ruckig

from motion.path.trajectory import Trajectory
from motion.poses import Array
from motion.robot.recipe import JointLimits

_SHARES = (0.999, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2)
"""Of what the joints may do on a straight line, how much is used."""
_STANDING = 1e-8
_TOLERANCE = 1e-6


def braked(trajectory: Trajectory, sample: int, limits: JointLimits) -> Trajectory:
    """From a sample of a trajectory to a standstill on its path, as soon as velocity, acceleration and jerk allow.

    Args:
        trajectory: what is being carried out.
        sample: where it is to be left.
        limits: of the joints.

    Returns:
        a trajectory that begins at that sample; the rest of the given one where it stops no sooner.
    """
    rest = Trajectory(
        trajectory.period,
        trajectory.positions[sample:],
        trajectory.velocities[sample:],
        trajectory.accelerations[sample:],
    )
    if not np.any(rest.velocities):  # such as while the gripper closes
        return Trajectory(rest.period, rest.positions[:1], rest.velocities[:1], rest.accelerations[:1])
    way = _Way(rest, limits)
    for share in _SHARES if way.moving else ():
        stop = way.stop(share)
        if stop is not None and stop.duration < rest.duration and _keeps(stop, limits):
            return stop
    return rest


class _Way:
    """The path of a trajectory over its length, in the norm in which every joint is weighed by its acceleration."""

    def __init__(self, rest: Trajectory, limits: JointLimits) -> None:
        self._rest, self._limits = rest, limits
        weights = limits.acceleration
        speed = np.linalg.norm(rest.velocities / weights, axis=1)
        self.moving = bool(speed[0] > _STANDING)
        moving = speed > _STANDING
        speed = np.maximum(speed, _STANDING)
        gained = np.sum(rest.velocities * rest.accelerations / weights**2, axis=1) / speed
        steps = np.linalg.norm(np.diff(rest.positions, axis=0) / weights, axis=1)
        self._start = float(speed[0]), float(gained[0])
        # Where the arm all but stands the path has no direction that could be told; there is nothing to brake there.
        last = int(np.argmin(moving)) if not moving.all() else len(moving)
        self._along = np.concatenate([[0.0], np.cumsum(steps)])[:last]
        self._positions = rest.positions[:last]
        self._slopes = (rest.velocities / speed[:, None])[:last]
        self._bends = ((rest.accelerations - rest.velocities / speed[:, None] * gained[:, None]) / speed[:, None] ** 2)[
            :last
        ]

    def stop(self, share: float) -> Trajectory | None:
        """The way to a standstill with that share of what the joints may do; None if it led beyond the end."""
        steepest = np.maximum(np.max(np.abs(self._slopes), axis=0), 1e-9)
        problem = ruckig.InputParameter(1)
        problem.control_interface = ruckig.ControlInterface.Velocity
        problem.current_position, problem.target_velocity, problem.target_acceleration = [0.0], [0.0], [0.0]
        problem.current_velocity, problem.current_acceleration = [self._start[0]], [self._start[1]]
        problem.max_acceleration = [share * float(np.min(self._limits.acceleration / steepest))]
        problem.max_jerk = [share * float(np.min(self._limits.jerk / steepest))]
        profile = ruckig.Trajectory(1)
        if ruckig.Ruckig(1).calculate(problem, profile) != ruckig.Result.Working:
            return None
        times = np.arange(int(np.ceil(profile.duration / self._rest.period - 1e-9)) + 1) * self._rest.period
        states = [profile.at_time(min(float(time), profile.duration)) for time in times]
        way, speed, gained = (np.array([state[order][0] for state in states]) for order in range(3))
        if way.max() > self._along[-1]:
            return None
        slopes, bends = self._at(self._slopes, way), self._at(self._bends, way)
        velocities = slopes * speed[:, None]
        accelerations = slopes * gained[:, None] + bends * speed[:, None] ** 2
        accelerations[0] = self._rest.accelerations[0]
        velocities[-1] = accelerations[-1] = 0.0
        return Trajectory(self._rest.period, self._at(self._positions, way), velocities, accelerations)

    def _at(self, values: Array, way: Array) -> Array:
        return np.column_stack([np.interp(way, self._along, column) for column in values.T])


def _keeps(trajectory: Trajectory, limits: JointLimits) -> bool:
    jerk = np.diff(trajectory.accelerations, axis=0) / trajectory.period
    velocity = np.vstack([trajectory.velocities, np.diff(trajectory.positions, axis=0) / trajectory.period])
    return bool(
        np.all(np.abs(velocity) <= limits.velocity * (1 + _TOLERANCE))
        and np.all(np.abs(trajectory.accelerations) <= limits.acceleration * (1 + _TOLERANCE))
        and np.all(np.abs(jerk) <= limits.jerk * (1 + _TOLERANCE))
    )
