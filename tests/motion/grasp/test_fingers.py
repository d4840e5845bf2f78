import mujoco
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion import Box, Pose, Scene, load_robot
from motion.collision.scene_model import scene_model
from motion.grasp.fingers import finger_boxes, obstacles, overlaps
from motion.poses import matrix
from motion.robot.state import ARMS, RobotState


@pytest.fixture(scope="module")
def two_boxes():
    spec = mujoco.MjSpec()
    for size in ([0.04, 0.01, 0.03], [0.02, 0.03, 0.05]):
        body = spec.worldbody.add_body()
        body.add_freejoint()
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=size)
    model = spec.compile()
    return model, mujoco.MjData(model)


@given(st.integers(0, 2**32 - 1))
def test_boxes_overlap_where_mujoco_finds_them_to(two_boxes, seed):
    model, data = two_boxes
    rng = np.random.default_rng(seed)
    turns = rng.normal(size=(2, 4))
    turns /= np.linalg.norm(turns, axis=1, keepdims=True)
    places = rng.uniform(-0.05, 0.05, (2, 3))
    data.qpos[:] = np.concatenate([places[0], turns[0], places[1], turns[1]])
    mujoco.mj_kinematics(model, data)
    distance = mujoco.mj_geomDistance(model, data, 0, 1, 1.0, None)
    axes = [matrix(turn)[None] for turn in turns]
    depth = overlaps(places[:1], axes[0], model.geom_size[:1], places[1:], axes[1], model.geom_size[1:])[0]
    if abs(distance) > 1e-5:
        assert (depth > 0) == (distance < 0)
    # Of boxes that are apart, the separating axis never tells more than their distance.
    assert distance < 0 or -depth <= distance + 1e-9


@pytest.mark.parametrize("arm", ARMS)
@pytest.mark.parametrize("opening", [0.016, 0.03, 0.0576])
def test_fingers_are_where_the_model_has_them(arm, opening):
    indices = scene_model(Scene(()))
    model = indices.model
    data = mujoco.MjData(model)
    home = RobotState.home()
    indices.write_robot(data, RobotState(home.left, home.right, {**home.widths, arm: opening}, {}))
    mujoco.mj_kinematics(model, data)
    tool = load_robot().tool_pose(arm, home.joints(arm))
    solid = (model.geom_contype != 0) | (model.geom_conaffinity != 0)
    geoms = [g for g in np.flatnonzero(solid & indices.hand_geoms[arm]) if "finger" in indices.bodies[g]]
    fingers = finger_boxes(arm)
    assert len(fingers) == len(geoms)
    for finger in fingers:
        centre = tool.position + tool.rotation @ (finger.centre + finger.side * (opening - 0.016) / 2 * np.eye(3)[1])
        alike = [g for g in geoms if indices.bodies[g] == finger.body]
        assert min(np.linalg.norm(data.geom_xpos[g] - centre) for g in alike) < 1e-6


def test_only_what_is_in_the_fingers_way_is_an_obstacle():
    tool = Pose(np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.0, 1.0, 0.0]))
    beside = Box("beside", (0.6, 0.045, 0.8), size=(0.02, 0.02, 0.02))
    away = Box("away", (0.6, 0.09, 0.8), size=(0.02, 0.02, 0.02))
    between = Box("between", (0.6, 0.0, 0.8), size=(0.02, 0.02, 0.02))
    wide, narrow = obstacles("left", [tool, tool], [0.0576, 0.016], [away, beside])
    assert wide is not None
    assert wide[1] == "beside"
    assert narrow is None
    assert obstacles("left", [tool], [0.0576], [between, away]) == [None]
    assert obstacles("left", [tool], [0.016], [between]) != [None]
    assert obstacles("left", [tool], [0.05], []) == [None]
