"""What lies between two arrangements lies between the nearest of their members, for objects as for free places."""

import functools

import pytest

from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.model.belief import believe, read
from grounding.model.cases import Weights
from grounding.model.evaluator import EVEN
from grounding.placing import destination
from grounding.world import World, make_object
from grounding.world.scene import Scene


@functools.cache
def parser():
    return Parser.load()


def world_of(**places):
    blocks = [make_object(name, "block", colour, (x, y, 0.736), size=(0.05, 0.05, 0.05))
              for name, (colour, x, y) in places.items()]  # fmt: skip
    table = make_object("table", "table", "white", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04))
    return World((*blocks, table))


ROW = {f"r{i}": ("red", 0.45, 0.2 + 0.09 * i) for i in range(4)}
COLUMN = {f"c{i}": ("red", 0.45 + 0.09 * i, -0.25) for i in range(4)}
LINES = {**ROW, **COLUMN, "free": ("blue", 0.85, 0.7)}


def believed(text, world):
    scene = Scene(Layout(world))
    return believe(read(parser().parse(text, 4), scene, (), EVEN), Weights({**EVEN, "nothing": -3.0}))


@pytest.mark.parametrize(
    "text",
    ["put the blue block between the row and the column", "place the blue block between the column and the row"],
)
def test_a_place_between_a_row_and_a_column_is_outside_of_both(text):
    found = destination(believed(text, world_of(**LINES)), ("free",))
    x, y, _ = found.position
    assert 0.4 < x < 0.8
    assert -0.25 < y < 0.2


def test_the_block_between_a_row_and_a_column_belongs_to_neither():
    world = world_of(**LINES, mid=("red", 0.5, 0.0))
    assert believed("pick up the red block between the row and the column", world).listed()[0].objects == ("mid",)
