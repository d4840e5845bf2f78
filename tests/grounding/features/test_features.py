"""Features: what is proposed and in which roles depends on how things stand, not on what they are called."""

import functools

import numpy as np
import pytest

import models
from grounding.features import FAMILIES, STAGES, Scope, family_of
from grounding.features.context import context_facts
from grounding.features.sources import NOTHING, child_roles, digest, merge
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of
from grounding.language.tree import from_brackets
from grounding.symbols import (
    ACTION_KINDS,
    CONTAINER_KINDS,
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
    parse_symbols,
)
from grounding.world import World, load_world, make_object

CASES = (  # a phrase, its children's symbols, its own concrete symbols
    ("(NP (DT the) (JJS nearest) (JJ red) (NN block))", (), "type(block) color(red) spatial(near)"),
    ("(NP (DT the) (CD two) (NNS blocks))", (), "type(block) cardinal(2)"),
    ("(NP (DT the) (NN row))", (), "container(row)"),
    ("(NP (NP (DT the) (JJ second) (NN block)) (PP (IN from) (NP (DT the) (NN left))))",
     ("attribute(block, -, -, 2)", "spatial(left)"), ""),
    ("(PP (IN behind) (NP (DT the) (NN block)))", ("object(b2)",), "spatial(back)"),
    ("(VP (VB take) (NP (DT the) (NN block)))", ("attribute(block, red, -, -)",), "action(pick)"),
    ("(VP (VB put) (NP (DT the) (NN block)) (PP (IN on) (NP (DT the) (NN block))))",
     ("object(b1)", "region(top, object; b4)"), "action(place)"),
)  # fmt: skip
cases = pytest.mark.parametrize("case", CASES, ids=[case[0] for case in CASES])


@functools.cache
def layout_of(name):
    return Layout(load_world(models.SCENES / f"{name}.json"))


def unsettled(case, layout):
    text, children, _ = case
    return Scope(from_brackets(text)[0], [parse_symbols(symbols) for symbols in children], layout)


def scope_of(case, layout):
    return unsettled(case, layout).with_concrete(parse_symbols(case[2]))


def proposals(scope):
    return {symbol: frozenset(roles) for stage in STAGES for family in stage for symbol, roles in family.propose(scope)}


def test_families_come_once_and_in_stages():
    names = [family.name for family in FAMILIES]
    assert len(set(names)) == len(names)
    assert [family for stage in STAGES for family in stage] == sorted(FAMILIES, key=lambda family: family.stage)


@pytest.mark.parametrize("name", ["four", "seven", "tower"])
@cases
def test_families_propose_their_own_symbols_once(case, name):
    scope = scope_of(case, layout_of(name))
    for family in FAMILIES:
        found = family.propose(scope)
        assert len({symbol for symbol, _ in found}) == len(found)
        assert all(family_of(symbol) == family.name for symbol, _ in found)
        assert all(isinstance(role, str) for _, roles in found for role in roles)
        assert found == family.propose(scope_of(case, layout_of(name)))


@cases
def test_facts_are_the_same_every_time(case):
    first, settled = context_facts(unsettled(case, layout_of("four"))), context_facts(scope_of(case, layout_of("four")))
    assert first == context_facts(unsettled(case, layout_of("four")))
    assert settled == context_facts(scope_of(case, layout_of("four")))
    assert "bias" in first
    assert set(first) <= set(settled)


def renamed(symbol, names):
    match symbol:
        case ObjectSymbol(name):
            return ObjectSymbol(names.get(name, name))
        case Container(kind, ids):
            return Container(kind, tuple(names.get(i, i) for i in ids))
        case Region(relation, kind, ids):
            return Region(relation, kind, tuple(names.get(i, i) for i in ids))
        case Action(kind, ids, destination):
            place = destination and renamed(destination, names)
            return Action(kind, tuple(names.get(i, i) for i in ids), place)
    return symbol


@pytest.mark.parametrize("name", ["four", "seven"])
@cases
def test_names_of_objects_say_nothing(case, name):
    world = layout_of(name).world
    ids = [item.id for item in world.things]
    order = np.random.default_rng(3).permutation(len(ids))
    names = {old: f"z{new}" for old, new in zip(ids, order, strict=True)}
    objects = [make_object(names.get(o.id, o.id), o.type, o.color, o.position, o.orientation, o.size)
               for o in reversed(world.objects)]  # fmt: skip
    scope = scope_of(case, Layout(world))
    text, children, own = case
    other = Scope(
        from_brackets(text)[0],
        [frozenset(renamed(s, names) for s in parse_symbols(symbols)) for symbols in children],
        Layout(World(tuple(objects))),
    ).with_concrete(parse_symbols(own))
    assert {renamed(symbol, names): roles for symbol, roles in proposals(scope).items()} == proposals(other)
    assert set(context_facts(scope)) == set(context_facts(other))


@cases
def test_an_empty_world_has_facts_and_proposes_no_objects(case):
    scope = scope_of((case[0], tuple("" for _ in case[1]), case[2]), Layout(World(())))
    assert context_facts(scope)
    assert not any(getattr(symbol, "objects", ()) for symbol in proposals(scope))


def test_the_closed_classes_are_judged_for_every_phrase():
    found = proposals(scope_of(CASES[0], layout_of("four")))
    assert {SpatialReference(name) for name in SPATIAL_REFERENCES} <= set(found)
    assert {Container(kind) for kind in CONTAINER_KINDS} <= set(found)
    assert {Action(kind) for kind in ACTION_KINDS} <= set(found)
    assert "named" in found[SpatialReference("near")]
    assert "not named" in found[SpatialReference("far")]


def test_the_nearest_one_of_a_colour_is_proposed_as_that():
    layout = layout_of("four")
    found = proposals(scope_of(CASES[0], layout))
    reds = [layout.ids[i] for i in indices_of(layout.matching("block", "red"))]
    nearest = min(reds, key=lambda name: np.hypot(*layout.world[name].position[:2]))
    roles = {symbol.id: roles for symbol, roles in found.items() if isinstance(symbol, ObjectSymbol)}
    assert set(reds) <= set(roles)
    own = {name for name in roles if any(role.startswith("nth[all|own|") for role in roles[name])}
    assert own == {nearest}


def test_what_parts_say_is_sorted_by_kind():
    layout = layout_of("four")
    symbols = parse_symbols(
        "type(block) color(red) spatial(left) ordinal(2) cardinal(3) container(row) container(group; b1 b2) object(b3) "
        "object(table) region(left, object; b1) attribute(block, blue, near, 1) "
        "collection(block, -, far, 4) action(pick)"
    )
    source = digest(symbols, layout)
    assert source.symbols == symbols
    assert layout.names(source.objects) == ("b3",)
    assert source.furniture == ("table",)
    assert set(source.colors) == {"red", "blue"}
    assert set(source.relations) == {"left", "near", "far"}
    assert set(source.numbers) == {3, 4}
    assert source.kinds == ("row",)
    assert [(kind, layout.names(mask)) for kind, mask in source.containers] == [("group", ("b1", "b2"))]
    assert source.regions == (Region("left", "object", ("b1",)),)
    assert source.attributes == (ObjectAttribute("block", "blue", "near", 1),)
    assert source.collections == (ContainerAttribute("block", None, "far", 4),)
    assert source.actions == (Action("pick"),)
    assert digest(frozenset(), layout) == NOTHING
    assert merge([digest(frozenset({s}), layout) for s in sorted(symbols, key=str)], layout) == source
    assert {Cardinal(3), Ordinal(2), ObjectColor("red"), ObjectType("block")} <= source.symbols


@pytest.mark.parametrize(
    ("text", "roles"),
    [
        ("(VP (VB put) (PRT (RP up)) (NP (NN block)) (PP (IN on) (NP (NN block))))", ("prt", "object", "dest")),
        ("(NP (NP (NN block)) (PP (IN on) (NP (NN block))))", ("head", "mod")),
        ("(NP (NP (NN block)) (CC and) (NP (NN block)))", ("part", "part")),
        ("(PP (IN on) (NP (NN block)))", ("inner",)),
        ("(NP (NN block))", ()),
    ],
)
def test_children_have_roles(text, roles):
    assert child_roles(from_brackets(text)[0]) == roles
