import mujoco
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion import load_robot
from motion.poses import matrix

ARM = st.sampled_from(["left", "right"])
SEEDS = st.integers(0, 2**32 - 1)


def drawn(arm, seed, count=None):
    data = load_robot().arm(arm)
    return np.random.default_rng(seed).uniform(data.lower, data.upper, 7 if count is None else (count, 7))


@given(ARM, SEEDS)
def test_many_at_once_are_as_one_by_one(arm, seed):
    kinematics, joints = load_robot().kinematics(arm), drawn(arm, seed, 5)
    positions, rotations = kinematics.poses(joints)
    for row, position, rotation in zip(joints, positions, rotations, strict=True):
        pose = kinematics.pose(row)
        assert position == pytest.approx(pose.position, abs=1e-12)
        assert rotation == pytest.approx(pose.rotation, abs=1e-12)


@given(ARM, SEEDS)
def test_the_tool_is_where_mujoco_has_it(arm, seed):
    data, joints = load_robot().arm(arm), drawn(arm, seed)
    state = mujoco.MjData(data.model)
    state.qpos[:] = joints
    mujoco.mj_kinematics(data.model, state)
    pose = load_robot().tool_pose(arm, joints)
    assert state.site_xpos[data.site] == pytest.approx(pose.position, abs=1e-9)
    assert state.site_xmat[data.site].reshape(3, 3) == pytest.approx(pose.rotation, abs=1e-9)


@given(ARM, SEEDS)
def test_the_jacobian_is_the_derivative(arm, seed):
    kinematics, joints, step = load_robot().kinematics(arm), drawn(arm, seed), 1e-6
    jacobian = kinematics.jacobian(joints)
    for index in range(7):
        ahead, behind = (kinematics.pose(joints + sign * step * np.eye(7)[index]) for sign in (1, -1))
        assert (ahead.position - behind.position) / (2 * step) == pytest.approx(jacobian[:3, index], abs=1e-6)
        turn = ahead.rotation @ behind.rotation.T / (2 * step)
        spin = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
        assert spin == pytest.approx(jacobian[3:, index], abs=1e-6)


def test_turning_the_last_joint_turns_the_tool_about_its_own_axis():
    kinematics, joints = load_robot().kinematics("left"), drawn("left", 3)
    before, after = kinematics.pose(joints), kinematics.pose(joints + 0.3 * np.eye(7)[6])
    assert after.position == pytest.approx(before.position)
    relative = matrix(before.orientation).T @ matrix(after.orientation)
    assert relative[0, 0] == pytest.approx(np.cos(0.3))
    assert relative[2, 2] == pytest.approx(1)


@given(ARM, SEEDS)
def test_manipulability_is_the_volume_of_the_velocity_ellipsoid(arm, seed):
    kinematics, joints = load_robot().kinematics(arm), drawn(arm, seed)
    stretches = np.linalg.svd(kinematics.jacobian(joints), compute_uv=False)
    assert kinematics.manipulability(joints) == pytest.approx(np.prod(stretches), abs=1e-9)
