import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import Pose, RobotState, Scene
from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Rules
from motion.collision.grid import GRID, dense
from motion.ik.solver import solve_ik
from motion.robot.recipe import recipe

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])
HOME = RobotState.home()


def _at(x, y, z, arm="right"):
    return solve_ik(arm, Pose.of(DOWN, (x, y, z))).joints


def test_home_and_zero_are_free(twenty_blocks):
    checker = CollisionChecker(twenty_blocks, HOME, "right")
    assert checker.nearest(HOME.right, Rules()) is None
    zero = RobotState(np.zeros(7), np.zeros(7))
    assert CollisionChecker(Scene(()), zero, "left").nearest(np.zeros(7), Rules()) is None


def test_the_table_is_hit_and_named(one_block):
    near = CollisionChecker(one_block, HOME, "right").nearest(_at(0.6, -0.5, TOP - 0.02), Rules())
    assert near is not None
    assert "table" in near.bodies
    assert near.distance < -0.01


def test_clearance_is_the_distance_that_is_kept(one_block):
    joints = _at(0.6, -0.5, TOP + 0.00515 + 0.003)
    checker = CollisionChecker(one_block, HOME, "right")
    near = checker.nearest(joints, Rules())
    assert near is not None
    assert near.distance == pytest.approx(0.003, abs=3e-4)
    assert checker.nearest(joints, Rules(hand_clearance=0.001)) is None


def test_fingers_may_touch_only_what_they_are_told_to(one_block):
    joints = _at(0.6, -0.3, TOP + 0.02)
    checker = CollisionChecker(one_block, HOME, "right", width=0.045)
    near = checker.nearest(joints, Rules(hand_clearance=0.001))
    assert near is not None
    assert "b" in near.bodies
    assert checker.nearest(joints, Rules(hand_clearance=0.001, touching=frozenset({"b"}))) is None


def test_the_held_block_is_part_of_the_robot():
    scene = Scene((TABLE, block("b", 0.6, -0.3), block("c", 0.6, -0.5)))
    grip = Pose(np.array([0, 0, 0.0]), np.array([1, 0, 0, 0]))
    rules = Rules(hand_clearance=0.001)
    over = _at(0.6, -0.5, TOP + 0.05 + 0.04)
    against = _at(0.6, -0.5, TOP + 0.05 + 0.02)
    empty = CollisionChecker(scene, HOME, "right", width=0.05)
    full = CollisionChecker(scene, HOME, "right", width=0.05, held="b", grip=grip)
    assert full.nearest(over, rules) is None
    assert empty.nearest(against, rules) is None
    near = full.nearest(against, rules)
    assert near is not None
    assert set(near.bodies) == {"b", "c"}
    assert near.distance == pytest.approx(-0.005, abs=5e-4)
    assert full.around_held(against, 0.003) == {"c"}


def test_the_other_arm_is_an_obstacle():
    alone = CollisionChecker(Scene(()), HOME, "left")
    free = lambda joints: alone.nearest(joints, Rules()) is None  # noqa: E731
    joints = solve_ik("left", Pose.of(DOWN, (0.5, -0.1, 0.9)), accept=free).joints
    reach = solve_ik("right", Pose.of(DOWN, (0.5, -0.1, 0.9))).joints
    near = CollisionChecker(Scene(()), RobotState(joints, HOME.right), "right").nearest(reach, Rules())
    assert near is not None
    assert {body[0] for body in near.bodies} == {"l", "r"}


def test_lines_are_checked_on_the_grid(one_block):
    first, last = _at(0.6, -0.5, 0.9), _at(0.6, -0.1, 0.9)
    points = list(dense([first, last]))
    assert np.max(np.abs(np.diff(points, axis=0))) <= GRID + 1e-12
    low = [_at(0.6, -0.5, TOP + 0.02), _at(0.6, -0.1, TOP + 0.02)]
    checker = CollisionChecker(one_block, HOME, "right", width=0.03)
    assert checker.first_conflict(low, Rules(hand_clearance=0.001)) is not None
    assert not checker.free(low[0], low[1], Rules(hand_clearance=0.001))
    assert checker.free(first, last, Rules())
    assert recipe().gripper.opened > 0.055
