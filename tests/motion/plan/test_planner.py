import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import (
    Box,
    GraspUnavailable,
    InvalidGoal,
    RobotState,
    Scene,
    UnknownBody,
    UnreachableTarget,
    plan_home,
    plan_pick,
    plan_place,
)
from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Rules
from motion.path.trajectory import check_limits
from motion.robot.load import load_robot
from motion.robot.recipe import recipe

PICK = ["home", "pregrasp", "approach", "close", "lift", "hold"]
PLACE = ["home", "pregrasp", "approach", "close", "lift", "transfer", "lower", "open", "retreat", "home"]


def _joined(plan):
    assert all(
        np.allclose(first.trajectory.positions[-1], second.trajectory.positions[0], atol=1e-9)
        for first, second in zip(plan.phases[:-1], plan.phases[1:], strict=True)
    )
    assert np.allclose(plan.phases[0].trajectory.positions[0], plan.start.joints(plan.arm))
    assert np.allclose(plan.phases[-1].trajectory.positions[-1], plan.end.joints(plan.arm))
    arm = load_robot().arm(plan.arm)
    for phase in plan.phases:
        check_limits(phase.trajectory, arm.joints, arm.lower, arm.upper, arm.limits)


@pytest.mark.parametrize("name", ["b0", "b7", "b10", "b19"])
def test_a_pick_reaches_its_block_and_lifts_it(twenty_blocks, name):
    plan = plan_pick(twenty_blocks, name)
    assert [phase.name for phase in plan.phases] == PICK
    _joined(plan)
    robot, box = load_robot(), twenty_blocks.box(name)
    grasp = robot.tool_pose(plan.arm, plan.phases[2].trajectory.positions[-1])
    assert grasp.distance(plan.grasp.tool)[0] < 1e-4
    lifted = robot.tool_pose(plan.arm, plan.phases[4].trajectory.positions[-1])
    assert lifted.position - grasp.position == pytest.approx([0, 0, 0.10], abs=3e-4)
    assert plan.goal.position == pytest.approx(box.position + np.array([0, 0, 0.10]))
    assert dict(plan.end.held) == {plan.arm: name}


def test_the_way_to_the_block_keeps_clear_of_everything(twenty_blocks):
    plan = plan_pick(twenty_blocks, "b5")
    checker = CollisionChecker(twenty_blocks, plan.start, plan.arm, width=plan.grasp.opening)
    samples = list(plan.phases[1].trajectory.positions)
    assert checker.first_conflict(samples, Rules(clearance=0.0045, hand_clearance=0.0045)) is None


def test_approach_and_lift_are_straight_lines(twenty_blocks):
    plan = plan_pick(twenty_blocks, "b12")
    for phase in (plan.phases[2], plan.phases[4]):
        points = np.array([load_robot().tool_pose(plan.arm, q).position for q in phase.trajectory.positions[::20]])
        along = (points[-1] - points[0]) / np.linalg.norm(points[-1] - points[0])
        off = points - points[0] - np.outer((points - points[0]) @ along, along)
        assert np.max(np.linalg.norm(off, axis=1)) < 1e-3


def test_the_arm_can_be_chosen(one_block):
    middle = Scene((TABLE, block("b", 0.6, 0.0)))
    assert plan_pick(middle, "b", arm="left").arm == "left"
    assert plan_pick(middle, "b", arm="right").arm == "right"
    assert plan_pick(one_block, "b").arm == "right"
    with pytest.raises(InvalidGoal, match="'up'"):
        plan_pick(one_block, "b", arm="up")


def test_the_same_seed_gives_the_same_plan(tower):
    goal = tower.resting_position("t2", (0.5, 0.0))
    first, second = (plan_place(tower, "t2", goal, rng=np.random.default_rng(4)) for _ in range(2))
    for a, b in zip(first.phases, second.phases, strict=True):
        assert a.trajectory.positions.tobytes() == b.trajectory.positions.tobytes()
        assert a.gripper == b.gripper


def test_a_place_ends_at_home_with_the_hand_open(twenty_blocks):
    plan = plan_place(twenty_blocks, "b5", twenty_blocks.resting_position("b5", (0.6, -0.18)))
    assert [phase.name for phase in plan.phases] == PLACE
    _joined(plan)
    assert plan.end.joints(plan.arm) == pytest.approx(recipe().home[plan.arm])
    assert not plan.end.held


def test_a_given_yaw_is_met_up_to_the_symmetry_of_the_cube(one_block):
    plan = plan_place(one_block, "b", (0.6, -0.5, 0.736), yaw=0.4)
    x, y = plan.goal.rotation[:2, 0]
    assert np.sin(2 * (np.arctan2(y, x) - 0.4)) == pytest.approx(0, abs=1e-6)


def test_the_way_home_from_a_pick(one_block):
    picked = plan_pick(one_block, "b")
    lifted = one_block.moved({"b": picked.goal})
    plan = plan_home(lifted, start=picked.end)
    assert plan.arm == picked.arm
    assert plan.end.joints(plan.arm) == pytest.approx(recipe().home[plan.arm])
    assert plan.end.held == picked.end.held


@pytest.mark.parametrize("name", ["t0", "t1"])
def test_covered_blocks_are_refused_with_what_covers_them(tower, name):
    with pytest.raises(InvalidGoal, match=rf"'{name}' is under 't{int(name[1]) + 1}'"):
        plan_pick(tower, name)


def test_goals_that_make_no_sense_are_refused(tower):
    with pytest.raises(UnknownBody, match="'x'"):
        plan_pick(tower, "x")
    with pytest.raises(InvalidGoal, match="fixed"):
        plan_pick(tower, "table")
    wide = Scene((TABLE, block("w", 0.6, -0.3, edge=0.06)))
    with pytest.raises(InvalidGoal, match="60, 60 mm"):
        plan_pick(wide, "w")


@pytest.mark.parametrize(
    ("position", "words"),
    [
        ((np.nan, 0, 0.7), "finite"),
        ((0.6, 0.0), "three finite numbers"),
        ("there", "three finite numbers.*there"),
        (None, "three finite numbers"),
        ((0.58, 0.25, 0.736), "occupied by 't0'"),
        ((0.6, -0.2, 0.8), "hang 64 mm above 'table'.*z = 0.7360"),
        ((2.0, 0.0, 0.736), "off the table"),
        ((0.6, 0.899, 0.736), "tip off 'table'"),
        ((0.6, 0.0, 0.70), "occupied by 'table'"),
    ],
)
def test_destinations_that_make_no_sense_are_refused(tower, position, words):
    with pytest.raises(InvalidGoal, match=words):
        plan_place(tower, "a", position)


@pytest.mark.parametrize("lift", [np.nan, np.inf, 0, -0.1, "high"])
def test_lifts_that_make_no_sense_are_refused(one_block, lift):
    with pytest.raises(InvalidGoal, match="above 0"):
        plan_pick(one_block, "b", lift=lift)


def test_starts_that_make_no_sense_are_refused(one_block):
    home = RobotState.home()
    with pytest.raises(InvalidGoal, match=r"right_e0 at 9.000 rad; its range"):
        plan_pick(one_block, "b", start=RobotState(home.left, np.where(np.arange(7) == 2, 9.0, home.right)))
    with pytest.raises(InvalidGoal, match="finite widths"):
        RobotState(home.left, home.right, widths={"left": np.nan, "right": 0.05})
    with pytest.raises(InvalidGoal, match="finite widths"):
        RobotState(home.left, home.right, widths={"left": 0.05})
    with pytest.raises(InvalidGoal, match="middle"):
        RobotState(home.left, home.right, held={"middle": "b"})
    with pytest.raises(InvalidGoal, match="'up'"):
        plan_home(one_block, arm="up")


def test_unreachable_blocks_say_why():
    far = Scene((Box("f", (1.3, 0, 0.025)), Box("g", (0.6, 1.4, 0.7))))
    with pytest.raises(UnreachableTarget, match="too far") as caught:
        plan_pick(far, "f")
    assert caught.value.reason == "too far"
    with pytest.raises(UnreachableTarget):
        plan_pick(far, "g", arm="right")


def test_a_block_between_walls_cannot_be_grasped():
    walls = [
        Box(f"w{i}", (0.6 + dx, -0.3 + dy, TOP + 0.05), size=(0.02, 0.02, 0.1), fixed=True)
        for i, (dx, dy) in enumerate([(0.042, 0), (-0.042, 0), (0, 0.042), (0, -0.042)])
    ]
    with pytest.raises(GraspUnavailable, match=r"w\d") as caught:
        plan_pick(Scene((TABLE, block("b", 0.6, -0.3), *walls)), "b")
    assert caught.value.bodies is not None


def test_hands_that_are_full_are_not_used(one_block):
    start = RobotState(RobotState.home().left, RobotState.home().right, held={"left": "x", "right": "y"})
    with pytest.raises(InvalidGoal, match="no hand is free"):
        plan_pick(one_block, "b", start=start)


def test_narrow_gaps_are_reached_with_the_fingers_less_open():
    gap = 0.061
    around = {"l": (0, gap), "r": (0, -gap), "f": (gap, 0), "n": (-gap, 0)}
    others = [block(name, 0.6 + dx, -0.3 + dy, edge=0.04) for name, (dx, dy) in around.items()]
    target = block("b", 0.6, -0.3, edge=0.04)
    wide = plan_pick(Scene((TABLE, target)), "b").grasp.opening
    assert plan_pick(Scene((TABLE, target, *others)), "b").grasp.opening < wide
