"""Outcomes: what is sure enough is the answer, several are a question, none says what is missing."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding import Grounder
from grounding.dialogue import decide
from grounding.geometry.layout import Layout
from grounding.language.tree import from_brackets
from grounding.lexicon.parameters import value
from grounding.model.belief import NOTHING, Belief
from grounding.symbols import Action
from grounding.world import World, make_object
from grounding.world.scene import Scene

TABLE = make_object("table", "table", position=(0.65, 0, 0.691), size=(0.7, 1.8, 0.04))
COLORS = ("red", "blue", "green", "yellow")
WORLD = World((*(make_object(f"b{i}", color=c, position=(0.6, 0.2 * i, 0.736)) for i, c in enumerate(COLORS)), TABLE))
SCENE = Scene(Layout(WORLD))
VP = from_brackets("(VP (VB take) (NP (DT the) (NN block)))")[0]
ODD = from_brackets("(VP (VB take) (NP (DT the) (JJ red) (NN wug)))")[0]


def believing(shares, kind="pick"):
    """A belief in single objects, by their places in the world, and in nothing by None."""
    named = {(NOTHING if i is None else (f"b{i}",)): share for i, share in shares.items()}
    options = sorted(named.items(), key=lambda item: (-item[1], item[0]))
    return Belief(tuple(options), (), (), dict.fromkeys(named, ((kind, 1.0),)))


def decided(shares, tree=VP, kind="pick", unknown=()):
    return decide(tree.text, tree, SCENE, unknown, believing(shares, kind))


@given(st.dictionaries(st.sampled_from([None, 0, 1, 2, 3]), st.floats(0.01, 1), min_size=1))
def test_belief_is_shared_out(parts):
    total = sum(parts.values())
    shares = {place: share / total for place, share in parts.items()}
    result = decided(shares)
    every = (*result.actions, *result.alternatives)
    assert sum(a.probability for a in every) <= 1 + 1e-9
    assert len({(a.action, a.objects) for a in every}) == len(every)
    assert (result.outcome == "grounded") == bool(result.actions)
    assert (result.outcome == "ambiguous") == (result.question is not None)
    assert all(a.probability >= value("answer.least") for a in result.actions)
    assert not result.actions or shares.get(None, 0.0) <= max(shares.values())


def test_a_sure_reading_is_an_answer_and_the_others_are_listed():
    result = decided({1: 0.8, 2: 0.2})
    assert result.outcome == "grounded"
    assert [(a.objects, a.probability) for a in result.actions] == [(("b1",), 0.8)]
    assert [(a.objects, a.probability) for a in result.alternatives] == [(("b2",), 0.2)]


def test_of_two_that_are_equally_likely_none_is_taken():
    result = decided({0: 0.5, 2: 0.5})
    assert result.outcome == "ambiguous"
    assert result.question == "Do you mean the red block or the green block?"


def test_a_question_of_many_names_three_and_counts_the_rest():
    result = decided(dict.fromkeys(range(4), 0.25))
    assert result.question.startswith("Do you mean the red block, the blue block, the green block, or ")
    assert "yellow" not in result.question


def test_what_is_to_be_placed_nowhere_is_asked_about():
    result = decided({0: 0.9, 1: 0.1}, kind="place")
    assert result.outcome == "ambiguous"
    assert result.question == "Where shall I put it?"


GROUNDER = Grounder.load()


def test_a_place_has_its_destination():
    result = GROUNDER.ground("put the red block on the green block", WORLD)
    assert result.actions[0].destination.position == pytest.approx((0.6, 0.4, 0.786))
    assert result.actions[0].destination.reference == ("b2",)


def test_a_place_without_room_is_said():
    near = World((make_object("a", color="red", position=(0.6, 0.0, 0.736)),
                  make_object("b", color="green", position=(0.6, 0.06, 0.736)),
                  make_object("c", color="blue", position=(0.6, 0.5, 0.736)), TABLE))  # fmt: skip
    result = GROUNDER.ground("put the blue block between the red block and the green block", near)
    assert result.outcome == "no_referent"
    assert not result.actions
    assert result.explanation == "there is no free place 'between the red block and the green block'"


@pytest.mark.parametrize(
    ("tree", "says"),
    [
        ("(VP (VB take) (NP (DT the) (JJ white) (NN block)))", "there is no white block; what is here is blue, green"),
        ("(VP (VB take) (NP (DT the) (JJ fifth) (NN block)))", "there is no fifth block; there are four"),
        ("(VP (VB take) (NP (DT the) (JJ second) (JJ red) (NN block)))", "no second red block; there is only one"),
        ("(VP (VB take) (NP (DT the) (NN tower)))", "there is no tower here"),
        ("(VP (VB take) (NP (NP (DT the) (NN row)) (PP (IN of) (NP (CD six) (NNS blocks)))))",
         "there is no row of six blocks; the longest has four"),
    ],
)  # fmt: skip
def test_what_is_missing_is_said(tree, says):
    result = decide("take it", from_brackets(tree)[0], SCENE)
    assert result.outcome == "no_referent"
    assert says in result.explanation


def test_a_thing_nobody_knows_is_named():
    result = decide("take the red wug", ODD, SCENE, ["wug"])
    assert result.outcome == "no_referent"
    assert result.unknown_words == ("wug",)
    assert "'wug'" in result.explanation
    assert "block" in result.explanation


def test_words_that_ask_for_nothing_are_named():
    tree = from_brackets("(VP (VB sing) (NP (DT a) (NN song)))")[0]
    result = decide("sing a song", tree, SCENE)
    assert result.outcome == "not_understood"
    assert "'sing'" in result.explanation


def test_phrases_are_told_from_outside_in():
    result = decided({0: 0.9, 1: 0.1})
    assert [(p.tag, p.text, p.words, p.depth) for p in result.phrases] == [
        ("VP", "take the block", (0, 2), 0), ("NP", "the block", (1, 2), 1),
    ]  # fmt: skip
    assert dict(result.phrases[0].groundings)[Action("pick", ("b0",))] == pytest.approx(0.9)
