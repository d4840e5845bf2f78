import numpy as np
import pytest

from motion import reachable
from motion.errors import UnreachableTarget
from motion.ik.postures import solutions
from motion.poses import Pose
from motion.robot.load import load_robot

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])


@pytest.mark.parametrize("arm", ["left", "right"])
def test_solutions_are_different_postures_at_the_same_pose(arm):
    rng = np.random.default_rng(3)
    for _ in range(10):
        target = Pose.of(DOWN, (rng.uniform(0.5, 0.7), {"left": 1, "right": -1}[arm] * rng.uniform(0.1, 0.5), 0.8))
        found = list(solutions(arm, target))
        assert len(found) > 1
        for number, joints in enumerate(found):
            distance, angle = load_robot().tool_pose(arm, joints).distance(target)
            assert distance < 1e-4
            assert angle < 1e-3
            assert all(np.max(np.abs(joints - other)) > 0.2 for other in found[:number])


def test_without_a_solution_the_first_step_says_why():
    with pytest.raises(UnreachableTarget, match="too far"):
        next(solutions("left", Pose.of(DOWN, (2.0, 0.0, 0.8))))
    with pytest.raises(UnreachableTarget) as caught:
        next(solutions("left", Pose.of(DOWN, (0.2, 0.3, 0.75))))
    assert caught.value.reason == "joint limit"


def test_many_targets_at_once():
    targets = [Pose.of(DOWN, (0.6, y, 0.8)) for y in (0.3, 0.1, -0.1)] + [Pose.of(DOWN, (1.4, 0, 0.8))]
    joints = reachable("left", targets)
    assert joints.shape == (4, 7)
    assert np.all(np.isnan(joints[3]))
    for row, target in zip(joints[:3], targets[:3], strict=True):
        assert load_robot().tool_pose("left", row).distance(target)[0] < 1e-4
