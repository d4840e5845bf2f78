"""Ways in block lengths end on the table."""

import functools

import pytest

import models
from grounding.corpus.strides import leaves_table
from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.symbols import Action, Region
from grounding.world import World, load_world, make_object

TABLE = load_world(models.SCENES / "four.json")["table"]
X, Y = TABLE.position[:2]


@functools.cache
def parser():
    return Parser.load()


def leaves(text, x, y):
    layout = Layout(World((TABLE, make_object("b", color="red", position=(X + x, Y + y, 0.736)))))
    own = Action("place", ("b",), Region("left", "object", ("b",)))
    return leaves_table(parser().parse(text, 1)[0].tree, layout, own)


@pytest.mark.parametrize(
    "text",
    ["move the block six spaces to the right", "slide the block right six block lengths",
     "move the block four spaces west and ten spaces east"],
)  # fmt: skip
def test_it_depends_on_where_something_is(text):
    half = TABLE.half_extents[1]
    assert leaves(text, 0, -half + 0.1)
    assert not leaves(text, 0, half - 0.25)


def test_what_comes_back_does_not_leave():
    text = "move the block two spaces to the right and then two spaces to the left"
    assert not leaves(text, 0, -TABLE.half_extents[1] + 0.05)


def test_a_way_of_no_length_leaves_nothing():
    assert not leaves("move the block to the right", 0, -TABLE.half_extents[1] + 0.05)


def test_places_told_by_other_things_are_not_ways():
    layout = Layout(World((TABLE, make_object("b", position=(X, Y, 0.736)))))
    beside = Action("place", ("b",), Region("left", "object", ("table",)))
    assert not leaves_table(parser().parse("move the block forty spaces to the right", 1)[0].tree, layout, beside)
