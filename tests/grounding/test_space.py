"""Γ: sizes in closed form are what the enumeration counts, and what people annotate is in it."""

import itertools
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grounding.corpus.loading import load_corpus
from grounding.enumeration import enumerate_containers, subsets
from grounding.errors import SymbolError
from grounding.geometry.layout import Layout
from grounding.language.lexicon import known_words, meanings
from grounding.space import (
    COUNTED,
    FIXED,
    KINDS,
    NUMBER_WORDS,
    SHORTHANDS,
    Counts,
    SymbolSpace,
    total,
)
from grounding.symbols import Cardinal, Container, ObjectColor, ObjectType, Ordinal, parse_symbol
from grounding.world import ROBOT_VIEWPOINT, World, make_object

BY_NAME = {kind.name: kind for kind in KINDS}


def space_of(objects, types=1, colors=1, furniture=0, hands=0):
    others = [f"hand{i}" for i in range(hands)] + [f"table{i}" for i in range(furniture)]
    return SymbolSpace(
        tuple(f"b{i}" for i in range(objects)),
        tuple(f"type{i}" for i in range(types)),
        tuple(f"color{i}" for i in range(colors)),
        tuple(others),
        tuple(others[:hands]),
    )


@settings(max_examples=25)
@given(st.integers(0, 5), st.integers(0, 3), st.integers(0, 4), st.integers(0, 2), st.integers(0, 3))
def test_formula_and_enumeration_agree_and_nothing_is_listed_twice(objects, types, colors, furniture, hands):
    space = space_of(objects, types, colors, furniture, hands)
    for kind in KINDS:
        symbols = list(kind.symbols(space))
        assert len(symbols) == kind.size(space.counts), kind.name
        assert len(set(symbols)) == len(symbols), kind.name
    assert sum(1 for _ in space) == total(space.counts)


@pytest.mark.parametrize("objects", [6, 7, 8, 9, 10])
def test_formula_and_enumeration_agree_up_to_ten_objects(objects):
    space = space_of(objects, 2, 5, 1, 2)
    for kind in KINDS:
        if kind.name != "placings of sets" or objects <= 8:
            assert sum(1 for _ in kind.symbols(space)) == kind.size(space.counts), kind.name


def test_placings_of_ten_objects_counted_by_sets_alone():
    """Every pair of a set and a region without any of it, and every set to what is beside itself."""
    count, directions, references, arrangements = 10, 9, 10, 5
    pairs = 0
    for mask in range(1 << count):
        outside = (1 << count - mask.bit_count()) - 1
        if mask.bit_count() == 1:
            pairs += directions * (outside + 1)
        elif mask:
            pairs += references * (outside + arrangements * outside + 1)
    pairs += directions * ((1 << count) - 1)  # before the robot and so on
    assert BY_NAME["placings of sets"].size(Counts(count)) == pairs


@given(st.integers(0, 60), st.integers(0, 20), st.integers(0, 20), st.integers(0, 3), st.integers(0, 3))
def test_the_formula_that_is_shown_is_the_one_that_is_computed(objects, types, colors, furniture, hands):
    counts = Counts(objects, types, colors, furniture + hands, hands, max(objects, NUMBER_WORDS))
    values = {letter: getattr(counts, name) for letter, name in COUNTED.items()} | FIXED
    values["B"] = BY_NAME["regions of the robot"].size(counts)

    def value(formula):
        python = re.sub(r"(?<=[\w)]) (?=[\w(])", " * ", formula.replace("^", "**"))
        if "**(N-1)" in python and not values["N"]:
            python = re.sub(r"N \* 2\*\*\(N-1\)", "0", python)
        return eval(python, {}, values)

    for letter, (formula, _) in SHORTHANDS.items():
        values[letter] = value(formula)
    for kind in KINDS:
        if " if " not in kind.formula:
            assert value(kind.formula) == kind.size(counts), kind.name


@settings(max_examples=10)
@given(st.integers(0, 3), st.integers(0, 2), st.integers(0, 2))
def test_a_symbol_is_in_the_space_where_it_is_among_the_enumerated(objects, furniture, hands):
    """Of the symbols of a larger space too, most of which are not."""
    space = space_of(objects, 1, 1, furniture, hands)
    listed = frozenset(space)
    larger = space_of(4, 2, 1, 2, 3)
    for symbol in itertools.chain(
        larger,
        [
            Cardinal(0),
            Cardinal(21),
            Ordinal(-2),
            Ordinal(21),
            parse_symbol("action(pick; b0; left, object; b1)"),
            parse_symbol("container(row; b0)"),
            parse_symbol("action(place; b0)"),
            parse_symbol("container(row; b0 b0)"),
            parse_symbol("container(group; b0 hand0)"),
            parse_symbol("action(place; b0 b1; left, object; b0)"),
        ],
    ):
        assert (symbol in space) == (symbol in listed), symbol
    assert all(symbol in space for symbol in listed)
    assert "b0" not in space


def test_subsets_come_in_the_order_of_their_masks():
    assert list(subsets("abc")) == [("a",), ("b",), ("a", "b"), ("c",), ("a", "c"), ("b", "c"), ("a", "b", "c")]
    assert list(subsets("ab", 2)) == [("a", "b")]
    assert list(subsets("", 0)) == [()]


def test_symbols_are_made_when_they_are_asked_for():
    first = list(itertools.islice(enumerate_containers([f"b{i}" for i in range(200)]), 6))
    assert first[0] == Container("row", ("b0", "b1"))
    assert {symbol.objects for symbol in first[:5]} == {("b0", "b1")}
    assert first[5].objects == ("b0", "b2")


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_examples_are_of_their_kind(kind):
    symbol = parse_symbol(kind.example)
    assert isinstance(symbol, type(next(iter(kind.symbols(space_of(2, hands=1))))))


def test_numbers_go_as_far_as_words_do():
    spoken = {symbol for word in known_words() for symbol in meanings(word)}
    assert max(s.value for s in spoken if isinstance(s, Cardinal)) == NUMBER_WORDS
    assert max(s.value for s in spoken if isinstance(s, Ordinal)) == NUMBER_WORDS
    assert space_of(3).numbers == NUMBER_WORDS
    assert space_of(30).numbers == 30


def test_what_is_annotated_is_in_the_space():
    """Every symbol that is true of some phrase of the treebank is one of Γ.

    But for the region of "the yellow blocks" where there is one yellow block: the annotation makes it a group of one.
    """
    corpus = load_corpus(None)
    words = {symbol for word in known_words() for symbol in meanings(word)}
    types = [s.name for s in words if isinstance(s, ObjectType)]
    colors = [s.name for s in words if isinstance(s, ObjectColor)]
    spaces = {name: SymbolSpace.of_world(world, types, colors) for name, world in corpus.worlds.items()}
    outside = [(example.id, str(symbol)) for example in corpus.examples for symbols in example.groundings
               for symbol in symbols if symbol not in spaces[example.world]]  # fmt: skip
    assert len(corpus.examples) > 1000
    assert [entry for entry in outside if not entry[0].startswith("t00707-")] == []


def test_a_world_tells_what_there_is():
    world = World(
        (
            make_object("b2", "block", "unknown"),
            make_object("b1", "cup", "red", (0.2, 0, 0)),
            make_object("left_hand", "robot", "black", (0, 0.5, 1)),
            make_object("table", "table", "white", (1, 0, 0)),
        ),
        ROBOT_VIEWPOINT,
    )
    space = SymbolSpace.of_world(world, ("block",), ("green",))
    assert space.objects == Layout(world).ids == ("b1", "b2")
    assert space.furniture == ("left_hand", "table")
    assert space.hands == ("left_hand",)
    assert space.types == ("block", "cup", "robot", "table")
    assert space.colors == ("black", "green", "red", "white")


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: SymbolSpace(("a", "a")), "objects: 'a' occurs twice"),
        (lambda: SymbolSpace.of_size(2, ("block", "block")), "types: 'block' occurs twice"),
        (lambda: SymbolSpace(("a",), hands=("h",)), "hands h are not among the furniture"),
    ],
)
def test_what_makes_no_space_is_refused(make, says):
    with pytest.raises(SymbolError, match=says):
        make()


def test_the_published_size_follows_from_the_published_rule():
    """docs/space.md: nineteen alike and one other, three arrangements and their regions in ten directions."""

    def by_rule(alike):  # one symbol after another, as the authors' exhaustive program lists them
        sets = sum(1 for mask in range(1 << alike) if mask.bit_count() > 1)
        return sum(1 + 10 for _ in range(3)) * sets

    assert [by_rule(n) for n in range(8)] == [33 * (2**n - n - 1) for n in range(8)]
    assert by_rule(19) == 33 * (2**19 - 20) == 17_300_844
    per_set = {n: (17.25e6 / (2**n - n - 1), 17.35e6 / (2**n - n - 1)) for n in (18, 19, 20)}
    whole = {n: [k for k in range(1, 100) if low <= k < high] for n, (low, high) in per_set.items()}
    assert whole == {18: [66], 19: [33], 20: []}
