from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from motion_layouts import TABLE, block

from motion import InvalidGoal, Jam, Push, Scene, Sensor, Simulator, Slip, load_robot, plan_pick
from motion.path.trajectory import check_limits
from motion.robot.recipe import recipe
from motion.sim.braking import braked


def _carried_out(scene, *faults):
    plan = plan_pick(scene, "b")
    simulator = Simulator(scene, faults=faults)
    records = [simulator.run_phase(plan.arm, plan.target, phase) for phase in plan.phases]
    return simulator, plan, {record.name: record for record in records}


@pytest.mark.parametrize(("phase", "share"), [("lift", 0.5), ("hold", 0.0)])
def test_what_slips_is_no_longer_held(one_block, phase, share):
    simulator, plan, _ = _carried_out(one_block, Slip(phase, share))
    with simulator:
        simulator.settle(3.0)
        assert simulator.holding(plan.arm) == ()
        assert simulator.poses()["b"].position[2] < 0.75
        assert [type(fault) for fault in simulator.happened] == [Slip]


def test_a_push_moves_its_box_and_nothing_else():
    scene = Scene((TABLE, block("b", 0.6, -0.3), block("c", 0.6, 0.2)))
    with Simulator(scene, faults=[Push("c", (0.03, -0.01), 0.4, "pregrasp", 0.2)]) as simulator:
        plan = plan_pick(scene, "b")
        simulator.execute(plan)
        distance, angle = simulator.poses()["c"].distance(scene.box("c").pose)
        assert distance == pytest.approx(np.hypot(0.03, 0.01), abs=1e-3)
        assert angle == pytest.approx(0.4, abs=0.01)
        assert simulator.poses()["b"].distance(plan.goal)[0] < 2e-3


def test_a_jammed_gripper_does_not_close(one_block):
    simulator, plan, records = _carried_out(one_block, Jam("right", least=0.055))
    with simulator:
        assert records["close"].gripper_width == pytest.approx(0.055, abs=1e-3)
        assert simulator.holding(plan.arm) == ()


def test_a_jam_ends(one_block):
    simulator, plan, _ = _carried_out(one_block, Jam("right", least=0.055, seconds=0.1))
    with simulator:
        assert simulator.holding(plan.arm) == ("b",)


def test_faults_of_what_is_not_there_are_refused(one_block):
    with pytest.raises(InvalidGoal, match="'x'"):
        Simulator(one_block, faults=[Push("x", (0.1, 0))])
    with pytest.raises(InvalidGoal, match="'third'"):
        Simulator(one_block, faults=[Jam("third")])


@cache
def _plan(scene):
    return plan_pick(scene, "b")


@given(phase=st.sampled_from([1, 2, 3, 4]), share=st.floats(0.01, 0.99))
@settings(max_examples=40, deadline=None)
def test_a_stop_stays_on_the_path_and_within_all_limits(one_block, phase, share):
    plan = _plan(one_block)
    trajectory = plan.phases[phase].trajectory
    sample = int(share * len(trajectory.positions))
    stop = braked(trajectory, sample, recipe().limits)
    arm = load_robot().arm(plan.arm)
    check_limits(stop, arm.joints, arm.lower, arm.upper, arm.limits)
    assert np.allclose(stop.positions[0], trajectory.positions[sample])
    assert np.allclose(stop.velocities[-1], 0, atol=1e-9)
    assert len(stop.positions) <= len(trajectory.positions) - sample
    assert np.allclose(stop.accelerations[-1], 0, atol=1e-9)
    gaps = np.abs(stop.positions[:, None] - trajectory.positions[None]).max(axis=2).min(axis=1)
    assert gaps.max() < 0.005


def test_a_stop_soon_after_the_start_takes_much_less_than_the_rest(one_block):
    trajectory = _plan(one_block).phases[1].trajectory
    stop = braked(trajectory, len(trajectory.positions) // 5, recipe().limits)
    assert stop.duration < 0.4 * trajectory.duration


def test_an_arm_that_stands_has_stopped(one_block):
    closing = _plan(one_block).phases[3].trajectory
    assert braked(closing, 20, recipe().limits).duration == 0


def test_a_phase_is_left_for_a_reason(one_block):
    plan = plan_pick(one_block, "b")
    with Simulator(one_block) as simulator:
        simulator.run_phase(plan.arm, "b", plan.phases[0])
        until = lambda simulator: "seen" if simulator.time > 0.3 else None  # noqa: E731
        record = simulator.run_phase(plan.arm, "b", plan.phases[1], until=until)
        assert record.left == "seen"
        assert record.duration < plan.phases[1].duration
        simulator.hold(0.2)
        assert simulator.tracking_error(plan.arm) < 0.01
        plan_pick(one_block, "b", start=simulator.state())


def test_many_frames_of_a_noisy_sensor_tell_more_than_one(one_block):
    sensor, rng = Sensor(0.003, 0.01), np.random.default_rng(0)
    truth = one_block.box("b")
    with Simulator(one_block) as simulator:
        single = [sensor.frame(simulator.scene(), rng).box("b").pose.distance(truth.pose) for _ in range(50)]
        assert max(distance for distance, _ in single) <= 0.003
        assert max(angle for _, angle in single) <= 0.0101
        mean = sensor.look(simulator, rng, 20).box("b").pose.distance(truth.pose)
    assert mean[0] < sensor.uncertainty(20) < np.mean([distance for distance, _ in single])
    assert mean[1] < 0.006


def test_an_exact_sensor_shows_the_truth_and_takes_no_time(one_block):
    with Simulator(one_block) as simulator:
        seen = Sensor().look(simulator, np.random.default_rng(0), 8)
        assert simulator.time == 0
        assert np.array_equal(seen.box("b").position, simulator.poses()["b"].position)
    with pytest.raises(InvalidGoal, match=r"noise.*nan"):
        Sensor(float("nan"))
