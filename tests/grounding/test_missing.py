"""What is missing is told: colours, arrangements, ranks, things; and never where it is there."""

import functools

import pytest

import models
from grounding import Grounder, load_world, make_object
from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.missing import unknown_things, whats_missing
from grounding.world import World
from grounding.world.scene import Scene


@functools.cache
def scene(name):
    return Scene(Layout(load_world(models.SCENES / f"{name}.json")))


@functools.cache
def tree(text):
    return Parser.load().parse(text)[0].tree


@pytest.mark.parametrize(
    ("world", "text", "says"),
    [("four", "pick up the green block", "there is no green block; what is here is blue and red"),
     ("four", "pick up the block behind the green block", "there is no green block"),
     ("four", "take the fifth block from the left", "there is no fifth block; there are four"),
     ("four", "take the third red block", "there is no third red block; there are two"),
     ("four", "pick up the top block of the tower", "there is no tower here"),
     ("default", "pick up the middle block in the row of seven blocks",
      "there is no row of seven blocks; the longest has six"),
     ("four", "pick up the mug", "there is no mug here; the world has: block"),
     ("four", "pick up the block next to the mug", "there is no mug here")],
)  # fmt: skip
def test_what_is_not_there_is_named(world, text, says):
    assert says in whats_missing(tree(text), scene(world))


@pytest.mark.parametrize(
    ("world", "text"),
    [("four", "pick up the red block"), ("four", "take the fourth block from the left"),
     ("default", "pick up the middle block in the row of five blocks on the right"),
     ("tower", "pick up the top block of the tower"), ("four", "raise your hand and take the red block"),
     ("four", "from your point of view take the leftmost block"), ("four", "take it")],
)  # fmt: skip
def test_nothing_is_missing_where_it_is_there(world, text):
    assert whats_missing(tree(text), scene(world)) is None


def test_things_of_a_known_type_are_no_strangers():
    world = World((make_object("m", "mug", position=(0.6, 0, 0.7)), make_object("b", position=(0.6, 0.2, 0.7))))
    assert unknown_things(tree("pick up the mug"), Layout(world)) == ()
    assert unknown_things(tree("pick up the wug"), Layout(world)) == ("wug",)


def test_an_empty_table_lacks_everything():
    assert whats_missing(tree("pick up the block"), Scene(Layout(World(())))) == "there is nothing on the table"


@pytest.mark.parametrize("text", ["take the red block", "put the red block behind the tower", "the 5000th block"])
def test_every_sentence_lacks_all_on_an_empty_table(text):
    result = Grounder.load().ground(text, World(()))
    assert result.outcome == "no_referent"
    assert result.explanation == "there is nothing on the table"


@pytest.mark.parametrize("rank", ["40th", "5000th", "123456789012345th"])
def test_nobody_counts_so_far(rank):
    alone = World((make_object("b", position=(0.6, 0.2, 0.736)),))
    result = Grounder.load().ground(f"take the {rank} block", alone)
    assert result.outcome == "no_referent"
    assert "there is only one" in result.explanation
