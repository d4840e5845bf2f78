"""Stopping on the way: the arm keeps to the path that was verified and runs along it ever more slowly."""

from __future__ import annotations

import numpy as np

from motion.poses import Array
from motion.recipe import JointLimits
from motion.timing import Trajectory

_DELAYS = (0.0, 0.02, 0.04, 0.06, 0.08, 0.12, 0.16, 0.2, 0.3)
"""How long, in seconds, the arm may go on as planned before it brakes: where it speeds up, that is often sooner over."""
_TIMES = (0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2, 1.4)


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
    stops = sorted((delay + seconds, delay, seconds) for delay in _DELAYS for seconds in _TIMES)
    for total, delay, seconds in stops:
        if total >= rest.duration:
            break
        slowed = _slowed(rest, delay, seconds)
        if slowed is not None and _keeps(slowed, limits):
            return slowed
    return rest


def _slowed(rest: Trajectory, delay: float, seconds: float) -> Trajectory | None:
    """The way that is left, its clock running as planned for `delay`, then ever slower until it stops after `seconds`.

    The clock's rate falls as 1 - 3 x² + 2 x³ with x = t / seconds, so that what the joints do begins and ends smoothly.
    None where that leads beyond the end of the way.
    """
    waiting, count = round(delay / rest.period), round(seconds / rest.period)
    x = np.arange(1, count + 1) / count
    clock = delay + seconds * (x - x**3 + x**4 / 2)
    if clock[-1] > rest.duration:
        return None
    rate, change = 1 - 3 * x**2 + 2 * x**3, -6 * x * (1 - x) / seconds
    samples = np.arange(len(rest.positions)) * rest.period

    def at(values: Array) -> Array:
        return np.column_stack([np.interp(clock, samples, column) for column in values.T])

    velocities, accelerations = at(rest.velocities), at(rest.accelerations)
    slower = velocities * rate[:, None]
    harder = accelerations * rate[:, None] ** 2 + velocities * change[:, None]
    harder[-1] = slower[-1] = 0.0
    return Trajectory(
        rest.period,
        np.vstack([rest.positions[: waiting + 1], at(rest.positions)]),
        np.vstack([rest.velocities[: waiting + 1], slower]),
        np.vstack([rest.accelerations[: waiting + 1], harder]),
    )


def _keeps(trajectory: Trajectory, limits: JointLimits) -> bool:
    jerk = np.diff(trajectory.accelerations, axis=0) / trajectory.period
    return bool(
        np.all(np.abs(trajectory.velocities) <= limits.velocity * (1 + 1e-6))
        and np.all(np.abs(trajectory.accelerations) <= limits.acceleration * (1 + 1e-6))
        and np.all(np.abs(jerk) <= limits.jerk * (1 + 1e-6))
    )
