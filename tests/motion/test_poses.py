import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.poses import Pose, about, matrix, quaternion

angles = st.floats(-np.pi, np.pi)
axes = st.sampled_from([(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0.8, 0)])


@given(axes, angles, axes, angles)
def test_matrix_and_quaternion_are_inverse(a, first, b, second):
    rotation = about(a, first) @ about(b, second)
    assert np.allclose(matrix(quaternion(rotation)), rotation, atol=1e-9)


@given(axes, angles)
def test_a_pose_and_its_inverse_cancel(axis, angle):
    pose = Pose.of(about(axis, angle), (1, 2, 3))
    distance, turn = (pose @ pose.inverse()).distance(Pose(np.zeros(3), np.array([1, 0, 0, 0])))
    assert distance < 1e-9
    assert turn < 1e-6


def test_poses_cannot_be_changed():
    pose = Pose(np.zeros(3), np.array([1, 0, 0, 0]))
    with pytest.raises(ValueError, match="read-only"):
        pose.position[0] = 1
