"""The notation of meanings: what is written reads back as the same, and what cannot be read is told where it is."""

import functools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import models
from grounding.corpus.making import make_corpus
from grounding.corpus.treebank import read_trees
from grounding.errors import GroundingError, MeaningError
from grounding.geometry.layout import Layout
from grounding.meaning.discourse.following import read_text
from grounding.meaning.notation import lines, parse_meaning, write, write_referent
from grounding.meaning.notation_terms import CONCEPTS, KEYWORDS, SORTS
from grounding.meaning.reader import Reader
from grounding.meaning.reading import Context
from grounding.meaning.referents import Condition, Referent, Region
from grounding.model.evaluator import Evaluator
from grounding.world import load_world
from grounding.world.scene import Scene

GENERATED = 300


@functools.cache
def told_texts():
    """What all texts of the treebank and some generated ones tell."""
    trees = [tree for folder in (models.TREEBANK, models.TREEBANK / "heldout") for tree in read_trees(folder)]
    trees += [example.tree for example in make_corpus(GENERATED, seed=3).examples]
    return tuple(read_text(tree, Reader(Context(handled=place % 2 > 0))) for place, tree in enumerate(trees))


@functools.cache
def scene(name):
    return Scene(Layout(load_world(models.SCENES / f"{name}.json")))


def test_every_text_reads_back():
    for told in told_texts():
        written = write(told)
        meaning = parse_meaning(written)
        assert write(meaning) == written
        assert meaning.kind == told.kind
        assert meaning.destination == tuple(phrase.text for phrase in told.destination)


@pytest.mark.parametrize("name", ["groups", "tower"])
def test_what_is_read_back_means_the_same(name):
    for told in told_texts()[::9]:
        if told.target is None:
            continue
        again = parse_meaning(write(told)).target
        found, expected = (Evaluator(scene(name), history=(1,)).denote(r) for r in (again, told.target))
        np.testing.assert_array_equal(found.weights, expected.weights)
        assert found.truth == expected.truth
        for (mask, chance), (other, likely) in zip(found.sets, expected.sets, strict=True):
            assert chance == likely
            assert (mask == other).all()


def test_a_meaning_is_easy_to_read():
    tower = Referent("sets", kinds=("tower",), text="the tower")
    block = Referent("objects", (
        Condition("colour", words=("red",)),
        Condition("toward", (tower,), ("left",), strict=True),
        Condition("nearest", (tower,), rank=2),
        Condition("at", region=Region(("back", "left"), corner=True, rim=True, table=True)),
        Condition("member", (tower,), negated=True),
        Condition("extreme", region=Region(("left",), bare=True)),
    ), text='the "red" block')  # fmt: skip
    assert write_referent(block).splitlines() == [
        'x1 is objects said "the \\"red\\" block"',
        "x1 colour red",
        "x1 toward left of x2 strictly",
        "x1 nearest to x2 rank 2",
        "x1 at back left corner of the table",
        "x1 not member of x2",
        "x1 extreme left",
        'x2 is sets tower said "the tower"',
    ]


def test_what_is_shared_is_written_once():
    tower = Referent("sets", kinds=("tower",))
    told = lines(Referent("objects", (Condition("beside", (tower,)), Condition("beside", (tower,)))))
    assert [line.name for line in told] == ["x1", "x1", "x1", "x2"]
    target = parse_meaning("\n".join(line.text for line in told)).target
    assert target.conditions[0].of[0] is target.conditions[1].of[0]


# Any meaning at all

texts = st.one_of(st.sampled_from(sorted(KEYWORDS)), st.text(max_size=5), st.sampled_from(["left", "x3", "7"]))
words = st.lists(texts, max_size=3).map(tuple)
people = st.sampled_from([None, "robot", "speaker"])
numbers = st.floats(-20, 20) | st.integers(-5, 9).map(float)
ranks = st.none() | st.integers(-3, 9)
regions = st.builds(Region, words, st.booleans(), st.booleans(), st.booleans(), st.booleans(), people, st.booleans())


def conditions(referents):
    return st.builds(
        Condition, st.sampled_from(sorted(CONCEPTS)), st.lists(referents, max_size=2).map(tuple), words,
        st.none() | regions, people, st.none() | numbers, st.lists(st.tuples(words, numbers), max_size=2).map(tuple),
        ranks, st.booleans(), st.booleans(), st.booleans(), st.booleans(), texts,
    )  # fmt: skip


def wider(referents):
    return st.builds(
        Referent, st.sampled_from(SORTS), st.lists(conditions(referents), max_size=3).map(tuple), words, ranks,
        *[st.booleans()] * 5, st.lists(referents, max_size=2).map(tuple), st.booleans(), st.none() | regions, people,
        texts,
    )  # fmt: skip


referents = st.recursive(st.builds(Referent, st.sampled_from(SORTS)), wider, max_leaves=6)


def unfolded(referent):
    """All fields of a referent and of those to which it relates."""
    said = {**vars(referent), "parts": [unfolded(part) for part in referent.parts]}
    return {**said, "conditions": [{**vars(c), "of": [unfolded(r) for r in c.of]} for c in referent.conditions]}


@given(referents)
@settings(max_examples=300, deadline=None)
def test_any_referent_reads_back_in_all_its_fields(referent):
    written = write_referent(referent)
    again = parse_meaning(written).target
    assert unfolded(again) == unfolded(referent)
    assert write_referent(again) == written


@given(st.text(alphabet="x12 \n\"", max_size=30) | st.lists(st.sampled_from(
    ["x1", "x2", "is", "objects", "colour", "of", "not", "goal", "pick", "\n", "rank", "2", "at", "left", '"']
)).map(" ".join))  # fmt: skip
@settings(max_examples=300, deadline=None)
def test_any_text_is_a_meaning_or_refused_in_words(text):
    try:
        meaning = parse_meaning(text)
    except MeaningError as error:
        told = error
    else:
        assert parse_meaning(write(meaning))
        return
    assert told.right
    assert told.text in text


@pytest.mark.parametrize(
    ("text", "line", "says", "right"),
    [
        ("goal fly x1\nx1 is objects", 1, "'fly'", "pick"),
        ("goal pick x1", 1, "x1, of which nothing is told", "x1 is"),
        ("x1 is blocks", 1, "'blocks'", "objects"),
        ("x1 is objects\nx1 shade red", 2, "'shade'", "colour"),
        ("x1 is objects\nx1 beside x2", 1, "x2, of which", "x2 is"),
        ("x1 is objects\nx1 beside x1", 1, "itself", "without a circle"),
        ("x1 is objects\nx1 is objects", 2, "again", "one such line"),
        ("x1 colour red", 1, "before", "x1 is"),
        ("x1 is objects\nx2 is objects", 2, "nothing relates to", "a line that names it"),
        ("x1 is objects\nx1 ordinal rank two", 2, "'two'", "whole number"),
        ("x1 is objects\nx1 ordinal rank 2 loudly", 2, "'loudly'", "end of the line"),
        ('x1 is objects said "the block', 1, "open quote", "two"),
        ("goal pick\ngoal pick", 2, "twice", "one line"),
        ("the red block", 1, "'the'", "goal"),
    ],
)
def test_what_cannot_be_read_is_told(text, line, says, right):
    with pytest.raises(MeaningError, match=f"line {line} ") as refused:
        parse_meaning(text)
    assert refused.value.line == line
    assert says in str(refused.value)
    assert right in refused.value.right
    assert isinstance(refused.value, GroundingError)
