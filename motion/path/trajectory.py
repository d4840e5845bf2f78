"""From a path to a timed trajectory: jerk-limited, all joints together, without stopping on the way.

One Ruckig profile (Berscheid and Kröger, 2021) runs along the path's `Curve`, whose parameter measures the way by what
the joints may do. For a straight line that is Ruckig's phase-synchronised profile; for a curve the profile is slowed by
the one factor that brings every joint within its limits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import ruckig

from motion.errors import LimitViolation
from motion.path.curves import Curve
from motion.poses import Array, frozen
from motion.robot.recipe import JointLimits, recipe

KNOT_SPACINGS = (0.8, 0.4, 0.2, 0.1, 0.05)
"""Distances between a curve's knots in joint space, radians: the wider, the quicker and the farther it cuts corners."""
LINE_SPACING = 0.05
"""The same for straight lines of the tool, which allow no short cuts."""
_ITERATIONS = 10
_TOLERANCE = 1e-6


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Joints of one arm over time, sampled.

    Attributes:
        period: time between two samples, seconds.
        positions: (n, 7) radians, n at least 1.
        velocities: (n, 7) rad/s.
        accelerations: (n, 7) rad/s².
    """

    period: float
    positions: Array
    velocities: Array
    accelerations: Array

    def __post_init__(self) -> None:
        for name in ("positions", "velocities", "accelerations"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    @property
    def duration(self) -> float:
        """Seconds from the first sample to the last."""
        return self.period * (len(self.positions) - 1)


def sampling_period() -> float:
    """Time between two samples of every trajectory: the simulator's time step, seconds."""
    return float(recipe().contact["timestep"])


def rest(joints: Array, duration: float = 0.0) -> Trajectory:
    """Standing still at `joints` (7,) for `duration` seconds."""
    count = round(duration / sampling_period()) + 1
    zeros = np.zeros((count, 7))
    return Trajectory(sampling_period(), np.tile(joints, (count, 1)), zeros, zeros)


def timed(
    path: Sequence[Array], limits: JointLimits, speed: float = 1.0, spacing: float = KNOT_SPACINGS[-1]
) -> Trajectory:
    """The quickest trajectory of this family along `path`, from rest to rest.

    Args:
        path: waypoints, (7,) radians each.
        limits: velocity, acceleration and jerk of each joint.
        speed: fraction of the quickest speed, in (0, 1]: everything takes 1 / speed as long.
        spacing: distance between the curve's knots, radians; it cuts corners by less than that.
    """
    if max(float(np.max(np.abs(waypoint - path[0]))) for waypoint in path) < 1e-9:
        return rest(path[-1])
    curve = Curve(path, spacing, limits.acceleration)
    fine = curve.evaluate(np.linspace(0, 1, 4 * curve.pieces + 1))
    slope = np.maximum(np.max(np.abs(fine[1]), axis=0), 1e-9)
    velocity = 0.999 * speed * float(np.min(limits.velocity / slope))
    acceleration = 0.999 * speed**2 * float(np.min(limits.acceleration / slope))
    jerk = 0.999 * speed**3 * float(np.min(limits.jerk / slope))
    for _ in range(_ITERATIONS):
        s, ds, dds, ddds = _profile(velocity, acceleration, jerk)
        q, d1, d2, d3 = curve.evaluate(s)
        qd = d1 * ds[:, None]
        qdd = d1 * dds[:, None] + d2 * ds[:, None] ** 2
        qdd[-1] = 0.0
        # Between samples by its formula, from sample to sample by their differences: both keep the limit.
        qddd = d1 * ddds[:, None] + 3 * d2 * (ds * dds)[:, None] + d3 * ds[:, None] ** 3
        steps = np.diff(qdd, axis=0) / sampling_period()
        factor = max(
            float(np.max(np.abs(qd) / limits.velocity)),
            float(np.max(np.abs(qdd) / limits.acceleration)) ** (1 / 2),
            float(np.max(np.abs(qddd) / limits.jerk)) ** (1 / 3),
            float(np.max(np.abs(steps) / limits.jerk)) ** (1 / 3),
        )
        if factor <= 1.0:
            break
        factor *= 1.002
        velocity, acceleration, jerk = velocity / factor, acceleration / factor**2, jerk / factor**3
    q[0], q[-1], qd[-1] = path[0], path[-1], 0.0
    return Trajectory(sampling_period(), q, qd, qdd)


def check_limits(trajectory: Trajectory, names: Sequence[str], lower: Array, upper: Array, limits: JointLimits) -> None:
    """Checks every sample, and the differences between samples, against the limits.

    Raises:
        LimitViolation: naming the joint, the quantity, the value and the limit.
    """
    positions = trajectory.positions
    outside = np.maximum(lower - positions, positions - upper).max(axis=0)
    worst = int(np.argmax(outside))
    if outside[worst] > 1e-6:
        column = positions[:, worst]
        below = lower[worst] - column.min() > column.max() - upper[worst]
        value, limit = (column.min(), lower[worst]) if below else (column.max(), upper[worst])
        raise LimitViolation(names[worst], "position", float(value), float(limit))
    rates = {"velocity": trajectory.velocities, "acceleration": trajectory.accelerations}
    if len(positions) > 1:
        rates["jerk"] = np.diff(trajectory.accelerations, axis=0) / trajectory.period
        steps = np.diff(positions, axis=0) / trajectory.period
        rates["velocity"] = np.vstack([rates["velocity"], steps])
    for quantity, values in rates.items():
        limit = getattr(limits, quantity)
        peak = np.max(np.abs(values), axis=0)
        joint = int(np.argmax(peak / limit))
        if peak[joint] > limit[joint] * (1 + _TOLERANCE):
            raise LimitViolation(names[joint], quantity, float(peak[joint]), float(limit[joint]))


def _profile(velocity: float, acceleration: float, jerk: float) -> tuple[Array, Array, Array, Array]:
    """Ruckig's profile from 0 to 1, from rest to rest: s and its three derivatives, sampled."""
    problem = ruckig.InputParameter(1)
    problem.current_position, problem.target_position = [0.0], [1.0]
    problem.max_velocity, problem.max_acceleration, problem.max_jerk = [velocity], [acceleration], [jerk]
    solution = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(problem, solution)
    profile = solution.profiles[0][0]
    starts = np.concatenate([[0.0], np.cumsum(profile.t)])
    count = int(np.ceil(solution.duration / sampling_period() - 1e-9)) + 1
    times = np.minimum(np.arange(count) * sampling_period(), solution.duration)
    piece = np.clip(np.searchsorted(starts, times, side="right") - 1, 0, len(profile.t) - 1)
    t = times - starts[piece]
    j, a, v, p = (np.asarray(values)[piece] for values in (profile.j, profile.a, profile.v, profile.p))
    ddds = np.append(np.diff(a + t * j) / sampling_period(), 0.0)
    return np.clip(p + t * (v + t * (a / 2 + t * j / 6)), 0.0, 1.0), v + t * (a + t * j / 2), a + t * j, ddds
