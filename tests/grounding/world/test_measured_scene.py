"""A scene, measured: directions of every viewpoint, gaps between boxes, what is stacked."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import models
from grounding import World, load_world, make_object
from grounding.geometry.layout import Layout
from grounding.world import Viewpoint
from grounding.world.scene import ROBOT, SPEAKER, Scene

BLOCKS = (make_object("a", position=(0.5, 0.1, 0.736)), make_object("b", position=(0.7, -0.1, 0.736)))


def seen_from(yaw):
    return Scene(Layout(World(BLOCKS, Viewpoint(np.array([1.5, 0.0, 0.0]), yaw))))


@given(st.floats(-np.pi, np.pi))
def test_directions_are_a_cross(yaw):
    scene = seen_from(yaw)
    for owner in (ROBOT, SPEAKER):
        left, right, front, back = (scene.direction(name, owner) for name in ("left", "right", "front", "back"))
        np.testing.assert_allclose(left, -right)
        np.testing.assert_allclose(front, -back)
        assert left @ back == pytest.approx(0, abs=1e-12)
        assert np.linalg.norm(left) == pytest.approx(1)
        assert back[0] * left[1] - back[1] * left[0] == pytest.approx(1)  # left is to the left of ahead


def test_from_across_the_table_everything_is_turned():
    scene = seen_from(np.pi)
    for name in ("left", "right", "front", "back"):
        np.testing.assert_allclose(scene.direction(name, SPEAKER), -scene.direction(name, ROBOT), atol=1e-12)


def test_without_a_speaker_the_robot_is_the_only_one():
    scene = Scene(Layout(World(BLOCKS)))
    np.testing.assert_array_equal(scene.direction("left", SPEAKER), scene.direction("left", ROBOT))


@given(st.floats(0.06, 0.4), st.floats(-np.pi, np.pi), st.floats(-np.pi, np.pi))
def test_gaps_are_symmetric_and_never_more_than_between_the_boxes(apart, direction, turn):
    turned = (np.cos(turn / 2), 0.0, 0.0, np.sin(turn / 2))
    other = (0.5 + apart * np.cos(direction), apart * np.sin(direction), 0.736)
    scene = Scene(
        Layout(World((make_object("a", position=(0.5, 0, 0.736)), make_object("b", "block", "red", other, turned))))
    )
    assert scene.gaps[0, 1] == pytest.approx(scene.gaps[1, 0])
    assert 0 <= scene.gaps[0, 1] <= max(apart - 0.05, 0.0) + 1e-9
    assert scene.gaps[0, 0] == 0


def test_what_is_stacked_is_known_from_below_to_above():
    scene = Scene(Layout(load_world(models.SCENES / "tower.json")))
    ids = scene.layout.ids
    assert {tuple(ids[i] for i in tower) for tower in scene.towers} == {("b1", "b2", "b3"), ("b4", "b5")}
    assert {ids[i] for i in np.flatnonzero(scene.stacked)} == {"b1", "b2", "b3", "b4", "b5"}
    assert {ids[i] for i in np.flatnonzero(~scene.clear)} == {"b1", "b2", "b4"}


@given(st.lists(st.tuples(st.floats(-1, 1), st.floats(-1, 1)), min_size=2, max_size=6))
def test_a_picture_of_the_table_keeps_edges_and_order(places):
    table = make_object("table", "table", "white", (1.0, 0, 0.69), size=(1.0, 2.0, 0.04))
    corners = [(1, 1), (-1, -1)]
    blocks = [make_object(f"b{i}", position=(1 + 0.5 * x, y, 0.74)) for i, (x, y) in enumerate([*corners, *places])]
    scene = Scene(Layout(World((table, *blocks))))
    assert scene.on_table
    np.testing.assert_allclose(scene.scaled[:2], corners, atol=1e-9)
    np.testing.assert_allclose(scene.scaled[:, 1], scene.xy[:, 1], atol=1e-9)
    assert (np.diff(scene.scaled[np.argsort(scene.xy[:, 0]), 0]) >= -1e-9).all()
    nearer = Scene(Layout(World((table, *blocks[:2], make_object("m", position=(1.0, 0, 0.74))))))
    assert nearer.scaled[2, 0] > 0  # what lies in the table's middle is beyond the middle of its picture
