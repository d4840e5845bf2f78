"""Symbols: values that are written and read back, in one order everywhere; anything else is refused by name."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.errors import SymbolError
from grounding.symbols import (
    ACTION_KINDS,
    CONTAINER_KINDS,
    LAST,
    SPATIAL_REFERENCES,
    Action,
    Cardinal,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectColor,
    ObjectSymbol,
    ObjectType,
    Ordinal,
    Region,
    SpatialReference,
    format_symbols,
    parse_symbol,
    parse_symbols,
    symbol_json,
    symbol_key,
)

ids = st.text(st.characters(codec="utf-8", exclude_characters="(){};,-", categories=("L", "N", "P")), min_size=1)
several = st.lists(ids, max_size=5, unique=True).map(tuple)
relations = st.sampled_from(SPATIAL_REFERENCES)
numbers = st.integers(LAST, 40)


def maybe(strategy):
    return st.none() | strategy


regions = st.builds(Region, relations, st.sampled_from(("object", *CONTAINER_KINDS)), several)
symbols = st.one_of(
    st.builds(ObjectSymbol, ids),
    st.builds(ObjectType, ids),
    st.builds(ObjectColor, ids),
    st.builds(SpatialReference, relations),
    st.builds(Cardinal, numbers),
    st.builds(Ordinal, numbers),
    st.builds(Container, st.sampled_from(CONTAINER_KINDS), several),
    st.builds(ObjectAttribute, maybe(ids), maybe(ids), maybe(relations), maybe(numbers)),
    st.builds(ContainerAttribute, maybe(ids), maybe(ids), maybe(relations), maybe(numbers)),
    regions,
    st.builds(Action, st.sampled_from(ACTION_KINDS), several, maybe(regions)),
)


@given(symbols)
def test_what_is_written_is_read(symbol):
    assert parse_symbol(str(symbol)) == symbol
    assert parse_symbol(f"  {symbol} ") == symbol


@given(st.frozensets(symbols, max_size=6))
def test_sets_are_written_in_one_order_and_read(chosen):
    text = format_symbols(chosen)
    assert parse_symbols(text) == chosen
    assert text == format_symbols(sorted(chosen, key=symbol_key, reverse=True))


@given(symbols)
def test_symbols_are_plain_json(symbol):
    data = symbol_json(symbol)
    assert json.loads(json.dumps(data)) == data
    assert isinstance(data["symbol"], str)


@given(several)
def test_the_order_of_members_says_nothing(members):
    turned = members[::-1]
    assert Container("row", members) == Container("row", turned)
    assert hash(Action("pick", members)) == hash(Action("pick", turned))
    assert Region("left", "object", members) == Region("left", "object", turned)


@pytest.mark.parametrize(
    "text",
    [
        "", "row", "object(b1", "(object b1)", "object(b1) object(b2)", "object()", "object(b 3)", "foo(b1)",
        "container()", "container(heap)", "container(row; b1; b2)", "container(; b1)", "spatial(up)", "cardinal(five)",
        "ordinal()", "attribute(block, red)", "attribute(block, red, left, x)", "collection(block, , left, 2)",
        "region(left, object)", "region(left; b1)", "region(up, object; b1)", "region(left, heap; b1)", "action(jump)",
        "action(pick; b1; left)", "action(place; b1; left; b2)", "action(; b1)", "OBJECT(b1)",
    ],
)  # fmt: skip
def test_other_notation_is_refused_by_name(text):
    with pytest.raises(SymbolError) as refusal:
        parse_symbol(text)
    assert repr(text) in str(refusal.value)


def test_rubbish_between_symbols_is_refused():
    with pytest.raises(SymbolError, match="no symbol at 'and object"):
        parse_symbols("object(b1) and object(b2)")


@pytest.mark.parametrize(
    "build",
    [
        lambda: SpatialReference("up"), lambda: Container("heap"), lambda: Region("up", "object", ("b1",)),
        lambda: Region("left", "heap", ("b1",)), lambda: Action("jump"),
    ],
)  # fmt: skip
def test_unknown_kinds_are_refused_with_the_known_ones(build):
    with pytest.raises(SymbolError, match="known are"):
        build()


def test_the_notation_of_the_manual():
    for text in (
        "object(b3)", "type(block)", "color(red)", "spatial(left)", "cardinal(5)", "ordinal(3)", "container(row)",
        "container(row; b1 b2 b3)", "attribute(block, red, left, 3)", "collection(block, red, -, 5)",
        "region(right, object; b3)", "region(left, row; b1 b2 b3)", "action(pick; b3)",
        "action(place; b3; right, object; b7)",
    ):  # fmt: skip
        assert str(parse_symbol(text)) == text
