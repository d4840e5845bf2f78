"""Corners, edges and ends that no direction tells apart, parts of stacks, and who is far of several."""

import numpy as np
import pytest
from believing import TABLE, believed, block, first

from grounding import World
from grounding.geometry.layout import Layout
from grounding.lexicon import place
from grounding.world.scene import ROBOT, Scene

WORLD = World((
    TABLE, block("corner", "red", 0.9, 0.8), block("edge", "red", 0.6, -0.82), block("inner", "red", 0.6, 0.05),
    block("t1", "green", 0.55, 0.4), block("t2", "blue", 0.55, 0.4, 1), block("t3", "green", 0.55, 0.4, 2),
    *(block(f"r{i}", "yellow", 0.75, -0.3 - 0.07 * i) for i in range(5)),
))  # fmt: skip
SCENE = Scene(Layout(WORLD))


def best(text, history=()):
    found = first(text, WORLD, history)
    return None if found is None else found[1]


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
    assert set(best(text)) <= names


def test_the_rim_is_the_same_for_a_mirrored_place():
    spot = place.make_spot(SCENE, (), ROBOT, corner=True, rim=True)
    assert spot.outer
    assert SCENE.layout.ids[int(np.argmax(place.truth(SCENE, spot)))] == "corner"
    assert not place.make_spot(SCENE, ("left",), ROBOT, corner=True, rim=True).outer
    assert not place.make_spot(SCENE, (), ROBOT, middle=True, rim=True).outer


def test_what_was_handled_is_nobody_where_nothing_was():
    assert believed("take the block you just moved", WORLD).is_empty
    assert best("take the block you just moved", ("edge",)) == ("edge",)


@pytest.mark.parametrize("text", ["pick up the column on the left", "take the row", "clear the front row"])
def test_nobody_handles_an_arrangement_of_one(text):
    belief = believed(text, WORLD)
    assert all(len(names) > 1 for names, share in belief.options if names and share > 0.05)
