import numpy as np
import pytest
from motion_layouts import TABLE, block

from motion import (
    Box,
    GraspUnavailable,
    InvalidGoal,
    Scene,
    UnknownBody,
    UnreachableTarget,
    grasp_candidates,
    load_robot,
    plan_pick,
    reach_box,
    reach_grasp,
)
from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Rules
from motion.poses import Pose, about
from motion.robot.state import RobotState


def test_every_way_leads_to_its_grasp_and_up(twenty_blocks):
    reaches = reach_box(twenty_blocks, "b9")
    assert {reach.grasp.arm for reach in reaches} == {"left", "right"}
    kinds = [(reach.grasp.arm, abs(reach.grasp.tilt)) for reach in reaches]
    assert len(kinds) == len(set(kinds))
    for reach in reaches:
        grasp, robot = reach.grasp, load_robot()
        assert robot.tool_pose(grasp.arm, reach.joints).distance(grasp.tool)[0] < 1e-4
        first = robot.tool_pose(grasp.arm, reach.approach[0])
        assert first.distance(grasp.backed(0.08))[0] < 1e-3
        top = robot.tool_pose(grasp.arm, reach.lift[-1])
        assert top.position == pytest.approx(grasp.tool.position + 0.1 * np.eye(3)[2], abs=1e-3)
        checker = CollisionChecker(twenty_blocks, RobotState.home(), grasp.arm, width=grasp.opening)
        rules = Rules(hand_clearance=0.0015, touching=frozenset({"b9"}), close=frozenset({"table"}))
        assert checker.first_conflict(list(reach.approach), rules) is None


@pytest.mark.parametrize(("x", "y"), [(0.5, -0.6), (0.8, 0.3), (0.9, 0.15), (0.4, 0.0), (0.72, -0.7)])
def test_what_is_said_to_be_reached_is_picked(x, y):
    scene = Scene((TABLE, block("b", x, y, yaw=0.3)))
    reaches = reach_box(scene, "b")
    plan = plan_pick(scene, "b", rng=np.random.default_rng(0))
    assert plan.arm in {reach.grasp.arm for reach in reaches}


def test_only_the_top_of_a_tower_is_reached(tower):
    assert reach_box(tower, "t2")
    with pytest.raises(InvalidGoal, match=r"under 't2'.*moved first"):
        reach_box(tower, "t1")
    with pytest.raises(InvalidGoal, match="under 't1'"):
        reach_box(tower, "t0")


def test_mirrored_worlds_are_reached_alike():
    ways = []
    for side in (1, -1):
        scene = Scene((TABLE, block("b", 0.85, 0.35 * side, yaw=0.2 * side)))
        ways.append({(reach.grasp.arm, abs(reach.grasp.tilt)) for reach in reach_box(scene, "b")})
    other = {"left": "right", "right": "left"}
    assert ways[1] == {(other[arm], tilt) for arm, tilt in ways[0]}


def test_what_is_out_of_reach_says_why():
    with pytest.raises(UnreachableTarget, match=r"'b' cannot be reached by any of 56 grasps.*too far") as caught:
        reach_box(Scene((TABLE, block("b", 0.97, 0.85))), "b")
    assert caught.value.reason == "too far"
    lid = Box("lid", (0.6, -0.3, 0.85), size=(0.4, 0.4, 0.02), fixed=True)
    with pytest.raises(GraspUnavailable, match="lid") as caught:
        reach_box(Scene((TABLE, lid, block("b", 0.6, -0.3))), "b")
    assert "lid" in caught.value.bodies


def test_a_grasp_that_cannot_be_backed_out_of_is_refused():
    scene = Scene((TABLE, Box("lid", (0.6, -0.3, 1.03), size=(0.3, 0.3, 0.1), fixed=True), block("b", 0.6, -0.3)))
    grasp = grasp_candidates(scene, "b", ("right",))[0]
    with pytest.raises(UnreachableTarget) as caught:
        reach_grasp(scene, grasp)
    assert caught.value.reason == "collision"
    assert "lid" in caught.value.bodies


def test_bad_input_is_refused(one_block):
    with pytest.raises(UnknownBody, match="'c'"):
        reach_box(one_block, "c")
    with pytest.raises(InvalidGoal, match="fixed"):
        reach_box(one_block, "table")
    with pytest.raises(InvalidGoal, match="60, 60 mm"):
        reach_box(Scene((TABLE, block("b", 0.6, 0.2, edge=0.06))), "b")


@pytest.mark.parametrize("edge", [0.02, 0.035, 0.055])
def test_boxes_of_two_to_five_and_a_half_centimetres_are_reached(edge):
    scene = Scene((TABLE, block("b", 0.6, 0.2, edge=edge, yaw=1.0)))
    assert {reach.grasp.arm for reach in reach_box(scene, "b")} == {"left", "right"}


def test_boxes_on_any_face_are_reached():
    up = Pose.of(about((0, 0, 1), 0.4) @ about((1, 0, 0), np.pi / 2), (0.6, 0.2, 0.736))
    scene = Scene((TABLE, block("b", 0.6, 0.2).at(up)))
    assert reach_box(scene, "b")
