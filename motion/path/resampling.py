"""The same movement at another rate: between two samples the one polynomial of degree five that fits both."""

from __future__ import annotations

import math
from numbers import Real

import numpy as np

from motion.errors import InvalidGoal
from motion.path.trajectory import Trajectory
from motion.poses import Array

_SAME = 1e-9


def resampled_in_time(trajectory: Trajectory, period: float) -> Trajectory:
    """A trajectory that runs along the same way in the same time, sampled at another period.

    Between two samples positions, velocities and accelerations follow the quintic that has those of both ends. Its last
    sample is that of the given trajectory, up to one period later where its duration is no multiple of the new one.

    Args:
        trajectory: sampled evenly.
        period: time between two samples of the result, seconds.

    Raises:
        InvalidGoal: the period is no finite number above 0.
    """
    if not (isinstance(period, Real) and math.isfinite(period) and period > 0):
        raise InvalidGoal(f"a period is a finite number of seconds above 0, not {period!r}")
    if abs(trajectory.period - period) <= _SAME or len(trajectory.positions) == 1:
        return Trajectory(period, trajectory.positions, trajectory.velocities, trajectory.accelerations)
    count = int(np.ceil(trajectory.duration / period - 1e-6)) + 1
    times = np.minimum(np.arange(count) * period, trajectory.duration)
    return Trajectory(period, *sampled_at(trajectory, times))


def sampled_at(trajectory: Trajectory, times: Array) -> tuple[Array, Array, Array]:
    """Positions, velocities and accelerations at some times, each (n, 7).

    Args:
        trajectory: sampled evenly.
        times: (n,) seconds since its beginning, from 0 to its duration.
    """
    if len(trajectory.positions) == 1:
        return tuple(np.repeat(values, len(times), axis=0) for values in
                     (trajectory.positions, trajectory.velocities, trajectory.accelerations))  # type: ignore[return-value]  # fmt: skip
    h = trajectory.period
    first = np.clip(np.floor(times / h + 1e-9).astype(int), 0, len(trajectory.positions) - 2)
    s = np.clip(times / h - first, 0.0, 1.0)[:, None]
    p0, p1 = trajectory.positions[first], trajectory.positions[first + 1]
    v0, v1 = h * trajectory.velocities[first], h * trajectory.velocities[first + 1]
    a0, a1 = h**2 * trajectory.accelerations[first], h**2 * trajectory.accelerations[first + 1]
    # In the unit interval: p0 + v0 s + a0/2 s² + c3 s³ + c4 s⁴ + c5 s⁵, the last three from the other end.
    d, dv, da = p1 - p0 - v0 - a0 / 2, v1 - v0 - a0, a1 - a0
    c3, c4, c5 = 10 * d - 4 * dv + da / 2, -15 * d + 7 * dv - da, 6 * d - 3 * dv + da / 2
    positions = p0 + s * (v0 + s * (a0 / 2 + s * (c3 + s * (c4 + s * c5))))
    velocities = (v0 + s * (a0 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h
    accelerations = (a0 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / h**2
    return positions, velocities, accelerations
