"""Texts followed clause by clause: mentions, choices, denials, statements, and what "it" is."""

import functools

import pytest

from grounding.language.parser import Parser
from grounding.meaning.discourse.following import read_text
from grounding.meaning.notation import write
from grounding.meaning.reader import Reader
from grounding.meaning.reading import Context


@functools.cache
def parser():
    return Parser.load()


def told(text, **context):
    return read_text(parser().parse(text, 1)[0].tree, Reader(Context(**context)))


def lines(text, **context):
    return write(told(text, **context)).splitlines()


def conditions(text, name="x1"):
    found = [line for line in lines(text) if line.startswith(f"{name} ") and not line.startswith(f"{name} is ")]
    return [line.removeprefix(f"{name} ").partition(' said "')[0] for line in found]


def test_one_is_chosen_from_several_that_are_mentioned():
    text = "there are three blue blocks in a line. take the middle one"
    assert "mentioned x2" in lines(text)
    assert conditions(text) == ["middle", "those of x2"]
    assert conditions(text, "x2")[0] == "colour blue"
    assert any(line.startswith("x2 is sets number 3") for line in lines(text))


def test_it_is_what_was_mentioned():
    found = told("there is a red block on the left. pick it up")
    assert found.target is found.mentioned
    assert [condition.concept for condition in found.target.conditions] == ["colour", "kind", "at"]


@pytest.mark.parametrize("text", ["find the tower. take its top block", "there is a tower. take its top block"])
def test_a_part_is_taken_of_what_was_mentioned(text):
    assert conditions(text) == ["kind block", "extreme up", "those of x2"]
    assert any(line.startswith("x2 is sets tower") for line in lines(text))


def test_what_is_denied_is_not_meant():
    found = conditions("pick up the red block. it is not the one next to the tower")
    assert "not same as x3" in found


def test_what_is_stated_says_more_of_the_same():
    found = told("pick up the block. it is the red one next to the tower")
    concepts = [condition.concept for condition in found.target.conditions]
    assert {"colour", "beside"} <= set(concepts)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("pick up the red block", "pick"), ("put the red block on the tower", "place"),
        ("move the red block to the left", "place"), ("clear the red blocks", "clear"), ("the red block", "pick"),
    ],
)  # fmt: skip
def test_verbs_say_what_is_to_be_done(text, kind):
    assert told(text).kind == kind
    assert conditions(text) == ["colour red", "kind block"]


def test_a_destination_is_no_part_of_what_is_handled():
    found = told("put the red block on the blue block")
    assert [phrase.text for phrase in found.destination][-1] == "on the blue block"
    assert conditions("put the red block on the blue block") == ["colour red", "kind block"]


def test_a_thing_named_before_the_command_is_handled():
    assert conditions("the red block. take it") == ["colour red", "kind block"]


def test_a_text_without_a_thing_has_no_target():
    assert told("sing a song").target is None
    assert lines("sing a song") == ["goal pick"]


def test_it_alone_is_what_was_handled():
    assert told("take it").target is None
    assert told("take it", handled=True).target.conditions[0].concept == "recalled"


@pytest.mark.parametrize("text", [
    "there's three greens in a line. just the middle one, please", "purple row: take the middle one",
    "the row nearest you, take the middle one", "three reds on the left. grab the middle one",
])  # fmt: skip
def test_a_set_that_is_named_first_is_chosen_from(text):
    found = conditions(text)
    assert "middle" in found
    assert any(line.startswith(("those of", "same as")) for line in found)
    assert told(text).target.sort == "objects"


def test_what_an_arrangement_has_is_its_own_and_its_end_is_the_arrangement_s():
    text = "the far row has a red block at its left end. pick it up"
    assert any(line.startswith("member of") for line in conditions(text))
    assert any(line.endswith("part left edge of x5") or "part left edge of" in line for line in lines(text))


@pytest.mark.parametrize("denial", ["neither red nor blue", "not red or blue"])
def test_several_colours_are_denied_together(denial):
    assert "not colour red blue" in conditions(f"pick up the block that is {denial}")
