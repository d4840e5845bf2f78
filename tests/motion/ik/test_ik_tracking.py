import numpy as np

from motion.ik.solver import solve_ik
from motion.ik.tracking import track
from motion.poses import Pose
from motion.robot.load import load_robot

DOWN = np.array([[-1.0, 0, 0], [0, 1, 0], [0, 0, -1]])


def test_lines_are_followed_without_jumps():
    start = Pose.of(DOWN, (0.6, 0.3, 0.85))
    joints = solve_ik("left", start).joints
    targets = [Pose.of(DOWN, (0.6, 0.3, 0.85 - 0.005 * k)) for k in range(1, 21)]
    path = track("left", targets, joints)
    assert path is not None
    for reached, target in zip(path, targets, strict=True):
        assert load_robot().tool_pose("left", reached).distance(target)[0] < 1e-4
    assert np.max(np.abs(np.diff([joints, *path], axis=0))) < 0.1
