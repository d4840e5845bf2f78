import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import (
    Box,
    GraspUnavailable,
    InvalidGoal,
    RobotState,
    Scene,
    Simulator,
    UnknownBody,
    plan_pick,
    plan_unstacking,
    stacked_on,
)
from motion.plan.free_spots import MARGIN, ROOM, free_spots
from motion.polygons import overlap


def test_what_stands_on_a_box_is_told_from_above(tower):
    assert [box.name for box in stacked_on(tower, "t0")] == ["t2", "t1"]
    assert [box.name for box in stacked_on(tower, "t1")] == ["t2"]
    assert [box.name for box in stacked_on(tower, "t1", held=("t2",))] == []
    assert stacked_on(tower, "t2") == stacked_on(tower, "a") == ()
    with pytest.raises(UnknownBody):
        stacked_on(tower, "nothing")


def test_a_bridge_stands_on_both_of_its_piers():
    bridge = Box("bridge", (0.6, 0.3, TOP + 0.07), size=(0.05, 0.2, 0.04))
    scene = Scene((TABLE, block("p", 0.6, 0.23), block("q", 0.6, 0.37), bridge))
    assert [box.name for box in stacked_on(scene, "p")] == ["bridge"]
    assert [box.name for box in stacked_on(scene, "q")] == ["bridge"]


def test_a_stack_is_taken_apart_and_its_lowest_block_is_picked(tower):
    plans = plan_unstacking(tower, "t0")
    assert [plan.target for plan in plans] == ["t2", "t1"]
    with Simulator(tower) as simulator:
        for plan in plans:
            assert simulator.execute(plan).contacts == ()
        simulator.settle()
        scene, state = simulator.scene(), simulator.state()
        assert stacked_on(scene, "t0") == ()
        for plan in plans:
            assert scene.box(plan.target).pose.distance(plan.goal)[0] < 0.005
        pick = plan_pick(scene, "t0", start=state)
        assert simulator.execute(pick).holding == ("t0",)
        for name in ("a", "b"):
            assert simulator.pose(name).distance(tower.box(name).pose)[0] < 1e-3


def test_nothing_is_planned_where_nothing_stands(tower):
    assert plan_unstacking(tower, "a") == ()


def test_places_that_are_to_be_kept_free_are(tower):
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    usual = plan_unstacking(tower, "t1")[0].goal
    region = usual.position[:2] + 0.1 * square
    plan = plan_unstacking(tower, "t1", keep_free=[region])[0]
    assert overlap(tower.box("t2").at(plan.goal).footprint, region) < 0


def test_what_cannot_be_set_aside_is_told(tower):
    lid = Box("lid", (0.58, 0.25, TOP + 0.19), size=(0.08, 0.08, 0.08))
    with pytest.raises(GraspUnavailable, match=r"'t0' is under 'lid', which cannot be set aside first.*80, 80 mm"):
        plan_unstacking(Scene((*tower.boxes, lid)), "t0")
    small = Box("small", (0.58, 0.25, TOP - 0.02), size=(0.12, 0.12, 0.04), fixed=True)
    stack = [block(f"t{level}", 0.58, 0.25, level=level) for level in range(2)]
    with pytest.raises(GraspUnavailable, match="no free room"):
        plan_unstacking(Scene((small, *stack)), "t0")
    with pytest.raises(InvalidGoal, match="fixed"):
        plan_unstacking(tower, "table")
    with pytest.raises(UnknownBody):
        plan_unstacking(tower, "nothing")
    full = RobotState(RobotState.home().left, RobotState.home().right, held={"left": "x", "right": "y"})
    with pytest.raises(GraspUnavailable, match="no hand is free"):
        plan_unstacking(tower, "t0", start=full)


def test_free_spots_keep_away_from_boxes_and_edges(twenty_blocks):
    spots = free_spots(twenty_blocks, "b3")
    for box in twenty_blocks.boxes:
        if not box.fixed and box.name != "b3":
            assert np.min(np.linalg.norm(spots[:, :2] - box.position[:2], axis=1)) >= 0.05 + ROOM
    table = twenty_blocks.box("table")
    inside = table.half_extents[:2] - np.abs(spots[:, :2] - table.position[:2])
    assert inside.min() >= 0.025 + MARGIN
    assert spots[:, 2] == pytest.approx(TOP + 0.025)
