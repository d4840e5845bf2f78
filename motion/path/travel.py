"""Trajectories that are verified: along given paths, and from one configuration to another whatever is between.

Every sample is checked against the joints' limits and, on the grid, against contact before a trajectory is given out.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Near, Rules
from motion.collision.grid import GRID, SEARCH_GRID
from motion.errors import PlanInCollision
from motion.path.search import connect, describe
from motion.path.smoothing import smoothed
from motion.path.trajectory import KNOT_SPACINGS, LINE_SPACING, Trajectory, check_limits, timed
from motion.poses import Array
from motion.robot.load import load_robot

LINES = ("approach", "lift", "lower", "retreat")
"""Phases in which the tool moves along a straight line."""


def travel(
    arm: str,
    phase: str,
    first: Array,
    last: Array,
    checker: CollisionChecker,
    rules: Rules,
    rng: np.random.Generator,
    expansions: int,
    speed: float = 1.0,
) -> Trajectory:
    """A verified trajectory from `first` to `last`, searched for on the coarse grid first, then on the fine.

    A path that is not straight is smoothed; of both, the one with the quicker trajectory is taken.

    Args:
        arm: "left" or "right".
        phase: its name, for errors.
        first: (7,) radians.
        last: (7,) radians.
        checker: the world around, and what the hand holds.
        rules: what may be near to what.
        rng: where samples come from.
        expansions: how often the sampling planner may grow its trees; with 0 nothing but straight lines is tried.
        speed: fraction of the quickest speed.

    Raises:
        PlanInCollision: an end of it, or every trajectory that was found, comes too near to something.
        PathNotFound: nothing was found between the ends.
    """
    error: PlanInCollision | None = None
    for grid in (SEARCH_GRID, GRID):
        path = connect(checker, arm, first, last, rules, rng, phase, expansions, grid)
        paths = [path]
        if len(path) > 2:
            free = partial(checker.free, rules=rules, grid=grid)
            paths.insert(0, smoothed(path, checker, rules, load_robot().arm(arm), free))
        try:
            return verified(arm, phase, paths, checker, rules, speed)
        except PlanInCollision as refusal:
            error = refusal
    assert error is not None
    raise error


def verified(
    arm: str, phase: str, paths: Sequence[Sequence[Array]], checker: CollisionChecker, rules: Rules, speed: float = 1.0
) -> Trajectory:
    """The quickest trajectory along one of `paths` that keeps all limits and, sample by sample, all distances.

    The wider a curve's knots the quicker it is and the farther it cuts corners: they get closer until it is free.

    Args:
        arm: "left" or "right".
        phase: its name; those of `LINES` are followed closely.
        paths: waypoints, (7,) radians each, from the same beginning to the same end.
        checker: the world around, and what the hand holds.
        rules: what may be near to what.
        speed: fraction of the quickest speed.

    Raises:
        PlanInCollision: all of them come too near to something.
        LimitViolation: a trajectory exceeds a limit of a joint.
    """
    data = load_robot().arm(arm)
    near: Near | None = None
    for spacing in (LINE_SPACING,) if phase in LINES else KNOT_SPACINGS:
        options = [timed(path, data.limits, speed, spacing) for path in paths]
        for trajectory in sorted(options, key=lambda option: option.duration):
            check_limits(trajectory, data.joints, data.lower, data.upper, data.limits)
            near = checker.conflict_of(trajectory.positions, rules)
            if near is None:
                return trajectory
    assert near is not None
    raise phase_in_collision(phase, near, rules)


def phase_in_collision(phase: str, near: Near, rules: Rules) -> PlanInCollision:
    """The error for a phase that comes too near to something."""
    return PlanInCollision(
        f"during {phase} {describe(near)}; {1000 * rules.clearance:.0f} mm are kept, "
        f"{1000 * rules.hand_clearance:.1f} mm between hand and boxes",
        phase,
        near.bodies,
        near.distance,
        near.place,
    )
