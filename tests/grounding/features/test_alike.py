"""What is learned of left holds of right, and of "third" for "seventh": such phrases have the same rows."""

import re

import pytest

from grounding.features import STAGES, Scope
from grounding.features.context import context_facts
from grounding.geometry.layout import Layout
from grounding.language.lexicon import alike
from grounding.language.tree import from_brackets
from grounding.symbols import (
    Container,
    ObjectAttribute,
    ObjectSymbol,
    ObjectType,
    Ordinal,
    Region,
    SpatialReference,
)
from grounding.world import World, make_object

PLACES = [(0.6, 0.42), (0.62, 0.2), (0.58, 0.01), (0.7, -0.18), (0.61, -0.4), (0.9, 0.05), (0.75, -0.33)]
ROW = ("b0", "b1", "b2", "b3", "b4")


def layout(sign):
    items = (make_object(f"b{i}", color="red", position=(x, sign * y, 0.7)) for i, (x, y) in enumerate(PLACES))
    return Layout(World(tuple(items)))


def rows(tree, children, world, concrete, abstract):
    """Facts and judged symbols with their roles, stage by stage."""
    scope = Scope(tree, children, world)
    found = []
    for number, families in enumerate(STAGES):
        if number == 1:
            scope = scope.with_concrete(frozenset(concrete))
        elif number == 2:
            scope = scope.with_abstract(frozenset(abstract))
        judged = [(str(s), sorted(set(roles))) for family in families for s, roles in family.propose(scope)]
        found.append((list(context_facts(scope)), sorted(judged)))
    return found


def mirrored(text):
    return re.sub("left|right", lambda side: "right" if side.group() == "left" else "left", text)


def phrase(side, rank):
    tree = from_brackets(
        f"(NP (NP (NP (DT the) (JJ {rank}) (NN block)) (PP (IN from) (NP (DT the) (NN {side})))) "
        "(PP (IN in) (NP (DT the) (NN row))))"
    )[0]
    value = 3 if rank == "third" else 4
    head = [ObjectAttribute("block", None, side, value), ObjectSymbol(ROW[value - 1])]
    mod = [Container("row", ROW), *map(ObjectSymbol, ROW)]
    return tree, [frozenset(head), frozenset(mod)]


@pytest.mark.parametrize("rank", ["third", "fourth"])
def test_mirrored_worlds_and_words_have_the_same_rows(rank):
    left = rows(*phrase("left", rank), layout(1), [], [])
    right = rows(*phrase("right", rank), layout(-1), [], [])
    for (facts, judged), (other_facts, other_judged) in zip(left, right, strict=True):
        assert facts == other_facts
        assert sorted((mirrored(symbol), roles) for symbol, roles in judged) == other_judged


def test_sides_of_things_are_mirrored_too():
    tree = from_brackets("(NP (NP (DT the) (NN left)) (PP (IN of) (NP (DT the) (NN row))))")[0]
    other = from_brackets("(NP (NP (DT the) (NN right)) (PP (IN of) (NP (DT the) (NN row))))")[0]
    row = frozenset([Container("row", ROW)])
    left = rows(tree, [frozenset([SpatialReference("left")]), row], layout(1), [], [Region("left", "row", ROW)])
    right = rows(other, [frozenset([SpatialReference("right")]), row], layout(-1), [], [Region("right", "row", ROW)])
    for (facts, judged), (other_facts, other_judged) in zip(left, right, strict=True):
        assert facts == other_facts
        assert sorted((mirrored(symbol), roles) for symbol, roles in judged) == other_judged


def test_ranks_differ_by_their_word_alone():
    """But for the word itself, which noisy annotations need."""
    tree = "(NP (DT the) (JJ {}) (NN block))"
    concrete = [ObjectType("block")]
    facts = {
        word: rows(from_brackets(tree.format(word))[0], [], layout(1), [*concrete, Ordinal(value)], [])[1][0]
        for word, value in (("third", 3), ("fifth", 5))
    }
    assert set(facts["third"]) ^ set(facts["fifth"]) == {"rank=third", "rank=fifth"}


@pytest.mark.parametrize(
    ("word", "name"),
    [("third", "<ordinal>"), ("7th", "<ordinal>"), ("five", "<cardinal>"), ("blue", "<color>"), ("left", "<side>"),
     ("rightmost", "<side>most"), ("last", "last"), ("nearest", "nearest"), ("block", "block"), ("pair", "pair")],
)  # fmt: skip
def test_names_of_words(word, name):
    assert alike(word) == name


def test_what_the_head_ranked_is_ranked_again_within_the_modifier():
    """The middle block of all is b5's neighbour; that it was the head's object must not speak for it."""
    tree = from_brackets("(NP (NP (DT the) (NN middle) (NN block)) (PP (IN in) (NP (DT the) (NN row))))")[0]
    head = frozenset([ObjectAttribute("block", None, "center", 1), ObjectSymbol("b3")])
    mod = frozenset([Container("row", ROW), *map(ObjectSymbol, ROW)])
    judged = dict(rows(tree, [head, mod], layout(1), [], [])[2][1])
    assert "is head" not in judged["object(b3)"]
    assert "ranked[mod.in|head]" in judged["object(b2)"]
    assert "ranked[mod.in|head]" not in judged["object(b3)"]
