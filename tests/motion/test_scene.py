import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import Box, InvalidGoal, InvalidScene, Pose, Scene, UnknownBody
from motion.collision.scene_model import scene_model
from motion.polygons import contains, hull, overlap


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"position": (0, np.nan, 0)}, "position of box 'b'.*finite"),
        ({"position": (0, 0)}, "position of box 'b'"),
        ({"position": "here"}, "position of box 'b'"),
        ({"size": (0.05, 0, 0.05)}, "size of box 'b'.*positive"),
        ({"orientation": (1, 1, 0, 0)}, "orientation of box 'b'.*unit"),
        ({"mass": 0.0}, "mass of box 'b'.*positive"),
        ({"mass": float("inf")}, "mass of box 'b'"),
        ({"name": ""}, "name"),
    ],
)
def test_boxes_that_cannot_be_are_refused(change, words):
    with pytest.raises(InvalidScene, match=words):
        Box(**{"name": "b", "position": (0.6, 0, 0.8), **change})


def test_names_differ():
    with pytest.raises(InvalidScene, match=r"'b'.*two"):
        Scene((block("b", 0.5, 0), block("b", 0.6, 0)))


def test_unknown_names_are_told_with_the_known_ones(one_block):
    with pytest.raises(UnknownBody, match=r"'c'.*table, b"):
        one_block.box("c")


def test_boxes_above_are_those_that_rest_on_it(tower):
    assert [box.name for box in tower.boxes_above("t0")] == ["t1"]
    assert [box.name for box in tower.boxes_above("t2")] == []
    assert {box.name for box in tower.boxes_above("table")} == {"t0", "a", "b"}


def test_resting_positions_are_on_what_is_highest(tower):
    assert tower.resting_position("a", (0.58, 0.25))[2] == pytest.approx(TOP + 3.5 * 0.05)
    assert tower.resting_position("a", (0.6, -0.5))[2] == pytest.approx(TOP + 0.025)
    assert tower.resting_position("t2", (0.58, 0.25))[2] == pytest.approx(TOP + 2.5 * 0.05)
    with pytest.raises(InvalidGoal, match="nothing stands at"):
        tower.resting_position("a", (2.0, 0.0))


def test_scenes_that_differ_by_poses_share_a_model(tower):
    moved = tower.moved({"a": Pose((0.5, 0.6, 0.736), (1, 0, 0, 0))})
    assert scene_model(moved) is scene_model(tower)
    assert scene_model(Scene((TABLE, block("a", 0.5, 0)))) is not scene_model(tower)


def test_fixed_boxes_do_not_move(tower):
    moved = tower.moved({"table": Pose((0, 0, 0), (1, 0, 0, 0))})
    assert np.array_equal(moved.box("table").position, TABLE.position)


def test_footprints_turn_with_the_box():
    assert overlap(block("a", 0, 0).footprint, block("b", 0.051, 0).footprint) == pytest.approx(-0.001)
    assert overlap(block("a", 0, 0, yaw=np.pi / 4).footprint, block("b", 0.051, 0).footprint) > 0


def test_hulls_contain_their_points():
    rng = np.random.default_rng(0)
    points = rng.normal(size=(40, 2))
    outline = hull(points)
    centre = outline.mean(axis=0)
    assert all(contains(outline, centre + 0.999 * (point - centre)) for point in points)
    assert not contains(outline, points.max(axis=0) + 0.1)
    assert not contains(outline, outline[0], margin=0.01)


@pytest.mark.parametrize("name", ["floor", "torso", "left_gripper"])
def test_names_of_the_robot_are_refused(name):
    with pytest.raises(InvalidScene, match=name):
        scene_model(Scene((TABLE, block(name, 0.6, -0.3))))
