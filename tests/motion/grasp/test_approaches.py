import numpy as np
import pinocchio
import pytest
from motion_layouts import TABLE, block

from motion import Box, RobotState, Scene, UnreachableTarget, grasp_candidates, load_robot
from motion.grasp.approaches import APPROACH, Approaches

ARM = "right"
ELBOW = 4  # Pinocchio's index of the joint


def _grasp(scene, name="b"):
    return next(grasp for grasp in grasp_candidates(scene, name, (ARM,)) if grasp.tilt == 0)


def _takings(scene, grasp, starts=12):
    state = RobotState.home()
    approaches = Approaches(scene, state, ARM, np.random.default_rng(0), starts=starts)
    return list(approaches.takings(grasp, 0.1, state.joints(ARM)))


def _elbow(joints):
    kinematics = load_robot().kinematics(ARM)
    pinocchio.forwardKinematics(kinematics.model, kinematics.data, joints)
    return np.array(kinematics.data.oMi[ELBOW].translation)


def test_all_postures_have_the_hand_at_the_grasp_and_differ(one_block):
    grasp = _grasp(one_block)
    takings = _takings(one_block, grasp)
    assert len(takings) > 1
    for number, taking in enumerate(takings):
        there = load_robot().tool_pose(ARM, taking.back[0])
        assert there.distance(grasp.tool)[0] < 1e-4
        before = load_robot().tool_pose(ARM, taking.back[-1])
        assert before.distance(grasp.backed(APPROACH))[0] < 2e-4
        assert np.array_equal(taking.back[0], taking.up[0])
        for other in takings[:number]:
            assert np.max(np.abs(taking.back[0] - other.back[0])) > 0.2


def test_what_is_in_the_elbow_s_way_is_passed_by_another_posture(one_block):
    grasp = _grasp(one_block)
    first = _takings(one_block, grasp)[0]
    post = Box("post", _elbow(first.back[0]), size=(0.03, 0.03, 0.03), fixed=True)
    blocked = Scene((*one_block.boxes, post))
    others = _takings(blocked, grasp)
    assert others
    assert all(np.linalg.norm(_elbow(taking.back[0]) - post.position) > 0.05 for taking in others)


def test_an_obstructed_hand_is_told_at_once():
    free = Scene((TABLE, block("b", 0.6, -0.3)))
    lid = Box("lid", (0.6, -0.3, 0.83), size=(0.2, 0.2, 0.02), fixed=True)
    with pytest.raises(UnreachableTarget, match="lid") as caught:
        _takings(Scene((*free.boxes, lid)), _grasp(free))
    assert caught.value.reason == "collision"
    assert "lid" in caught.value.bodies
    assert "1 postures" in str(caught.value)
