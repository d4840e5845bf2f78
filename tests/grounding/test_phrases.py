"""The meaning of phrases is told in agreement with the answer, by the readings that the answer was found with."""

import functools

import pytest

import models
from grounding import Grounder, load_world
from grounding.model.belief import believe, read
from grounding.model.evaluator import EVEN
from grounding.phrases import by_answer
from grounding.result import GroundedAction
from grounding.symbols import ObjectSymbol

WORLD = load_world(models.SCENES / "four.json")
BY_LEFT = [o.id for o in sorted(WORLD.things, key=lambda o: -o.position[1])]


@functools.cache
def grounder():
    return Grounder.load()


def phrases(text, *ids, action="pick"):
    """Noun phrases with their likely objects, where an answer handles `ids`."""
    understood = grounder().understand(text, WORLD)
    belief = believe(read(understood.parses, understood.scene), EVEN)
    told = by_answer(understood.readings[0], belief, [GroundedAction(action, ids, 0.9)])
    return {phrase.text: [(symbol.id, p) for symbol, p in phrase.groundings if isinstance(symbol, ObjectSymbol)]
            for phrase in told if phrase.tag == "NP"}  # fmt: skip


@pytest.mark.parametrize(("said", "name"), [("leftmost", BY_LEFT[0]), ("rightmost", BY_LEFT[-1])])
def test_what_is_handled_has_the_probability_of_the_answer(said, name):
    assert phrases(f"pick up the {said} block", name)[f"the {said} block"] == [(name, 0.9)]


def test_what_it_is_related_to_has_its_own_objects():
    text = "put the leftmost block on the rightmost block"
    found = phrases(text, BY_LEFT[0], action="place")
    assert found["the leftmost block"] == [(BY_LEFT[0], 0.9)]
    assert found["the rightmost block"][0][0] == BY_LEFT[-1]
