"""Stopping on the way: the arm keeps to the path that was verified and runs along it ever more slowly."""

from __future__ import annotations

import numpy as np

from motion.poses import Array
from motion.recipe import JointLimits
from motion.timing import Trajectory

_TIMES = (0.06, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0)
_TOLERANCE = 1e-2


def braked(trajectory: Trajectory, sample: int, limits: JointLimits) -> Trajectory:
    """From a sample of a trajectory to a standstill on its path, as soon as velocity and acceleration allow.

    Args:
        trajectory: what is being carried out.
        sample: where it is to be left.
        limits: of the joints; the limits of jerk do not hold for a stop that was not planned.

    Returns:
        a trajectory that begins at that sample; the rest of the given one where it stops no sooner.
    """
    rest = Trajectory(
        trajectory.period,
        trajectory.positions[sample:],
        trajectory.velocities[sample:],
        trajectory.accelerations[sample:],
    )
    for seconds in _TIMES:
        if seconds / 2 + 0.02 >= rest.duration:
            break
        slowed = _slowed(rest, seconds)
        if slowed is not None and np.all(np.abs(slowed.accelerations) <= limits.acceleration * (1 + _TOLERANCE)):
            return slowed
    return rest


def _slowed(rest: Trajectory, seconds: float) -> Trajectory | None:
    """The way that is left, its clock slowed down evenly to zero within `seconds`; None where that leads beyond it."""
    count = round(seconds / rest.period)
    t = np.arange(count + 1) * rest.period
    rate, change = 1 - t / seconds, -1 / seconds
    clock = t - t**2 / (2 * seconds)
    if clock[-1] > rest.duration:
        return None
    samples = np.arange(len(rest.positions)) * rest.period

    def at(values: Array) -> Array:
        return np.column_stack([np.interp(clock, samples, column) for column in values.T])

    velocities, accelerations = at(rest.velocities), at(rest.accelerations)
    positions = at(rest.positions)
    slower = velocities * rate[:, None]
    return Trajectory(rest.period, positions, slower, accelerations * rate[:, None] ** 2 + velocities * change)
