import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import InvalidGoal, Phase, RobotState, Scene, Simulator, plan_place
from motion.path.resampling import resampled_in_time
from motion.path.trajectory import check_limits
from motion.plan.plans import Plan
from motion.robot.load import load_robot

SCENE = Scene((TABLE, block("b", 0.6, -0.3)))
GOAL = (0.55, -0.5, TOP + 0.025)


@pytest.fixture(scope="module")
def plan():
    return plan_place(SCENE, "b", GOAL)


@pytest.mark.parametrize("rate", [20, 100, 333.0, 1000])
def test_a_plan_becomes_one_trajectory_with_the_gripper_apart(plan, rate):
    whole = plan.to_joint_trajectory(rate)
    assert whole.joint_names == load_robot().arm(plan.arm).joints
    assert whole.time_from_start[0] == 0.0
    assert whole.duration == pytest.approx(plan.duration, abs=1e-9)
    steps = np.diff(whole.time_from_start)
    assert 0 < steps.min()
    assert steps.max() <= 1 / rate + 1e-9
    assert whole.positions[0] == pytest.approx(plan.phases[0].trajectory.positions[0])
    assert whole.positions[-1] == pytest.approx(plan.end.joints(plan.arm))
    widths = [phase.gripper for phase in plan.phases]
    assert [command.width for command in whole.gripper][-2:] == [widths[3], widths[7]]
    closing = next(command for command in whole.gripper if command.width == widths[3])
    still = (whole.time_from_start > closing.time_from_start) & (
        whole.time_from_start < closing.time_from_start + closing.duration
    )
    assert still.any()
    assert not whole.velocities[still].any()


def test_points_are_those_of_the_plan(plan):
    whole = plan.to_joint_trajectory(1 / plan.phases[0].trajectory.period)
    begun = 0.0
    for phase in plan.phases:
        times = begun + phase.trajectory.period * np.arange(len(phase.trajectory.positions))
        places = np.searchsorted(whole.time_from_start, times - 1e-6)
        assert whole.positions[places] == pytest.approx(phase.trajectory.positions, abs=1e-9)
        begun += phase.duration


def test_its_values_are_plain_under_the_names_of_the_message(plan):
    told = plan.to_joint_trajectory(50).to_json()
    assert set(told) == {"joint_names", "points", "gripper"}
    assert set(told["points"][0]) == {"time_from_start", "positions", "velocities", "accelerations"}
    assert len(told["points"][0]["positions"]) == len(told["joint_names"]) == 7


@pytest.mark.parametrize("rate", [0, -1.0, float("nan"), float("inf"), "fast"])
def test_a_rate_is_a_number_above_zero(plan, rate):
    with pytest.raises(InvalidGoal, match="rate"):
        plan.to_joint_trajectory(rate)


@pytest.mark.parametrize("period", [0.001, 0.005, 0.01, 0.0033])
def test_another_period_is_the_same_movement(plan, period):
    arm = load_robot().arm(plan.arm)
    for phase in plan.phases:
        other = resampled_in_time(phase.trajectory, period)
        assert other.period == period
        assert abs(other.duration - phase.duration) < period + 1e-9
        assert other.positions[0] == pytest.approx(phase.trajectory.positions[0])
        assert other.positions[-1] == pytest.approx(phase.trajectory.positions[-1])
        check_limits(other, arm.joints, arm.lower - 1e-3, arm.upper + 1e-3, _wider(arm.limits))
        again = resampled_in_time(other, phase.trajectory.period)
        most = min(len(again.positions), len(phase.trajectory.positions))
        assert again.positions[:most] == pytest.approx(phase.trajectory.positions[:most], abs=2e-3)


def _wider(limits):
    """Limits for differences over steps that do not fall together with those of the plan."""
    return type(limits)(1.02 * limits.velocity, 1.05 * limits.acceleration, 2 * limits.jerk, limits.position_margin)


@pytest.mark.parametrize("period", [0.01, 0.001])
def test_the_simulator_takes_the_time_of_a_plan_whatever_its_period(plan, period):
    phases = tuple(
        Phase(phase.name, resampled_in_time(phase.trajectory, period), phase.gripper, phase.held)
        for phase in plan.phases
    )
    other = Plan(plan.kind, plan.arm, plan.target, phases, plan.grasp, plan.goal, plan.start, plan.end, plan.clearance)
    with Simulator(SCENE, RobotState.home()) as simulator:
        simulator.settle()
        before = simulator.time
        execution = simulator.execute(other)
        assert simulator.time - before == pytest.approx(plan.duration, abs=len(phases) * 0.012)
        assert execution.duration == pytest.approx(plan.duration, abs=len(phases) * 0.012)
        assert execution.tracking_error < 0.02
        assert np.linalg.norm(simulator.pose("b").position - GOAL) < 0.003
