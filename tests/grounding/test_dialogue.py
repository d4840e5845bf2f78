"""Outcomes: sure readings are answers, several are a question, none says what is missing."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.dialogue import CONFIDENT, decide
from grounding.geometry.layout import Layout
from grounding.inference import Hypothesis, Inference
from grounding.language.tree import from_brackets
from grounding.readings import Reading
from grounding.symbols import Action, ObjectAttribute, Region
from grounding.world import World, make_object
from grounding.world.scene import Scene

TABLE = make_object("table", "table", position=(0.65, 0, 0.691), size=(0.7, 1.8, 0.04))
COLORS = ("red", "blue", "green", "yellow")
SCENE = Scene(Layout(
    World((*(make_object(f"b{i}", color=c, position=(0.6, 0.2 * i, 0.736)) for i, c in enumerate(COLORS)), TABLE))
))  # fmt: skip
VP = from_brackets("(VP (VB take) (NP (DT the) (NN block)))")[0]
ODD = from_brackets("(VP (VB take) (NP (DT the) (JJ red) (NN wug)))")[0]
PICKS = [Action("pick", (f"b{i}",)) for i in range(4)]


def empty(tree):
    return Hypothesis(frozenset(), -0.5, tuple(empty(child) for child in tree.phrases))


def reading(weight, *actions, tree=VP, symbols=(), below=()):
    children = (empty(child) for child in tree.phrases) if not below else (Hypothesis(frozenset(below), -0.5),)
    hypothesis = Hypothesis(frozenset((*actions, *symbols)), -1.0, tuple(children))
    return Reading(Inference(tree, (hypothesis,), 1, 1), hypothesis, tuple(actions), weight)


actions = st.lists(st.sampled_from([*PICKS, Action("clear", ("b1", "b2"))]), max_size=4, unique=True)


@given(st.lists(st.tuples(actions, st.floats(0.01, 1)), min_size=1, max_size=5))
def test_belief_is_shared_out(parts):
    total = sum(weight for _, weight in parts)
    found = sorted((reading(weight / total, *asked) for asked, weight in parts), key=lambda r: -r.weight)
    result = decide("take the block", found, SCENE)
    every = (*result.actions, *result.alternatives)
    assert sum(a.probability for a in every) <= 1 + 1e-9
    assert len({(a.action, a.objects) for a in every}) == len(every)
    assert (result.outcome == "grounded") == bool(result.actions)
    assert (result.outcome == "ambiguous") == (result.question is not None)
    assert all(a.probability >= CONFIDENT for a in result.actions)
    assert result.outcome in ("grounded", "ambiguous")
    nothing = sum(r.weight for r in found if not r.actions)
    assert nothing < 0.5 or result.outcome == "ambiguous"  # all blocks are possible then


def test_a_sure_reading_is_an_answer_and_the_others_are_listed():
    result = decide("take the block", [reading(0.8, PICKS[1]), reading(0.2, PICKS[2])], SCENE)
    assert result.outcome == "grounded"
    assert [(a.objects, a.probability) for a in result.actions] == [(("b1",), 0.8)]
    assert [(a.objects, a.probability) for a in result.alternatives] == [(("b2",), 0.2)]


def test_readings_of_one_meaning_are_counted_together():
    result = decide("take it", [reading(0.25, PICKS[0]), *[reading(0.25, PICKS[1])] * 3], SCENE)
    assert result.actions[0].objects == ("b1",)
    assert result.actions[0].probability == pytest.approx(0.75)


def test_of_two_that_are_equally_likely_none_is_taken():
    assert decide("take the block", [reading(1.0, PICKS[0], PICKS[2])], SCENE).outcome == "ambiguous"


def test_a_question_tells_the_objects_apart():
    result = decide("take the block", [reading(0.9, PICKS[0], PICKS[2])], SCENE)
    assert result.outcome == "ambiguous"
    assert result.question == "Do you mean the red block or the green block?"


def test_a_question_of_many_names_three_and_counts_the_rest():
    result = decide("take the block", [reading(1.0, *PICKS)], SCENE)
    assert result.question.startswith("Do you mean the red block, the blue block, the green block, or ")
    assert "yellow" not in result.question


def test_a_question_tells_the_kinds_of_action_apart():
    result = decide("the block", [reading(0.4, PICKS[0]), reading(0.35, Action("clear", ("b0",)))], SCENE)
    assert result.question == "Shall I clear or pick the red block?"


def test_a_question_tells_places_apart():
    asked = [Action("place", ("b0",), Region(side, "object", ("b2",))) for side in ("left", "right")]
    result = decide("put it", [reading(0.4, asked[0]), reading(0.4, asked[1])], SCENE)
    assert result.question == (
        "Where do you want the red block: to the left of the green block or to the right of the green block?"
    )
    assert all(a.destination.reference == ("b2",) for a in result.alternatives)


def test_a_place_has_its_destination():
    result = decide("put it", [reading(1.0, Action("place", ("b0",), Region("top", "object", ("b2",))))], SCENE)
    assert result.actions[0].destination.position == pytest.approx((0.6, 0.4, 0.786))


def test_a_place_without_room_is_said():
    result = decide("put it", [reading(1.0, Action("place", ("b0",), Region("bottom", "object", ("b2",))))], SCENE)
    assert result.outcome == "no_referent"
    assert not result.actions
    assert "no free place under the green block" in result.explanation


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
    result = decide("take it", [reading(1.0, tree=from_brackets(tree)[0], below=None)], SCENE)
    assert result.outcome == "no_referent"
    assert says in result.explanation


def test_a_thing_nobody_knows_is_named():
    result = decide("take the red wug", [reading(1.0, symbols=(Action("pick"),), tree=ODD)], SCENE, ["wug"])
    assert result.outcome == "no_referent"
    assert result.unknown_words == ("wug",)
    assert "'wug'" in result.explanation
    assert "block" in result.explanation


def test_words_that_ask_for_nothing_are_named():
    tree = from_brackets("(VP (VB sing) (NP (DT a) (NN song)))")[0]
    result = decide("sing a song", [reading(1.0, tree=tree)], SCENE)
    assert result.outcome == "not_understood"
    assert result.unknown_words == ("sing", "song")


def test_phrases_are_told_from_outside_in():
    result = decide("take the block", [reading(1.0, PICKS[0], below=(ObjectAttribute("block"),))], SCENE)
    assert [(p.tag, p.text, p.words, p.depth) for p in result.phrases] == [
        ("VP", "take the block", (0, 2), 0), ("NP", "the block", (1, 2), 1),
    ]  # fmt: skip
    assert dict(result.phrases[0].groundings)[PICKS[0]] == pytest.approx(1.0)
