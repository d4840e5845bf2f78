import numpy as np
import pytest
from motion_layouts import TABLE, block

from motion import InvalidGoal, Scene, Simulator, UnreachableTarget, plan_transport

SCENE = Scene((TABLE, block("a", 0.62, -0.62), block("c", 0.6, 0.45), block("m", 0.58, 0.0)))


def test_one_hand_does_it_alone_where_it_can():
    plans = plan_transport(SCENE, "a", SCENE.resting_position("a", (0.6, -0.3)))
    assert [plan.arm for plan in plans] == ["right"]


def test_two_hands_do_it_over_the_middle():
    goal = SCENE.resting_position("a", (0.65, 0.65))
    plans = plan_transport(SCENE, "a", goal)
    assert [plan.arm for plan in plans] == ["right", "left"]
    with Simulator(SCENE) as simulator:
        for plan in plans:
            assert simulator.execute(plan).contacts == ()
        simulator.hold(0.3)
        assert simulator.poses()["a"].distance(plans[-1].goal)[0] < 0.003
        assert np.linalg.norm(simulator.poses()["m"].position - SCENE.box("m").position) < 0.001


def test_a_chosen_arm_does_not_hand_over():
    with pytest.raises(UnreachableTarget):
        plan_transport(SCENE, "a", SCENE.resting_position("a", (0.65, 0.65)), arm="right")


def test_mistakes_are_told_as_for_a_place():
    with pytest.raises(InvalidGoal, match="occupied"):
        plan_transport(SCENE, "a", SCENE.box("c").position)
