"""Readers that are left out believe in nothing; what is kept of worlds changes no answer and stays bounded."""

import functools

import pytest

import models
from grounding import Grounder, GroundingError, load_world
from grounding.grounder import KEPT_VIEWS, READERS
from grounding.model.evaluator import KEPT


@functools.cache
def grounder():
    return Grounder.load()


@functools.cache
def scene(name):
    return load_world(models.SCENES / f"{name}.json")


def without(*names):
    return Grounder(grounder().parser, grounder().learned, without=names)


@pytest.mark.parametrize("name", READERS)
def test_a_reader_that_is_left_out_believes_in_nothing(name):
    understood = without(name).understand("pick up the leftmost block", scene("four"))
    believes = {
        "meanings": any(reading.place >= 0 for reading in understood.belief.readings),
        "literal": bool(understood.literal.options),
    }
    assert {reader for reader, something in believes.items() if not something} == {name}


def test_nothing_is_left_out_unless_asked():
    text = "pick up the farthest red block"
    assert without().ground(text, scene("four")).actions == grounder().ground(text, scene("four")).actions


def test_without_any_reader_only_the_factors_are_asked():
    understood = without(*READERS).understand("pick up the farthest red block", scene("four"))
    assert not understood.options() or not understood.belief.listed()


@pytest.mark.parametrize("name", READERS)
def test_each_reader_answers_what_is_plain_by_itself(name):
    only = without(*(other for other in READERS if other != name))
    assert only.ground("pick up the leftmost block", scene("four")).actions[0].objects == ("b1",)


def test_readers_that_are_not_there_cannot_be_left_out():
    with pytest.raises(GroundingError, match=r"'oracle'.*meanings, literal"):
        without("oracle")


def test_what_is_kept_of_a_world_is_bounded():
    fresh = Grounder(grounder().parser, grounder().learned)
    world = scene("default")
    for number in range(30):
        which = ("leftmost", "nearest", "middle")[number % 3]
        fresh.ground(f"pick up the {which} block", world, (f"b{1 + number % 20}",))
    ((_, known),) = fresh._known.values()
    assert len(known) <= KEPT_VIEWS + 2
    assert all(len(evaluator._alike) <= 2 * KEPT for evaluator in known.values())


def test_the_order_of_texts_changes_no_answer():
    texts = ["pick up the leftmost block", "take the block behind the leftmost block", "lift the middle one in the row"]
    answers = []
    for order in (texts, texts[::-1]):
        fresh = Grounder(grounder().parser, grounder().learned)
        found = {text: fresh.ground(text, scene("default")) for text in order}
        answers.append([(found[text].outcome, found[text].actions, found[text].alternatives) for text in texts])
    assert answers[0] == answers[1]
