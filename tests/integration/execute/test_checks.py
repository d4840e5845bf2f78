import math

import numpy as np
import pytest

from integration.execute import checks
from integration.execute.checks import Check, gathered
from motion import Box, Pose, Scene

TABLE = Box("table", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04), fixed=True)
UPRIGHT = (1.0, 0, 0, 0)


def scene(**places):
    return Scene((TABLE, *(Box(name, place) for name, place in places.items())))


def test_at_goal_up_to_five_millimetres():
    there = scene(a=(0.6, 0.1, 0.736))
    assert checks.at_goal(there, "a", (0.6, 0.1049, 0.736)).passed
    found = checks.at_goal(there, "a", (0.6, 0.1051, 0.736))
    assert not found.passed
    assert found.measured == pytest.approx(0.0051)


def test_held_to_the_end_of_the_time():
    assert checks.held("a", "left", 2.0).passed
    assert not checks.held("a", "left", 1.98).passed
    assert not checks.held("a", "left", 0.0).passed


def test_supported_by_the_table_by_a_block_or_by_nothing():
    stacked = scene(a=(0.6, 0.1, 0.736), b=(0.6, 0.11, 0.786), c=(0.6, 0.3, 0.750))
    assert checks.supported(stacked, "a").passed
    assert checks.supported(stacked, "b").meaning == "b rests on a"
    assert checks.supported(stacked, "b").passed
    hanging = checks.supported(stacked, "c")
    assert not hanging.passed
    assert hanging.measured == pytest.approx(0.014)


def test_off_the_table_is_not_supported():
    fallen = checks.supported(scene(a=(1.4, 0.1, 0.025)), "a")
    assert not fallen.passed
    assert fallen.to_json()["measured"] is None


def test_released_only_when_no_part_of_the_robot_touches_it():
    names = ("table", "a", "b")
    assert checks.released("a", [("a", "table"), ("a", "b"), ("b", "l_gripper_l_finger_tip")], names).passed
    assert not checks.released("a", [("a", "l_gripper_l_finger_tip")], names).passed


def test_a_block_that_was_pushed_is_named():
    before = scene(a=(0.6, 0.1, 0.736), b=(0.6, 0.3, 0.736))
    after = before.moved({"b": Pose((0.6, 0.306, 0.736), UPRIGHT), "a": Pose((0.6, 0.2, 0.9), UPRIGHT)})
    found = checks.others_unmoved(before, after, ["a"])
    assert (found.object, found.passed) == ("b", False)
    assert checks.others_unmoved(before, after, ["a", "b"]).passed


def test_out_of_a_region():
    square = np.array([[0.5, 0.0], [0.7, 0.0], [0.7, 0.2], [0.5, 0.2]])
    places = scene(a=(0.6, 0.1, 0.736), b=(0.6, 0.3, 0.736))
    assert not checks.out_of_region(places, "a", square).passed
    assert checks.out_of_region(places, "b", square).measured == pytest.approx(0.1)


def test_what_is_not_a_number_does_not_pass():
    assert not checks.at_rest("a", math.nan).passed


def test_gathered_keeps_every_failure_and_the_worst_of_what_passed():
    found = [Check("at_goal", name, m <= 5, m, 5, "m", name) for name, m in (("a", 1), ("b", 3), ("c", 9), ("d", 7))]
    assert [(check.object, count) for check, count in gathered(found)] == [("c", 1), ("d", 1), ("b", 2)]


def test_drifts_are_distances_of_loose_objects():
    before = scene(a=(0.6, 0.1, 0.736))
    after = before.moved({"a": Pose((0.6, 0.103, 0.736), UPRIGHT)})
    assert checks.drifts(before, after) == pytest.approx({"a": 0.003})
