import numpy as np
import pytest
from motion_layouts import TABLE

from motion import Avoidance, Box, Scene
from motion.errors import InvalidGoal, UnreachableTarget
from motion.ik.postures import solutions
from motion.ik.solver import solve_ik
from motion.poses import Pose, about
from motion.robot.load import load_robot
from motion.robot.recipe import recipe

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])


@pytest.mark.parametrize("arm", ["left", "right"])
def test_forward_kinematics_of_the_solution_is_the_target(arm):
    rng = np.random.default_rng(1)
    data = load_robot().arm(arm)
    for _ in range(200):  # each can be reached, for that is where it comes from
        target = load_robot().tool_pose(arm, rng.uniform(data.lower, data.upper))
        solution = solve_ik(arm, target)
        distance, angle = load_robot().tool_pose(arm, solution.joints).distance(target)
        assert distance < 1e-4
        assert angle < 1e-3
        assert distance == pytest.approx(solution.position_error, abs=1e-9)
        assert np.all(solution.joints >= data.lower)
        assert np.all(solution.joints <= data.upper)
        assert not solution.joints.flags.writeable


@pytest.mark.parametrize("stretched", np.linspace(0.05, 0.6, 12))
def test_nearly_stretched_arms_are_solved(stretched):
    joints = np.array([0.3, -0.4, 0.2, stretched, -0.5, 0.4, 0.1])
    target = load_robot().tool_pose("left", joints)
    assert solve_ik("left", target).position_error < 1e-4


@pytest.mark.parametrize("seed", range(6))
def test_at_the_edge_of_reach_the_tolerance_decides(seed):
    """Beyond the edge by less than the tolerance the target still counts as reached."""
    joints = np.random.default_rng(seed).uniform(-1, 1, 7)
    joints[[1, 3]] = -0.3, 2 * np.arctan2(0.069, 0.37)  # as far as upper arm and forearm go
    edge = load_robot().tool_pose("left", joints)
    away = edge.position - load_robot().arm("left").wrist * edge.rotation[:, 2] - load_robot().arm("left").shoulder
    for beyond in (2e-5, 4e-5):
        target = Pose(edge.position + beyond * away / np.linalg.norm(away), edge.orientation)
        solution = solve_ik("left", target)
        assert solution.position_error < 1e-4
        assert solution.orientation_error < 1e-3


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


def test_a_solver_that_is_not_there_is_refused_with_those_that_are():
    with pytest.raises(InvalidGoal, match=r"'simplex'.*lm.*daqp"):
        solve_ik("left", Pose.of(DOWN, (0.6, 0.2, 0.8)), solver="simplex")


@pytest.mark.parametrize("solver", ["lm", "daqp"])
def test_the_redundant_joint_goes_to_the_posture(solver):
    target = Pose.of(DOWN, (0.6, 0.2, 0.8))
    free = solve_ik("left", target, solver=solver).joints
    for wished in (recipe().home["left"], recipe().home["left"] + [0, 0, 1.2, 0, -0.8, 0, 0]):
        drawn = solve_ik("left", target, posture=wished, solver=solver)
        assert drawn.position_error < 1e-4
        assert np.linalg.norm(drawn.joints - wished) <= np.linalg.norm(free - wished) + 1e-2
        # Along the one direction that leaves the tool where it is, no step leads nearer to the posture.
        jacobian = load_robot().kinematics("left").jacobian(drawn.joints)
        idle = np.linalg.svd(jacobian)[2][6]
        assert abs(idle @ (wished - drawn.joints)) < 0.05


def test_any_frame_of_the_hand_can_be_the_tool():
    tip = Pose.of(about((1, 0, 0), 0.4), (0.0, 0.02, 0.05))
    target = Pose.of(DOWN, (0.6, 0.25, 0.85))
    joints = solve_ik("left", target, tool=tip).joints
    reached = load_robot().tool_pose("left", joints) @ tip
    assert reached.distance(target)[0] < 1e-4
    assert reached.distance(target)[1] < 1e-3


def test_what_is_in_the_way_is_named():
    lid = Box("lid", (0.6, 0.2, 0.95), size=(0.5, 0.5, 0.02), fixed=True)
    avoid = Avoidance(Scene((TABLE, lid)), "left")
    with pytest.raises(UnreachableTarget, match=r"only in collision.*lid") as caught:
        solve_ik("left", Pose.of(DOWN, (0.6, 0.2, 0.85)), avoid=avoid)
    assert caught.value.reason == "collision"
    assert "lid" in caught.value.bodies


def test_solutions_keep_clear():
    rng = np.random.default_rng(4)
    pillar = Box("pillar", (0.45, 0.45, 0.95), size=(0.08, 0.08, 0.45), fixed=True)
    avoid = Avoidance(Scene((TABLE, pillar)), "left")
    found = 0
    for _ in range(20):
        target = Pose.of(DOWN, (rng.uniform(0.5, 0.7), rng.uniform(0.1, 0.5), rng.uniform(0.75, 0.9)))
        try:
            joints = solve_ik("left", target, avoid=avoid).joints
        except UnreachableTarget:
            continue
        found += 1
        assert avoid.nearest(joints) is None
        assert load_robot().tool_pose("left", joints).distance(target)[0] < 1e-4
    assert found > 10


def test_an_arm_in_collision_slides_out_along_its_redundant_joint():
    block = Box("block", (0.3597, 0.3525, 1.2686), size=(0.2651, 0.2726, 0.1775), fixed=True)
    avoid = Avoidance(Scene((TABLE, block)), "left")
    target = Pose.of(DOWN, (0.496, 0.1354, 0.8344))
    met = [(near.distance, joints) for joints in solutions("left", target) if (near := avoid.nearest(joints))]
    start = max(met, key=lambda found: found[0])[1]  # in the mildest collision
    slid = avoid.slide(start, target, "daqp")
    assert slid.reached
    assert avoid.nearest(slid.joints) is None
    assert load_robot().tool_pose("left", slid.joints).distance(target)[0] < 1e-4


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


def test_bad_input_is_refused():
    target = Pose.of(DOWN, (0.6, 0.2, 0.8))
    with pytest.raises(InvalidGoal, match="norm 2"):
        solve_ik("left", Pose(np.array([0.6, 0.2, 0.8]), np.array([2.0, 0, 0, 0])))
    with pytest.raises(InvalidGoal, match=r"seed.*seven finite"):
        solve_ik("left", target, seed=[0, 0, np.nan, 0, 0, 0, 0])
    with pytest.raises(InvalidGoal, match=r"posture.*seven finite"):
        solve_ik("left", target, posture=[0.0] * 6)
    with pytest.raises(InvalidGoal, match="at least one start"):
        solve_ik("left", target, restarts=0)
    with pytest.raises(InvalidGoal, match="frame in the hand"):
        solve_ik("left", target, tool=Pose(np.array([np.inf, 0, 0]), np.array([1.0, 0, 0, 0])))
    with pytest.raises(InvalidGoal, match="'third'"):
        solve_ik("third", target)


@pytest.mark.parametrize("arm", ["left", "right"])
def test_the_joint_that_is_blamed_is_what_keeps_the_arm_away(arm):
    robot, rng, errors = load_robot(), np.random.default_rng(6), []
    data = robot.arm(arm)
    beyond = np.zeros(7)
    beyond[5] = 0.5  # the wrist bent further than it can be
    for _ in range(40):
        joints = rng.uniform(data.lower, data.upper)
        joints[5] = data.upper[5]
        try:
            solve_ik(arm, robot.tool_pose(arm, joints + beyond))
        except UnreachableTarget as error:
            errors.append(error)
    assert errors
    for error in errors:
        assert error.reason == "joint limit"
        assert error.joints
        assert set(error.joints) <= set(data.joints)
        assert all(name in str(error) for name in error.joints)


def test_the_same_generator_gives_the_same_solution():
    target = Pose.of(DOWN, (0.7, 0.5, 0.74))
    first, second = (solve_ik("left", target, rng=np.random.default_rng(7)).joints for _ in range(2))
    assert first.tobytes() == second.tobytes()
