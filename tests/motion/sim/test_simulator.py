from dataclasses import replace

import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import Box, InvalidGoal, RobotState, Scene, Simulator, plan_home, plan_pick, plan_place
from motion.path.trajectory import rest
from motion.poses import about, quaternion

MILLIMETRES = 1000


def _error(simulator, plan):
    return MILLIMETRES * simulator.poses()[plan.target].distance(plan.goal)[0]


def _others(simulator, scene, target):
    return MILLIMETRES * max(
        (simulator.poses()[box.name].distance(box.pose)[0] for box in scene.boxes if box.name != target), default=0.0
    )


@pytest.mark.parametrize("name", ["b0", "b6", "b12", "b19"])
def test_a_picked_block_is_held_for_two_seconds(twenty_blocks, name):
    plan = plan_pick(twenty_blocks, name)
    with Simulator(twenty_blocks) as simulator:
        execution = simulator.execute(plan)
        simulator.hold(2.0)
        assert simulator.holding(plan.arm) == (name,)
        assert _error(simulator, plan) < 1
        assert _others(simulator, twenty_blocks, name) < 1
        assert execution.contacts == ()
        assert execution.tracking_error < 0.02
        assert simulator.gripper_width(plan.arm) == pytest.approx(0.05, abs=1e-3)
        assert simulator.time == pytest.approx(plan.duration + 2.0)
        assert dict(simulator.state().held) == {plan.arm: name}


@pytest.mark.parametrize("edge", [0.03, 0.04, 0.055])
@pytest.mark.parametrize("mass", [0.05, 0.2])
def test_blocks_of_other_sizes_and_masses(edge, mass):
    scene = Scene((TABLE, block("b", 0.55, 0.3, edge=edge, yaw=0.5, mass=mass)))
    plan = plan_pick(scene, "b")
    with Simulator(scene) as simulator:
        simulator.execute(plan)
        simulator.hold(1.0)
        assert _error(simulator, plan) < 2


def test_a_block_on_another_face():
    rotation = about((0, 0, 1), 0.4) @ about((1, 0, 0), np.pi / 2) @ about((0, 1, 0), np.pi)
    scene = Scene((TABLE, Box("b", (0.6, 0.2, TOP + 0.025), quaternion(rotation))))
    plan = plan_pick(scene, "b")
    with Simulator(scene) as simulator:
        simulator.execute(plan)
        assert _error(simulator, plan) < 1


@pytest.mark.parametrize("spot", [(0.6, -0.18), (0.7, -0.7)])
def test_a_placed_block_rests_at_its_goal(twenty_blocks, spot):
    plan = plan_place(twenty_blocks, "b5", twenty_blocks.resting_position("b5", spot))
    with Simulator(twenty_blocks) as simulator:
        execution = simulator.execute(plan)
        simulator.hold(0.5)
        assert _error(simulator, plan) < 2
        assert _others(simulator, twenty_blocks, "b5") < 1
        assert ("b5", "table") in simulator.contacts()
        assert execution.contacts == ()
        assert simulator.holding(plan.arm) == ()


def test_a_tower_of_three_is_built_and_taken_down(twenty_blocks):
    with Simulator(twenty_blocks) as simulator:
        for name in ("b4", "b8"):
            scene = simulator.scene()
            goal = scene.resting_position(name, scene.box("b5").position[:2])
            plan = plan_place(scene, name, goal, start=simulator.state())
            simulator.execute(plan)
            assert _error(simulator, plan) < 2
        assert [box.name for box in simulator.scene().boxes_above("b5")] == ["b4"]
        with pytest.raises(InvalidGoal, match="under"):
            plan_pick(simulator.scene(), "b5", start=simulator.state())
        top = plan_pick(simulator.scene(), "b8", start=simulator.state())
        simulator.execute(top)
        assert _error(simulator, top) < 2
        held = simulator.scene()
        back = plan_place(held, "b8", (0.55, -0.18, 0.736), start=simulator.state())
        assert [phase.name for phase in back.phases] == ["transfer", "lower", "open", "retreat", "home"]
        simulator.execute(back)
        assert _error(simulator, back) < 2


def test_the_way_home_with_a_block_in_the_hand(one_block):
    with Simulator(one_block) as simulator:
        simulator.execute(plan_pick(one_block, "b"))
        plan = plan_home(simulator.scene(), start=simulator.state())
        simulator.execute(plan)
        assert simulator.holding(plan.arm) == ("b",)


def test_each_hand_holds_its_own_block(twenty_blocks):
    with Simulator(twenty_blocks) as simulator:
        for name in ("b17", "b5"):
            plan = plan_pick(simulator.scene(), name, start=simulator.state())
            assert simulator.execute(plan).contacts == ()
        assert dict(simulator.state().held) == {"left": "b17", "right": "b5"}
        with pytest.raises(InvalidGoal, match="no hand is free"):
            plan_pick(simulator.scene(), "b0", start=simulator.state())
        plan = plan_place(simulator.scene(), "b17", (0.65, 0.75, 0.736), start=simulator.state())
        simulator.execute(plan)
        assert _error(simulator, plan) < 2
        assert dict(simulator.state().held) == {"right": "b5"}


def test_a_block_that_was_lost_is_taken_again(one_block):
    with Simulator(one_block) as simulator:
        plan = plan_pick(one_block, "b")
        simulator.execute(plan)
        opened = [phase for phase in plan_place(one_block, "b", (0.6, -0.5, 0.736)).phases if phase.name == "open"]
        simulator.run_phase(plan.arm, "b", replace(opened[0], trajectory=rest(plan.end.joints(plan.arm), 0.5)))
        assert simulator.settle(3.0)
        assert simulator.holding(plan.arm) == ()
        again = plan_pick(simulator.scene(), "b", start=simulator.state())
        simulator.execute(again)
        assert simulator.holding(again.arm) == ("b",)


def test_the_way_home_from_around_a_block(one_block):
    plan = plan_pick(one_block, "b")
    with Simulator(one_block) as simulator:
        for phase in plan.phases[:3]:
            simulator.run_phase(plan.arm, plan.target, phase)
        home = plan_home(simulator.scene(), start=simulator.state())
        assert [phase.name for phase in home.phases] == ["retreat", "home"]
        again = plan_pick(simulator.scene(), "b", start=simulator.state())
        assert [phase.name for phase in again.phases][:3] == ["retreat", "home", "pregrasp"]
        simulator.execute(home)
        assert _others(simulator, one_block, "") < 1


def test_the_same_plan_gives_the_same_bytes(tower):
    plan = plan_pick(tower, "t2")
    ends = []
    for _ in range(2):
        with Simulator(tower) as simulator:
            simulator.execute(plan)
            ends.append(b"".join(pose.position.tobytes() + pose.orientation.tobytes()
                                 for pose in simulator.poses().values()))  # fmt: skip
    assert ends[0] == ends[1]


def test_every_step_is_shown(one_block):
    plan, times = plan_pick(one_block, "b"), []
    with Simulator(one_block) as simulator:
        simulator.execute(plan, lambda running: times.append(running.time))
    assert len(times) == round(plan.duration / 0.002)


def test_plans_that_begin_elsewhere_are_refused(one_block):
    start = RobotState(RobotState.home().left + 0.2, RobotState.home().right)
    with Simulator(one_block, start) as simulator, pytest.raises(InvalidGoal, match=r"begins 0.200 rad"):
        simulator.execute(plan_pick(one_block, "b"))


def test_blocks_in_the_air_fall_and_settle():
    scene = Scene((TABLE, block("b", 0.6, -0.3).at(block("x", 0.6, -0.3, level=1).pose)))
    with Simulator(scene) as simulator:
        assert not simulator.settle(0.1)
        assert simulator.settle(2.0)
        assert simulator.poses()["b"].position[2] == pytest.approx(TOP + 0.025, abs=1e-3)
        assert simulator.contacts() == (("b", "table"),) or simulator.contacts() == ()


def test_nothing_on_the_table_moves_by_itself(tower):
    with Simulator(tower) as simulator:
        simulator.hold(1.0)
        assert _others(simulator, tower, "") < 0.5


def test_a_block_that_is_held_where_it_stood_is_lifted_first():
    scene = Scene((TABLE, block("b", 0.6, -0.3, edge=0.04)))
    plan = plan_pick(scene, "b")
    with Simulator(scene) as simulator:
        for phase in plan.phases[:4]:
            simulator.run_phase(plan.arm, plan.target, phase)
        assert simulator.holding(plan.arm) == ("b",)
        place = plan_place(simulator.scene(), "b", (0.6, -0.5, TOP + 0.02), start=simulator.state())
        assert [phase.name for phase in place.phases] == ["lift", "transfer", "lower", "open", "retreat", "home"]
        assert simulator.execute(place).contacts == ()
        assert _error(simulator, place) < 2
