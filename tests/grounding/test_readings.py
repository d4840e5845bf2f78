"""Readings: shares of belief that sum to one, and what each asks for is there."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.geometry.layout import Layout
from grounding.inference import Hypothesis, Inference
from grounding.language.tree import from_brackets
from grounding.readings import pick_of, preferred, readings, requested
from grounding.symbols import (
    Action,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectSymbol,
    Region,
    SpatialReference,
)
from grounding.world import World, make_object

VP = from_brackets("(VP (VB take) (NP (DT the) (NN block)))")[0]
NP = VP.phrases[0]
FRAG = from_brackets("(FRAG (NP (DT the) (NN block)) (NP (DT the) (NN block)))")[0]


def layout(*colors):
    return Layout(
        World(tuple(make_object(f"b{i}", color=c, position=(0.6, 0.1 * i, 0.7)) for i, c in enumerate(colors)))
    )


LAYOUT = layout("red", "blue", "red")
PICKS = [Action("pick", (f"b{i}",)) for i in range(3)]


def leaf(*symbols, log=0.0):
    return Hypothesis(frozenset(symbols), log)


def over(*symbols, log=0.0, below=()):
    return Hypothesis(frozenset(symbols), log, (leaf(*below),))


logs = st.lists(st.tuples(st.sampled_from([(), (PICKS[0],), tuple(PICKS)]), st.floats(-40, 0)), min_size=1, max_size=4)


@given(st.lists(st.tuples(logs, st.floats(1e-12, 1)), min_size=1, max_size=4))
def test_shares_sum_to_one_and_are_ordered(found):
    inferences = []
    for hypotheses, probability in found:
        ordered = sorted(hypotheses, key=lambda item: -item[1])
        inferences.append((Inference(VP, tuple(over(*s, log=log) for s, log in ordered), 0, 0), probability))
    result = readings(inferences, LAYOUT)
    assert len(result) == sum(len(hypotheses) for hypotheses, _ in found)
    assert math.fsum(reading.weight for reading in result) == pytest.approx(1.0)
    weights = [reading.weight for reading in result]
    assert weights == sorted(weights, reverse=True)
    assert all(0 <= weight <= 1 for weight in weights)


def test_what_means_something_there_weighs_more():
    nothing, something = over(Action("pick"), log=-0.1), over(PICKS[0], log=-0.2)
    result = readings([(Inference(VP, (nothing, something), 0, 0), 1.0)], LAYOUT)
    assert result[0].actions == (PICKS[0],)


def test_actions_are_asked_for_in_one_order():
    asked = requested(VP, over(*PICKS, Action("pick")), LAYOUT)
    assert asked == tuple(PICKS)


def test_a_kind_of_action_alone_asks_for_nothing():
    assert requested(VP, over(Action("pick"), below=(ObjectSymbol("b1"),)), LAYOUT) == ()


def test_a_noun_phrase_alone_asks_to_pick_it_up():
    assert requested(NP, leaf(ObjectSymbol("b1"), ObjectAttribute("block")), LAYOUT) == (PICKS[1],)


def test_of_fragments_the_first_that_asks_for_something_counts():
    tree = Hypothesis(frozenset(), 0.0, (leaf(), leaf(ObjectSymbol("b2"))))
    assert requested(FRAG, tree, LAYOUT) == (PICKS[2],)


@pytest.mark.parametrize(
    ("symbols", "names"),
    [
        ((ObjectSymbol("b1"),), [("b1",)]),
        ((ObjectSymbol("b0"), ObjectSymbol("b2")), [("b0", "b2")]),
        ((ObjectAttribute("block"),), [("b0",), ("b1",), ("b2",)]),
        ((ObjectAttribute("block", "red"),), [("b0",), ("b2",)]),
        ((ObjectAttribute("block", "green"),), []),
        ((ObjectAttribute("block"), Container("row", ("b0", "b1"))), [("b0",), ("b1",)]),
        ((ObjectAttribute("block", "red"), Region("left", "object", ("b1",))), [("b2",)]),
        ((SpatialReference("left"),), []),
        ((ObjectSymbol("table"),), []),
        ((ContainerAttribute("block"),), []),
        ((), []),
    ],
)
def test_what_a_noun_phrase_leaves_possible(symbols, names):
    assert pick_of(frozenset(symbols), LAYOUT) == tuple(Action("pick", ids) for ids in names)


def test_in_an_empty_world_nothing_is_asked_for():
    assert pick_of(frozenset({ObjectAttribute("block")}), layout()) == ()


def test_a_hypothesis_that_means_something_there_is_preferred_to_a_likelier_one_that_does_not():
    nothing, something = leaf(SpatialReference("left"), log=0.0), leaf(ObjectSymbol("b1"), log=-1.0)
    assert preferred(Inference(NP, (nothing, something), 0, 0), LAYOUT) is something
    assert preferred(Inference(NP, (nothing, leaf(ObjectSymbol("b1"), log=-9.0)), 0, 0), LAYOUT) is nothing
