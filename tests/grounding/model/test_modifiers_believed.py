"""Modifiers whose parts belong together though the words are apart, in scenes whose answer is plain."""

import numpy as np
import pytest
from believing import believed, block, first

from grounding import World, make_object
from grounding.world import Viewpoint
from grounding.world.scene import ROBOT, SPEAKER

WORLD = World(
    (make_object("table", "table", "white", (0.75, 0, 0.691), size=(0.9, 1.6, 0.04)),
     *(block(name, color, 0.5 + 0.07 * x, 0.07 * y) for name, color, x, y in (
        ("g1", "green", 0, -4), ("g2", "green", 1, -4), ("g3", "green", 0, -5), ("g4", "green", 5, 5),
        ("o1", "orange", 0, 4), ("o2", "orange", 3, 4), ("o3", "orange", 5, 0), ("u1", "blue", 3, 5),
        ("y1", "yellow", 5, -1)))),
    Viewpoint(np.array([1.7, 0.0, 0.0]), np.pi),
)  # fmt: skip


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("get the green cube that is not with the other green cubes", "g4"),
        ("lift the green cube that stands apart from the three other green cubes", "g4"),
        ("grab the orange block that is on the left side but is the closer one to you", "o1"),
        ("take the orange block that is the farthest from you and next to a blue block", "o2"),
        ("take the orange block that has a yellow block to its right", "o3"),
        ("on the left are two orange blocks. take the one that is closer to you", "o1"),
        ("there are two orange blocks on the left - take the one that is closer to you", "o1"),
        ("there is a group of three green cubes on your right, get the green cube that is not in that group",
         "g4"),
        ("pick up the green block that is farthest from you of the four", "g4"),
        ("take the green block away from the group of three green blocks", "g4"),
    ],
)  # fmt: skip
def test_what_is_said_apart_is_heard_together(text, name):
    best, *others = believed(text, WORLD).listed()
    assert (best.kinds[0][0], best.objects) == ("pick", (name,))
    assert all(best.probability > 1.5 * other.probability for other in others)


def share_of_the_robot(text):
    belief = believed(text, WORLD)
    shares = {ROBOT: 0.0, SPEAKER: 0.0}
    for reading, share in zip(belief.readings, belief.shares, strict=True):
        shares[reading.evaluator.view] += share
    assert min(shares.values()) > 0
    return shares[ROBOT]


def test_who_is_named_decides_whose_left_is_likelier():
    bare = share_of_the_robot("take the green block on the left")
    assert share_of_the_robot("i want the green block on the left") < bare


# A column of four before the robot: red, blue, yellow, blue; another yellow one beside it.

COLUMN = World(tuple(
    block(name, color, 0.5 + 0.07 * x, 0.07 * y)
    for name, color, x, y in (
        ("r", "red", 0, 0), ("u1", "blue", 1, 0), ("y1", "yellow", 2, 0), ("u2", "blue", 4, 0), ("y2", "yellow", 3, 2),
    )
))  # fmt: skip


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("take the block two blocks behind the red block", "y1"), ("take the second block behind the red one", "y1"),
        ("take the third block behind the red block", "u2"), ("take the second blue block behind the red one", "u2"),
        ("take the block that is three blocks behind the red block", "u2"),
    ],
)  # fmt: skip
def test_blocks_are_counted_along_a_direction(text, name):
    assert first(text, COLUMN) == ("pick", (name,))


def test_what_is_outside_of_a_ring_is_neither_part_of_it_nor_within():
    ring = [(0.65 + 0.2 * np.cos(a), 0.2 * np.sin(a)) for a in 2 * np.pi * np.arange(9) / 9]
    places = {**{f"r{i}": place for i, place in enumerate(ring)}, "within": (0.65, 0.0), "out": (0.65, 0.55)}
    world = World((WORLD["table"], *(block(name, "red", *place) for name, place in places.items())))
    for text in ("get the cube outside the ring", "get the cube that is outside of the ring"):
        assert first(text, world) == ("pick", ("out",))
