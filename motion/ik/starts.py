"""The order in which starts are tried: the seed, the table's, random ones, more of the table's, the nearest misses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import NamedTuple

import numpy as np

from motion.ik.levenberg_marquardt import Descent
from motion.ik.problem import Problem
from motion.ik.seeds import NEIGHBOURS, SeedTable
from motion.poses import Array
from motion.robot.load import load_robot
from motion.robot.recipe import recipe
from motion.threads import shared

RESTARTS = 150
"""Starts at most, by default; nine in ten targets need one, and what is far out of reach is given up after thirty."""
_RANDOM = 6
_CLOSE = 0.03
"""Only where some start ends with less than this left (squared metres and radians) there are more than thirty."""
_NEARLY = 1e-2
"""Starts that end with less than this left (squared metres and radians) are worth a slower, surer descent."""
_PERSISTENT = 3


class Start(NamedTuple):
    """Joints to start from.

    Attributes:
        joints: (7,) radians.
        again: whether it is where an earlier start ended, just short of the target: for a slower, surer descent.
    """

    joints: Array
    again: bool = False


def starts_of(
    problem: Problem, missed: Sequence[Descent], restarts: int = RESTARTS, rng: np.random.Generator | None = None
) -> Iterator[Start]:
    """Starts for a problem, the most promising first.

    The table's farther ones are worth their time only where some start came close; elsewhere there are none.

    Args:
        problem: what is to be solved.
        missed: where the starts so far led that did not reach the target; the caller adds to it.
        restarts: how many at most, those that are tried again aside.
        rng: where random starts come from; a fixed seed by default.
    """
    left = restarts
    if problem.seed is not None:
        yield Start(problem.seed)
        left -= 1
    if left > 0:
        for start in islice(_from_table(problem), left):
            yield Start(start)
            left -= 1
    rng = np.random.default_rng(0) if rng is None else rng
    for _ in range(min(left, _RANDOM)):
        yield Start(rng.uniform(problem.arm.lower, problem.arm.upper))
        left -= 1
    if left > 0 and any(descent.left < _CLOSE for descent in missed):
        for start in islice(_from_table(problem, NEIGHBOURS + left), NEIGHBOURS, None):
            yield Start(start)
    nearly = sorted((descent for descent in missed if descent.left < _NEARLY), key=lambda descent: descent.left)
    for descent in nearly[:_PERSISTENT]:
        yield Start(descent.joints, again=True)


def nearest_starts(problem: Problem) -> list[Array]:
    """The table's configurations near the target, (7,) each in radians, the most promising first."""
    return list(_from_table(problem))


def _from_table(problem: Problem, count: int = NEIGHBOURS) -> Iterator[Array]:
    placement = problem.placement
    return iter(_table(problem.arm.name).starts(placement.translation, placement.rotation, problem.preferred, count))


@shared(maxsize=2)
def _table(arm: str) -> SeedTable:
    robot = load_robot()
    return SeedTable(robot.kinematics(arm), robot.arm(arm).wrist, recipe().home[arm])
