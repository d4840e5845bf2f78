"""Corners, edges and ends that no direction tells apart, parts of stacks, and who is far of several."""

import functools

import numpy as np
import pytest

from grounding import World, make_object
from grounding.geometry.layout import Layout
from grounding.graded.belief import believe
from grounding.graded.places import in_place, make_place, off_middle
from grounding.language.parser import Parser
from grounding.world.scene import ROBOT, Scene

TABLE = make_object("table", "table", "white", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04))


def block(name, color, x, y, level=0):
    return make_object(name, "block", color, (x, y, 0.736 + 0.05 * level))


SCENE = Scene(Layout(World((
    TABLE, block("corner", "red", 0.9, 0.8), block("edge", "red", 0.6, -0.82), block("inner", "red", 0.6, 0.05),
    block("t1", "green", 0.55, 0.4), block("t2", "blue", 0.55, 0.4, 1), block("t3", "green", 0.55, 0.4, 2),
    *(block(f"r{i}", "yellow", 0.75, -0.3 - 0.07 * i) for i in range(5)),
))))  # fmt: skip


@functools.cache
def parser():
    return Parser.load()


def first(text, history=()):
    belief = believe(parser().parse(text, 4), SCENE, history)
    return belief.options[0][0][1] if belief.options else None


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("pick up the red block in the corner", {"corner"}), ("pick up the red block at the edge", {"edge", "corner"}),
        ("take the block at the end of the row", {"r0", "r4"}), ("take the third block from the left end of the row",
                                                                 {"r2"}),
        ("take the second block from the top of the tower", {"t2"}),
        ("take the second block from the bottom of the stack", {"t2"}),
        ("take the red block that is in the farthest left position", {"corner"}),
        ("take the red block that is the farthest back and the left", {"corner"}), ("take the most centric red block",
                                                                                    {"inner"}),
        ("of the two farthest red blocks take the near one", {"edge", "inner"}),
    ],
)  # fmt: skip
def test_places_without_a_side(text, names):
    assert set(first(text)) <= names


def test_the_rim_is_the_same_for_a_mirrored_place():
    place = make_place(SCENE, (), ROBOT, corner=True, rim=True)
    assert place.outer
    found = in_place(SCENE, place, np.ones(SCENE.n))
    assert SCENE.layout.ids[int(np.argmax(found))] == "corner"
    assert not make_place(SCENE, ("left",), ROBOT, corner=True, rim=True).outer
    assert not make_place(SCENE, (), ROBOT, middle=True, rim=True).outer


def test_what_was_handled_is_nobody_where_nothing_was():
    assert first("take the block you just moved") is None
    assert first("take the block you just moved", ("edge",)) == ("edge",)


@pytest.mark.parametrize(("name", "opposite"), [("left", "right"), ("back", "front")])
def test_beside_the_middle_is_on_one_side_of_it(name, opposite):
    toward, away = (off_middle(SCENE, (side,), ROBOT, strict=False) for side in (name, opposite))
    along = SCENE.seen @ SCENE.direction(name)
    assert (along[toward > 0.2] > 0).all()
    assert (along[away > 0.2] < 0).all()
    assert np.minimum(toward, away).max() < 0.1


@pytest.mark.parametrize("text", ["pick up the column on the left", "take the row", "clear the front row"])
def test_nobody_handles_an_arrangement_of_one(text):
    belief = believe(parser().parse(text, 4), SCENE)
    assert all(len(names) > 1 for (_, names), share in belief.options if share > 0.01)
