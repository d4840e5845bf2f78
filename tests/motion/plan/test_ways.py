import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from motion_layouts import TABLE, TOP, block

from motion import Box, RobotState, Scene, plan_pick, plan_place
from motion.plan.budget import Budget
from motion.plan.goals import heading
from motion.plan.ways import Way, first_plan

detours = st.lists(st.lists(st.integers(0, 3), max_size=4), max_size=20)


def _way(order, count, plan):
    return Way(count, lambda: order.append(count) or plan)


@given(detours)
def test_a_direct_way_is_taken_before_any_search_among_the_same_few_grasps(grasps):
    order = []
    found = first_plan((iter([_way(order, count, count + 1) for count in ways]) for ways in grasps), Budget(60.0, "b"))
    every = [count for ways in grasps for count in ways]
    if not every:
        assert found is None
    else:
        assert order == [found - 1]
        if 0 in [count for ways in grasps[:8] for count in ways]:
            assert found == 1


@given(detours)
def test_ways_that_fail_are_followed_by_others_and_searches_are_bounded(grasps):
    order = []
    ways_of_each = (iter([_way(order, count, None) for count in ways]) for ways in grasps)
    assert first_plan(ways_of_each, Budget(60.0, "b")) is None
    assert order.count(0) == sum(ways.count(0) for ways in grasps)
    assert sum(count > 0 for count in order) == sum(min(2, sum(count > 0 for count in ways)) for ways in grasps)


def test_a_box_keeps_its_heading_where_it_can():
    scene = Scene((TABLE, block("b", 0.6, -0.3, yaw=0.3)))
    plan = plan_place(scene, "b", scene.resting_position("b", (0.55, -0.45)))
    turn = heading(scene.box("b").at(plan.goal)) - heading(scene.box("b"))
    assert abs(np.sin(2 * turn)) < 1e-6


def test_a_long_box_keeps_its_heading_up_to_half_a_turn():
    long = Box("b", (0.6, -0.3, 0.736), size=(0.09, 0.04, 0.05))
    scene = Scene((TABLE, long))
    plan = plan_place(scene, "b", scene.resting_position("b", (0.55, -0.5)))
    assert abs(np.sin(heading(long.at(plan.goal)) - heading(long))) < 1e-6


def test_the_same_seed_gives_the_same_way(twenty_blocks):
    plans = [plan_pick(twenty_blocks, "b9", rng=np.random.default_rng(3), start=RobotState.home()) for _ in range(2)]
    assert plans[0].grasp.tool.position.tolist() == plans[1].grasp.tool.position.tolist()
    for one, other in zip(plans[0].phases, plans[1].phases, strict=True):
        assert one.trajectory.positions.tobytes() == other.trajectory.positions.tobytes()


def test_postures_near_a_singular_one_come_last():
    """Here the first posture found lifts the block in 4.4 s."""
    box = Box("b", (0.4231, -0.2704, TOP + 0.02), (np.cos(0.7218), 0, 0, np.sin(0.7218)), (0.04, 0.04, 0.04))
    plan = plan_pick(Scene((TABLE, box)), "b")
    assert {phase.name: phase.duration for phase in plan.phases}["lift"] < 1.2
