"""Several things to do in one text: each is grounded in the world that those before it leave."""

import functools

import pytest

import models
from grounding import Grounder, load_world


@functools.cache
def grounder():
    return Grounder.load()


@functools.cache
def scene(name="four"):
    return load_world(models.SCENES / f"{name}.json")


BY_LEFT = [o.id for o in sorted(scene().things, key=lambda o: -o.position[1])]
FIRST, LAST = BY_LEFT[0], BY_LEFT[-1]


def actions(text, world="four"):
    result = grounder().ground(text, scene(world))
    assert result.outcome == "grounded", (text, result.explanation)
    return [(a.action, a.objects) for a in result.actions]


@pytest.mark.parametrize(
    "text",
    ["pick up the leftmost block. then put it on the rightmost block",
     "take the leftmost block and put it on the rightmost block",
     "pick up the leftmost block, then place it on top of the rightmost block",
     "take the leftmost block and put the block on the rightmost block"],
)  # fmt: skip
def test_one_thing_is_one_place(text):
    assert actions(text) == [("place", (FIRST,))]


@pytest.mark.parametrize(
    ("text", "expected"),
    [("take the leftmost block. take the rightmost block", [("pick", (FIRST,)), ("pick", (LAST,))]),
     ("take the leftmost block, then the rightmost block", [("pick", (FIRST,)), ("pick", (LAST,))]),
     ("move the leftmost block out of the way and pick up the rightmost block",
      [("clear", (FIRST,)), ("pick", (LAST,))]),
     ("put the leftmost block on the nearest block and then the rightmost block next to the farthest block",
      [("place", (FIRST,)), ("place", (LAST,))]),
     ("put the leftmost block on the nearest block and the rightmost block behind the farthest block",
      [("place", (FIRST,)), ("place", (LAST,))]),
     ("stack the leftmost block on the nearest blue block, and the rightmost block on the farthest blue block",
      [("place", (FIRST,)), ("place", (LAST,))]),
     ("put the leftmost block on the nearest block and pick up the rightmost block",
      [("place", (FIRST,)), ("pick", (LAST,))])],
)  # fmt: skip
def test_two_things_are_done_in_order(text, expected):
    assert actions(text) == expected


@pytest.mark.parametrize(
    "text", ["put the leftmost block between the nearest blue block and the farthest block on the right",
             "put the leftmost block and the rightmost block on the nearest blue block"]
)  # fmt: skip
def test_things_that_are_joined_are_no_steps(text):
    result = grounder().ground(text, scene())
    assert "step" not in result.explanation
    assert len(result.actions) <= 1


def test_the_second_step_sees_what_the_first_has_done():
    text = "put the leftmost block to the right of the rightmost block. take the second block from the right"
    assert actions(text) == [("place", (FIRST,)), ("pick", (LAST,))]


def test_a_step_that_is_open_is_named_and_nothing_is_done():
    result = grounder().ground("take the leftmost block and then put the blue block on the rightmost block", scene())
    assert result.outcome == "ambiguous"
    assert not result.actions
    assert "step 2 of 2" in result.explanation


def test_what_is_forbidden_besides_is_left():
    assert actions("pick up the leftmost block. do not touch the rightmost block") == [("pick", (FIRST,))]


def test_phrases_of_all_steps_stand_below_one():
    result = grounder().ground("take the leftmost block. take the rightmost block", scene())
    assert [p.depth for p in result.phrases].count(0) == 1
    assert result.phrases[0].tag == "FRAG"
    assert len(result.phrases[0].groundings) == 2
    assert {p.text for p in result.phrases if p.tag == "NP"} == {"the leftmost block", "the rightmost block"}


def test_mended_words_are_told():
    data = grounder().ground("pick up teh leftmost blok", scene()).to_json()
    assert data["mended"] == [["teh", "the"], ["blok", "block"]]
    assert "mended" not in grounder().ground("pick up the leftmost block", scene()).to_json()


def test_many_things_that_are_hardly_meant_do_not_make_two_things_one():
    text = "pick up the nearest block and then put the leftmost block on the rightmost block"
    assert actions(text, "twenty_mixed") == [("pick", ("b17",)), ("place", ("b18",))]
