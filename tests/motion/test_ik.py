import numpy as np
import pytest

from motion.errors import InvalidGoal, UnreachableTarget
from motion.ik import solve_ik, track
from motion.poses import Pose, about
from motion.robot import load_robot

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])


@pytest.mark.parametrize("arm", ["left", "right"])
def test_forward_kinematics_of_the_solution_is_the_target(arm):
    rng = np.random.default_rng(1)
    data, found = load_robot().arm(arm), 0
    for _ in range(40):
        target = load_robot().tool_pose(arm, rng.uniform(data.lower, data.upper))
        try:
            solution = solve_ik(arm, target, rng=rng)
        except UnreachableTarget:
            continue
        found += 1
        distance, angle = load_robot().tool_pose(arm, solution.joints).distance(target)
        assert distance < 1e-4
        assert angle < 1e-3
        assert np.all(solution.joints >= data.lower)
        assert np.all(solution.joints <= data.upper)
    assert found >= 39


def test_all_of_the_table_within_reach_is_reached_from_above():
    rng = np.random.default_rng(2)
    for _ in range(40):
        y = rng.uniform(-0.6, 0.6)
        turn = about((0, 0, 1), rng.uniform(-np.pi, np.pi))
        target = Pose.of(turn @ DOWN, (rng.uniform(0.45, 0.72), y, 0.74))
        solve_ik("left" if y > 0 else "right", target, rng=rng)


@pytest.mark.filterwarnings("ignore::PendingDeprecationWarning")
@pytest.mark.filterwarnings("ignore::qpsolvers.warnings.SparseConversionWarning")
@pytest.mark.parametrize("solver", ["daqp", "osqp", "proxqp"])
def test_solvers_can_be_chosen(solver):
    import qpsolvers

    if solver not in qpsolvers.available_solvers:
        pytest.skip(f"{solver} is not installed")
    target = Pose.of(DOWN, (0.6, 0.2, 0.8))
    assert solve_ik("left", target, solver=solver).position_error < 1e-4


def test_what_is_too_far_says_so():
    with pytest.raises(UnreachableTarget, match="too far") as caught:
        solve_ik("left", Pose.of(DOWN, (1.3, 0, 0.74)))
    assert caught.value.reason == "too far"


def test_a_joint_at_its_end_is_named():
    with pytest.raises(UnreachableTarget, match="left_e1") as caught:
        solve_ik("left", Pose.of(DOWN, (0.2, 0.3, 0.75)))
    assert caught.value.reason == "joint limit"
    assert "left_e1" in caught.value.joints


def test_refused_solutions_are_reported_as_collisions():
    with pytest.raises(UnreachableTarget) as caught:
        solve_ik("left", Pose.of(DOWN, (0.6, 0.2, 0.8)), accept=lambda joints: False, restarts=3)
    assert caught.value.reason == "collision"


def test_targets_are_finite():
    with pytest.raises(InvalidGoal, match="finite"):
        solve_ik("left", Pose(np.array([np.nan, 0, 0]), np.array([1, 0, 0, 0])))


def test_the_same_generator_gives_the_same_solution():
    target = Pose.of(DOWN, (0.7, 0.5, 0.74))
    first, second = (solve_ik("left", target, rng=np.random.default_rng(7)).joints for _ in range(2))
    assert first.tobytes() == second.tobytes()


def test_lines_are_followed_without_jumps():
    start = Pose.of(DOWN, (0.6, 0.3, 0.85))
    joints = solve_ik("left", start).joints
    targets = [Pose.of(DOWN, (0.6, 0.3, 0.85 - 0.005 * k)) for k in range(1, 21)]
    path = track("left", targets, joints)
    assert path is not None
    for reached, target in zip(path, targets, strict=True):
        assert load_robot().tool_pose("left", reached).distance(target)[0] < 1e-4
    assert np.max(np.abs(np.diff([joints, *path], axis=0))) < 0.1
