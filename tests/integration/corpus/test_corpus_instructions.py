from collections import Counter

import pytest
from by_hand import scene
from hypothesis import given
from hypothesis import strategies as st

from grounding.corpus.annotate import annotate
from grounding.corpus.format import Example
from grounding.corpus.generator import MOST_COPIES
from grounding.corpus.treebank import lay
from grounding.language.tree import from_brackets
from integration.corpus.bounding_boxes import boxed_of
from integration.corpus.constructions import constructions
from integration.corpus.images import choose
from integration.corpus.instructions import Sentences
from integration.corpus.videos import goal_of, slots_of

MIDDLE = """(VP (VB take) (NP (NP (DT the) (JJ middle) (NN block)) (PP (IN of) (NP (NP (DT the) (NN row))
 (PP (IN of) (NP (CD five) (NNS blocks)))))))"""
NEAREST = "(VP (VB take) (NP (DT the) (JJS nearest) (NN block)))"
BESIDE = """(VP (VB put) (NP (DT the) (JJS nearest) (NN block)) (PP (IN behind) (NP (DT the) (JJS farthest)
 (NN block))))"""


def example(brackets, world="default"):
    laid = lay(world, scene(world))
    tree = from_brackets(brackets)[0]
    groundings, outcome = annotate(tree, laid.layout, laid.arrangements)
    return Example("e", world, tree.text, tree, groundings, outcome), laid.layout.world


def item(wording, world="w", said=None, kinds=(), outcome="grounded"):
    line = {"id": "x", "world": world, "instruction": said or wording, "outcome": outcome}
    return {
        "example": line,
        "said": said or wording,
        "wording": wording,
        "constructions": list(kinds),
        "action": "pick",
    }


@given(
    drawn=st.lists(
        st.tuples(st.sampled_from("abc"), st.sampled_from(("w1", "w2", "w3")), st.integers(0, 5)), max_size=60
    ),
    most=st.integers(0, 40),
)
def test_what_is_joined_keeps_every_bound(drawn, most):
    sentences = Sentences()
    made = [item(wording, world, f"{wording}{number}") for wording, world, number in drawn]
    added = sentences.join(made, most)
    assert added == len(sentences.items) <= most
    assert sentences.taken == Counter(one["wording"] for one in sentences.items)
    assert max(sentences.taken.values(), default=0) <= MOST_COPIES
    said = [(one["example"]["world"], one["said"]) for one in sentences.items]
    assert len(set(said)) == len(said)
    ids = [one["example"]["id"] for one in sentences.items]
    assert len(set(ids)) == len(ids)
    if added < most:
        assert sentences.dropped == len(made) - added


def test_constructions_are_those_of_the_sentence():
    told = constructions(example(MIDDLE)[0])
    assert {"row", "count", "nested 2 deep"} <= set(told)
    assert not {"tower", "ordinal", "colour", "statement", "relative clause"} & set(told)
    assert "superlative" in constructions(example(NEAREST)[0])
    assert "relation" in constructions(example(BESIDE)[0])


def test_goals_are_those_of_the_annotation():
    picked, world = example(NEAREST)
    nearest = min(world.things, key=lambda one: float((one.position[:2] ** 2).sum()))
    goal = goal_of(picked, world, "pick")
    assert goal is not None
    assert goal.objects == (nearest.id,)
    assert goal_of(picked, world, "clear") is None
    placed, world = example(BESIDE)
    farthest = max(world.things, key=lambda one: float((one.position[:2] ** 2).sum()))
    goal = goal_of(placed, world, "place")
    assert goal is not None
    assert goal.destination is not None
    assert goal.destination.reference == (farthest.id,)
    assert goal.destination.position[0] > farthest.position[0]


def test_what_is_boxed_are_the_row_and_its_middle():
    boxed = boxed_of(example(MIDDLE)[0])
    meant, row = boxed[0], boxed[1]
    assert (meant.role, len(meant.objects)) == ("object", 1)
    assert (row.kind, len(row.objects)) == ("row", 5)
    assert meant.objects[0] in row.objects


def test_images_show_every_kind_and_worlds_apart_first():
    items = [item(f"r{k}", f"w{k % 3}", kinds=("row",)) for k in range(6)]
    items += [
        item("c", "w9", kinds=("circle",)),
        item("plain", "w10"),
        item("t", "w11", kinds=("tower",), outcome="ambiguous"),
    ]
    worlds = [line["world"] for line in choose(items, 5)]
    assert set(worlds[:4]) == {"w9", "w0", "w1", "w2"}
    assert len(choose(items, 99)) == len(items)


@pytest.mark.parametrize("count", [1, 3, 8])
def test_videos_try_worlds_of_their_own_first(count):
    items = [{**item(f"s{k}", f"w{k}"), "action": ("pick", "place", "clear")[k % 3 if k % 2 else 0]} for k in range(60)]
    slots = slots_of(items, count)
    assert [action for action, _ in slots] == [("pick", "place", "clear")[k % 3] for k in range(count)]
    for action in ("pick", "place", "clear"):
        tried = [line["world"] for name, lines in slots if name == action for line in lines]
        assert len(set(tried)) == len(tried)
