from functools import partial

import numpy as np
import pytest
from motion_layouts import TABLE, TOP

from motion import Box, Pose, RobotState, Scene, solve_ik
from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Rules
from motion.collision.grid import SEARCH_GRID
from motion.path.search import connect
from motion.path.smoothing import smoothed
from motion.robot.load import load_robot

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])
WALL = Box("wall", (0.6, -0.45, TOP + 0.15), size=(0.3, 0.02, 0.3), fixed=True)


def _at(x, y, z):
    return solve_ik("right", Pose.of(DOWN, (x, y, z))).joints


@pytest.fixture(scope="module")
def checker():
    return CollisionChecker(Scene((TABLE, WALL)), RobotState.home(), "right")


def _bend(path):
    """Sum of the squared second differences over evenly spaced points of a polyline."""
    path = np.array(path)
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    places = np.linspace(0, along[-1], 30)
    points = np.column_stack([np.interp(places, along, column) for column in path.T])
    return float(np.sum(np.diff(points, 2, axis=0) ** 2))


@pytest.mark.parametrize("seed", range(3))
def test_a_detour_bends_less_and_stays_free_between_the_same_ends(checker, seed):
    rules, rng = Rules(), np.random.default_rng(seed)
    path = connect(checker, "right", _at(0.6, -0.65, 0.85), _at(0.6, -0.25, 0.85), rules, rng, "transfer", 400)
    free = partial(checker.free, rules=rules, grid=SEARCH_GRID)
    arm = load_robot().arm("right")
    found = smoothed(path, checker, rules, arm, free)
    assert np.array_equal(found[0], path[0])
    assert np.array_equal(found[-1], path[-1])
    assert checker.first_conflict(found, rules, SEARCH_GRID) is None
    assert np.all((np.array(found) >= arm.lower) & (np.array(found) <= arm.upper))
    assert _bend(found) <= _bend(path)


def test_slopes_of_distances_are_what_small_steps_say(checker):
    joints, rules, h = _at(0.6, -0.56, 0.85), Rules(), 1e-5
    nearest = min(checker.distances(joints, rules, 0.1), key=lambda found: found[0])
    for k in range(7):
        moved = joints + h * np.eye(7)[k]
        after = min(checker.distances(moved, rules, 0.1), key=lambda found: found[0])
        assert (after[0] - nearest[0]) / h == pytest.approx(nearest[2][k], abs=2e-2)


def test_without_room_the_path_is_kept(checker):
    first, last = _at(0.6, -0.65, 0.85), _at(0.6, -0.25, 0.85)
    path = [first, last, first]
    arm = load_robot().arm("right")
    found = smoothed(path, checker, Rules(), arm, lambda first, last: False)
    assert all(np.array_equal(a, b) for a, b in zip(found, path, strict=True))
