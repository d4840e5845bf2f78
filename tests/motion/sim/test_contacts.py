import mujoco
import pytest
from motion_layouts import TABLE, block

from motion import RobotState, Scene
from motion.collision.scene_model import scene_model
from motion.ik.solver import solve_ik
from motion.poses import Pose
from motion.robot.recipe import recipe
from motion.sim.contacts import between_fingers, touching_pairs, unintended_pairs


@pytest.fixture
def around():
    """A block that both fingers of the right hand touch, well above the table, and another on the table."""
    held = block("held", 0.6, -0.3).at(Pose((0.6, -0.3, 1.0), (1.0, 0.0, 0.0, 0.0)))
    other = block("other", 0.6, 0.3)
    sunk = other.at(Pose(other.position - [0, 0, 0.0002], other.orientation))
    scene = Scene((TABLE, held, sunk))
    joints = solve_ik("right", Pose(held.position, (0.0, 0.0, 1.0, 0.0))).joints
    home = RobotState.home()
    width = float(held.size[1]) - 0.0005
    indices = scene_model(scene)
    data = mujoco.MjData(indices.model)
    indices.write_boxes(data, scene)
    indices.write_robot(data, RobotState(home.left, joints, {"left": recipe().gripper.opened, "right": width}, {}))
    mujoco.mj_forward(indices.model, data)
    return indices, data


def test_a_box_between_the_fingers_is_found(around):
    indices, data = around
    assert between_fingers(indices, data, "right") == ("held",)
    assert between_fingers(indices, data, "left") == ()


def test_pairs_are_named_once_in_order(around):
    pairs = touching_pairs(*around)
    assert ("other", "table") in pairs
    assert sum("held" in pair for pair in pairs) >= 2
    assert list(pairs) == sorted(set(pairs))
    assert all(first <= second for first, second in pairs)


def test_the_target_may_be_touched_by_its_own_hand_only(around):
    indices, data = around
    assert unintended_pairs(indices, data, "right", "held") == set()
    for arm, target in (("right", "other"), ("right", None), ("left", "held")):
        found = unintended_pairs(indices, data, arm, target)
        assert found
        assert all("held" in pair for pair in found)
