"""Places that are not told apart are asked about, and what is not there is said not to be."""

import functools

import pytest

import models
from grounding.grounder import Grounder
from grounding.world import World, load_world, make_object

TABLE = load_world(models.SCENES / "four.json")["table"]
PLACES = {"red": [(0.5, 0.4)], "blue": [(0.6, 0.1)], "green": [(0.55, -0.2), (0.7, -0.5)]}
WORLD = World((TABLE, *(make_object(f"{color}{i}", color=color, position=(x, y, 0.736))
                        for color, points in PLACES.items() for i, (x, y) in enumerate(points))))  # fmt: skip


@functools.cache
def grounder():
    return Grounder.load()


def ground(text, history=()):
    return grounder().ground(text, WORLD, history)


@pytest.mark.parametrize("thing", ["the green block", "the block", "the green block on the right side of the table"])
def test_a_definite_place_that_several_things_fit_is_asked_about(thing):
    found = ground(f"put the red block behind {thing}")
    assert found.outcome == "ambiguous"
    assert found.question
    assert found.alternatives[0].objects == ("red0",)


@pytest.mark.parametrize("thing", ["a green block", "the blue block", "the nearest green block"])
def test_an_indefinite_or_a_plain_place_is_not(thing):
    assert ground(f"put the red block behind {thing}").outcome == "grounded"


def test_the_block_that_was_spoken_of_is_plain():
    assert ground("there is a blue block. take the red block and put it behind the block").outcome == "grounded"


def test_it_is_nothing_where_nothing_was_spoken_of():
    found = ground("put it on the blue block")
    assert found.outcome == "not_understood"
    assert "'it'" in found.explanation
    assert ground("put it on the blue block", ("red0",)).actions[0].objects == ("red0",)


@pytest.mark.parametrize("where", ["on the tower", "on top of the stack"])
def test_nothing_goes_on_a_tower_that_is_not_there(where):
    found = ground(f"put the red block {where}")
    assert found.outcome == "no_referent"
    assert "tower" in found.explanation


def test_what_is_put_to_the_back_is_not_put_back():
    assert ground("put the red block to the back").actions[0].destination is not None


def test_a_way_off_the_table_is_refused():
    found = ground("move the red block forty spaces to the right")
    assert found.outcome == "no_referent"
    assert "table" in found.explanation
