import numpy as np
import pytest
from motion_layouts import TABLE, TOP

from motion import Box, PathNotFound, Pose, RobotState, Scene
from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Near, Rules
from motion.errors import PlanInCollision
from motion.ik.solver import solve_ik
from motion.path.search import connect, describe, straight
from motion.robot.load import load_robot

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])
WALL = Box("wall", (0.6, -0.45, TOP + 0.15), size=(0.3, 0.02, 0.3), fixed=True)


def _at(x, y, z):
    return solve_ik("right", Pose.of(DOWN, (x, y, z))).joints


def _connect(scene, first, last, expansions=400, seed=0):
    checker = CollisionChecker(scene, RobotState.home(), "right")
    rng = np.random.default_rng(seed)
    return connect(checker, "right", first, last, Rules(), rng, "transfer", expansions), checker


def test_free_lines_stay_lines():
    first, last = _at(0.6, -0.6, 0.85), _at(0.6, -0.3, 0.85)
    path, _ = _connect(Scene((TABLE,)), first, last)
    assert len(path) == 2


@pytest.mark.parametrize("seed", range(3))
def test_walls_are_passed_with_clearance(seed):
    first, last = _at(0.6, -0.65, 0.85), _at(0.6, -0.25, 0.85)
    path, checker = _connect(Scene((TABLE, WALL)), first, last, seed=seed)
    assert not checker.free(first, last, Rules())
    assert len(path) > 2
    assert np.array_equal(path[0], first)
    assert np.array_equal(path[-1], last)
    assert checker.first_conflict(path, Rules()) is None
    arm = load_robot().arm("right")
    assert np.all((np.array(path) >= arm.lower) & (np.array(path) <= arm.upper))


def test_ends_in_conflict_are_named():
    with pytest.raises(PlanInCollision, match=r"goal of transfer.*wall") as caught:
        _connect(Scene((TABLE, WALL)), _at(0.6, -0.65, 0.85), _at(0.6, -0.45, 0.85))
    assert "wall" in caught.value.bodies


def test_searches_are_bounded():
    with pytest.raises(PathNotFound, match="0 expansions"):
        _connect(Scene((TABLE, WALL)), _at(0.6, -0.65, 0.85), _at(0.6, -0.25, 0.85), expansions=0)


def test_the_tool_keeps_to_its_line():
    first, last = Pose.of(DOWN, (0.6, -0.3, 0.85)), Pose.of(DOWN, (0.6, -0.3, 0.75))
    path = straight("right", first, last, solve_ik("right", first).joints)
    assert path is not None
    for joints in path:
        tool = load_robot().tool_pose("right", joints)
        assert tool.position[:2] == pytest.approx(first.position[:2], abs=1e-4)
    assert straight("right", first, Pose.of(DOWN, (1.6, -0.3, 0.75)), path[0]) is None


def test_conflicts_in_words():
    assert describe(Near(("a", "b"), 0.003)) == "a and b are 3.0 mm apart"
    assert describe(Near(("a", "b"), -0.001)) == "a and b overlap by 1.0 mm"
