"""Paths found by sampling: RRT-Connect (Kuffner and LaValle, 2000), OMPL's where it is installed, else our own.

OMPL (Sucan, Moll and Kavraki, 2012) comes with the extra `ompl`. Both are bounded by a count and not by time, and draw
all chance from one seed, so that the same seed gives the same path.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from functools import lru_cache
from types import SimpleNamespace
from typing import Any

import numpy as np

from motion.poses import Array
from motion.robot.load import Arm

Free = Callable[[Array, Array], bool]
"""Tells whether the straight line between two configurations is free."""
Valid = Callable[[Array], bool]
"""Tells whether a configuration is free."""

_STEP = 0.35
_RANGE = 0.5
_ITERATIONS = 4
"""Iterations of OMPL's planner for one expansion of ours."""


def sampled_path(
    arm: Arm,
    free: Free,
    valid: Valid,
    start: Array,
    goal: Array,
    rng: np.random.Generator,
    expansions: int,
    grid: float,
) -> list[Array] | None:
    """Waypoints from `start` to `goal` whose straight lines are free, or None where none were found.

    Args:
        arm: whose joints they are.
        free: whether a line is free.
        valid: whether a configuration is free.
        start: (7,) radians, free.
        goal: (7,) radians, free.
        rng: source of all chance.
        expansions: how often the trees may grow.
        grid: longest step between two configurations that are checked, radians.
    """
    if expansions > 0 and _ompl() is not None:
        path = ompl_connect(arm, valid, start, goal, rng, expansions, grid)
        if path is not None and all(free(a, b) for a, b in itertools.pairwise(path)):
            return path
    return rrt_connect(arm, free, start, goal, rng, expansions)


def ompl_connect(
    arm: Arm, valid: Valid, start: Array, goal: Array, rng: np.random.Generator, expansions: int, grid: float
) -> list[Array] | None:
    """Waypoints from `start` to `goal` by OMPL's RRT-Connect, or None; arguments as for `sampled_path`."""
    ompl = _ompl()
    assert ompl is not None
    ompl.util.RNG.setSeed(int(rng.integers(1, 2**31)))
    count = len(start)
    space = ompl.base.RealVectorStateSpace(count)
    bounds = ompl.base.RealVectorBounds(count)
    for k in range(count):
        bounds.setLow(k, float(arm.lower[k]))
        bounds.setHigh(k, float(arm.upper[k]))
    space.setBounds(bounds)
    information = ompl.base.SpaceInformation(space)
    information.setStateValidityChecker(lambda state: valid(np.array([state[k] for k in range(count)])))
    information.setStateValidityCheckingResolution(grid / space.getMaximumExtent())
    information.setup()
    problem = ompl.base.ProblemDefinition(information)
    problem.setStartAndGoalStates(_state(space, start), _state(space, goal))
    planner = ompl.geometric.RRTConnect(information)
    planner.setRange(_RANGE)
    planner.setProblemDefinition(problem)
    planner.setup()
    left = itertools.count(_ITERATIONS * expansions, -1)
    planner.solve(ompl.base.PlannerTerminationCondition(lambda: next(left) <= 0))
    if not problem.hasExactSolution():
        return None
    states = problem.getSolutionPath().getStates()
    return [start, *(np.array([state[k] for k in range(count)]) for state in states[1:-1]), goal]


@lru_cache(maxsize=1)
def _ompl() -> Any:
    """OMPL's modules, quiet, or None where it is not installed."""
    try:
        from ompl import base, geometric, util
    except ImportError:
        return None
    util.setLogLevel(util.LogLevel.LOG_NONE)
    return SimpleNamespace(base=base, geometric=geometric, util=util)


def _state(space: Any, joints: Array) -> Any:
    state = space.allocState()
    for k, value in enumerate(joints):
        state[k] = float(value)
    return state


class _Tree:
    def __init__(self, root: Array) -> None:
        self.nodes = [root]
        self.parents = [-1]

    def nearest(self, point: Array) -> int:
        return int(np.argmin(np.max(np.abs(np.array(self.nodes) - point), axis=1)))

    def add(self, point: Array, parent: int) -> int:
        self.nodes.append(point)
        self.parents.append(parent)
        return len(self.nodes) - 1

    def branch(self, node: int) -> list[Array]:
        """From the node to the root."""
        path = []
        while node >= 0:
            path.append(self.nodes[node])
            node = self.parents[node]
        return path


def rrt_connect(
    arm: Arm, free: Free, start: Array, goal: Array, rng: np.random.Generator, expansions: int
) -> list[Array] | None:
    """Waypoints from `start` to `goal` by RRT-Connect, or None; arguments as for `sampled_path`."""
    trees = [_Tree(start), _Tree(goal)]
    middle, spread = (start + goal) / 2, np.abs(goal - start) / 2 + 0.6
    for count in range(expansions):
        # First near the two ends, later anywhere.
        reach = spread * (1 + count / 40)
        sample = np.clip(middle + rng.uniform(-reach, reach), arm.lower, arm.upper)
        growing, other = trees[count % 2], trees[1 - count % 2]
        node = _extend(free, growing, sample)
        if node is None:
            continue
        target = growing.nodes[node]
        meeting: int | None = None
        while True:
            following = _extend(free, other, target, meeting)
            if following is None:
                break
            meeting = following
            if np.max(np.abs(other.nodes[meeting] - target)) < 1e-9:
                a, b = growing.branch(node), other.branch(meeting)
                joined = a[::-1] + b[1:]
                return joined if count % 2 == 0 else joined[::-1]
    return None


def _extend(free: Free, tree: _Tree, target: Array, source: int | None = None) -> int | None:
    """Grows the tree one step towards `target`; the new node, or None when that step is not free."""
    near = tree.nearest(target) if source is None else source
    origin = tree.nodes[near]
    gap = float(np.max(np.abs(target - origin)))
    if gap < 1e-9:
        return near
    point = target if gap <= _STEP else origin + (target - origin) * (_STEP / gap)
    return tree.add(point, near) if free(origin, point) else None
