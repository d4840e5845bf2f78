import mujoco
import numpy as np
import pinocchio
import pytest

from motion import Scene
from motion.collision.scene_model import scene_model
from motion.errors import InvalidGoal
from motion.robot.load import load_robot
from motion.robot.recipe import recipe
from motion.robot.state import ARMS, RobotState


def test_both_forward_kinematics_agree_on_every_body():
    robot = load_robot().pinocchio
    model = scene_model(Scene(())).model
    data, other = mujoco.MjData(model), robot.createData()
    bodies = [f for f in robot.frames if f.type == pinocchio.FrameType.BODY and f.name != "universe"]
    assert len(bodies) > 50
    rng = np.random.default_rng(0)
    for _ in range(25):
        q = rng.uniform(robot.lowerPositionLimit, robot.upperPositionLimit)
        for name in robot.names[1:]:
            data.qpos[model.joint(name).qposadr[0]] = q[robot.idx_qs[robot.getJointId(name)]]
        mujoco.mj_kinematics(model, data)
        pinocchio.framesForwardKinematics(robot, other, q)
        for frame in bodies:
            placement = other.oMf[robot.getFrameId(frame.name)]
            body = model.body(frame.name).id
            assert np.abs(data.xpos[body] - placement.translation).max() < 1e-9
            assert np.abs(data.xmat[body].reshape(3, 3) - placement.rotation).max() < 1e-9


def test_the_robot_stands_on_the_floor():
    model = scene_model(Scene(())).model
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    assert data.body("base").xpos == pytest.approx([0, 0, 0.9242])
    geom = next(g for g in range(model.ngeom) if model.body(int(model.geom_bodyid[g])).name == "pedestal")
    mesh = model.geom_dataid[geom]
    first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
    corners = model.mesh_vert[first : first + count] @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]
    assert corners[:, 2].min() == pytest.approx(0, abs=1e-3)


def test_both_hands_have_paddles_that_open_alike():
    model = scene_model(Scene(())).model
    for side in ("l", "r"):
        left = [model.geom(int(g)).size for g in np.flatnonzero(_of(model, f"l_gripper_{side}_finger_tip"))]
        right = [model.geom(int(g)).size for g in np.flatnonzero(_of(model, f"r_gripper_{side}_finger_tip"))]
        assert len(left) == 1
        assert np.array_equal(left, right)
        assert sorted(2 * left[0]) == pytest.approx([0.0065, 0.037, 0.042])


def test_mirrored_joints_give_mirrored_tools():
    robot, rng = load_robot(), np.random.default_rng(3)
    mirror = np.array([-1, 1, -1, 1, -1, 1, -1])
    for _ in range(10):
        joints = rng.uniform(robot.arms["left"].lower, robot.arms["left"].upper)
        left, right = robot.tool_pose("left", joints), robot.tool_pose("right", joints * mirror)
        assert right.position == pytest.approx(left.position * [1, -1, 1], abs=1e-5)


def test_home_is_symmetric_within_limits_and_points_down():
    robot = load_robot()
    for arm in ARMS:
        data = robot.arm(arm)
        joints = recipe().home[arm]
        assert np.all(joints > data.lower)
        assert np.all(joints < data.upper)
        assert robot.tool_pose(arm, joints).rotation[2, 2] < -0.999
    assert robot.tool_pose("left", RobotState.home().left).position[1] > 0


def test_wrists_never_reach_beyond_the_stated_reach():
    robot, rng = load_robot(), np.random.default_rng(5)
    for name in ARMS:
        arm = robot.arm(name)
        for _ in range(200):
            tool = robot.tool_pose(name, rng.uniform(arm.lower, arm.upper))
            wrist = tool.position - arm.wrist * tool.rotation[:, 2]
            assert np.linalg.norm(wrist - arm.shoulder) <= arm.reach + 1e-9


def test_arms_have_two_names():
    with pytest.raises(InvalidGoal, match=r"'middle'.*'left' and 'right'"):
        load_robot().arm("middle")


def _of(model, body):
    return model.geom_bodyid == model.body(body).id
