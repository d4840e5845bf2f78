import numpy as np
import pytest
from motion_layouts import TABLE

from motion import Avoidance, Box, InvalidGoal, Pose, Scene, load_robot, servo
from motion.robot.recipe import recipe

DOWN = np.array([0.0, 0.0, 1.0, 0.0])
WALL = Box("wall", (0.6, 0.35, 0.85), size=(0.3, 0.04, 0.3), fixed=True)


@pytest.mark.parametrize("walled", [False, True])
def test_targets_are_followed_within_all_limits(walled):
    avoid = Avoidance(Scene((TABLE, WALL)), "left") if walled else None
    target, dt = Pose(np.array([0.6, 0.1, 0.85]), DOWN), 0.02
    data, joints = load_robot().arm("left"), recipe().home["left"]
    for _ in range(250):
        moved = servo("left", joints, target, dt, avoid=avoid)
        assert np.all(np.abs(moved - joints) <= data.limits.velocity * dt + 1e-9)
        assert np.all((moved >= data.lower) & (moved <= data.upper))
        assert avoid is None or avoid.nearest(moved) is None
        joints = moved
    assert load_robot().tool_pose("left", joints).distance(target)[0] < 1e-3


def test_the_posture_draws_the_idle_joint():
    joints = recipe().home["left"]
    here = load_robot().tool_pose("left", joints)
    wished = joints + 0.5 * np.eye(7)[2]
    for _ in range(100):
        joints = servo("left", joints, here, 0.05, posture=wished)
    assert abs(joints[2] - wished[2]) < 0.4
    assert load_robot().tool_pose("left", joints).distance(here)[0] < 5e-3


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"dt": 0.0}, "positive number of seconds"),
        ({"dt": np.nan}, "positive number of seconds"),
        ({"joints": [9.0] * 7}, "not within the ranges"),
        ({"joints": [np.nan] * 7}, "seven finite"),
        ({"posture": [0.0]}, "posture"),
        ({"arm": "middle"}, "'middle'"),
        ({"solver": "simplex"}, "'simplex'"),
        ({"target": Pose(np.array([np.nan, 0, 0]), DOWN)}, "not finite"),
    ],
)
def test_bad_input_is_refused(change, message):
    arguments = {"arm": "left", "joints": recipe().home["left"], "target": Pose(np.array([0.6, 0.1, 0.85]), DOWN)}
    arguments |= {"dt": 0.01} | change
    with pytest.raises(InvalidGoal, match=message):
        servo(**arguments)
