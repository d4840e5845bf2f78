"""Destinations: how high a tower becomes, the middle of a ring, the bare table, and its end."""

import functools

import numpy as np
import pytest

import models
from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.model.belief import believe, read
from grounding.model.cases import Weights
from grounding.model.evaluator import EVEN
from grounding.placing import destination, leads_off_table
from grounding.world import World, load_world, make_object
from grounding.world.scene import Scene

TABLE = load_world(models.SCENES / "four.json")["table"]
WEIGHTS = Weights({**EVEN, "parse": 0.5})
"""Equal weights, and the likelier of two parses is the likelier one."""
HEIGHT = 0.736  # of the centre of a block on the table
EDGE = 0.05


def laid(**blocks):
    """A world of blocks given as colour, x, y and, for those in a tower, how many lie below."""
    return World((TABLE, *(make_object(name, color=color, position=(x, y, HEIGHT + EDGE * sum(level)))
                           for name, (color, x, y, *level) in blocks.items())))  # fmt: skip


TOWERS = laid(red=("red", 0.55, 0.5), low=("blue", 0.6, 0.2), base=("yellow", 0.6, -0.1), top=("yellow", 0.6, -0.1, 1),
              first=("green", 0.6, -0.4), second=("green", 0.6, -0.4, 1), third=("green", 0.6, -0.4, 2))  # fmt: skip
RING = laid(red=("red", 0.6, -0.4), **{
    f"b{i}": ("green", 0.65 + 0.13 * np.cos(i * np.pi / 3), 0.2 + 0.13 * np.sin(i * np.pi / 3)) for i in range(6)
})  # fmt: skip


@functools.cache
def parsed(text):
    return tuple(Parser.load().parse(text, 4))


def believed(text, world):
    return believe(read(parsed(text), Scene(Layout(world)), (), WEIGHTS), WEIGHTS)


def told(text, world, moved="red"):
    return destination(believed(text, world), (moved,))


@pytest.mark.parametrize(
    ("text", "support"),
    [
        ("move the red block to the right to form a tower of two blocks", "low"),
        ("the red block moves to the right and becomes the third story of a tower", "top"),
        ("slide the red block to the right to make a four story tower", "third"),
        ("the red block moves to the right, making a stack that is now four blocks high", "third"),
    ],
)
def test_a_tower_that_comes_about_is_as_high_as_is_said(text, support):
    found = told(text, TOWERS)
    assert found.reference == (support,)


@pytest.mark.parametrize("number", ["two", "three"])
def test_a_building_of_so_many_stories_is_a_thing_to_go_on(number):
    found = told(f"put the red block on the {number} story building", TOWERS)
    assert found.reference == ({"two": "top", "three": "third"}[number],)


@pytest.mark.parametrize(
    "where",
    ["in the ring", "inside the circle", "into the circle of green blocks", "at the circle's center",
     "in the middle of the ring"],
)  # fmt: skip
def test_in_a_ring_is_in_its_middle(where):
    found = told(f"put the red block {where}", RING)
    assert np.linalg.norm(np.array(found.position[:2]) - (0.65, 0.2)) < 0.5 * EDGE


def test_what_lies_on_a_tower_is_set_down_beside_it():
    found = told("put the third green block on the table", TOWERS, "third")
    assert found.relation is None
    assert found.position[2] == pytest.approx(HEIGHT, abs=0.01)
    assert np.linalg.norm(np.array(found.position[:2]) - (0.6, -0.4)) < 4 * EDGE


def test_a_side_of_somebody_is_a_side_of_the_table():
    near = told("put the red block on your side", TOWERS)
    assert near.position[0] < 0.6


def test_a_way_that_leaves_the_table_has_no_end():
    belief = believed("move the red block forty spaces to the right", TOWERS)
    assert destination(belief, ("red",)) is None
    assert leads_off_table(belief, ("red",))
    assert not leads_off_table(believed("move the red block two spaces to the right", TOWERS), ("red",))
