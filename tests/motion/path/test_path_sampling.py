from functools import partial

import numpy as np
import pytest
from motion_layouts import TABLE, TOP

from motion import Box, Pose, RobotState, Scene, solve_ik
from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Rules
from motion.collision.grid import SEARCH_GRID
from motion.path.sampling import ompl_connect, rrt_connect
from motion.robot.load import load_robot

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])
WALL = Box("wall", (0.6, -0.45, TOP + 0.15), size=(0.3, 0.02, 0.3), fixed=True)
ARM = load_robot().arm("right")


def _at(x, y, z):
    return solve_ik("right", Pose.of(DOWN, (x, y, z))).joints


@pytest.fixture(scope="module")
def checker():
    return CollisionChecker(Scene((TABLE, WALL)), RobotState.home(), "right")


def _ours(checker, first, last, seed, expansions=400):
    free = partial(checker.free, rules=Rules(), grid=SEARCH_GRID)
    return rrt_connect(ARM, free, first, last, np.random.default_rng(seed), expansions)


def _ompl(checker, first, last, seed, expansions=400):
    pytest.importorskip("ompl", reason="the extra ompl is not installed")
    valid = lambda joints: checker.nearest(joints, Rules()) is None  # noqa: E731
    return ompl_connect(ARM, valid, first, last, np.random.default_rng(seed), expansions, SEARCH_GRID)


@pytest.mark.parametrize("planner", [_ours, _ompl])
@pytest.mark.parametrize("seed", range(2))
def test_a_way_around_the_wall_is_free_and_the_same_for_the_same_seed(checker, planner, seed):
    first, last = _at(0.6, -0.65, 0.85), _at(0.6, -0.25, 0.85)
    path = planner(checker, first, last, seed)
    assert np.array_equal(path[0], first)
    assert np.array_equal(path[-1], last)
    assert all(checker.nearest(joints, Rules()) is None for joints in path)
    assert np.all((np.array(path) >= ARM.lower) & (np.array(path) <= ARM.upper))
    again = planner(checker, first, last, seed)
    assert all(np.array_equal(a, b) for a, b in zip(path, again, strict=True))


@pytest.mark.parametrize("planner", [_ours, _ompl])
def test_the_search_is_bounded(checker, planner):
    assert planner(checker, _at(0.6, -0.65, 0.85), _at(0.6, -0.25, 0.85), 0, expansions=0) is None
