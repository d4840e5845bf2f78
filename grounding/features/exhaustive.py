"""Every symbol of Γ for a phrase, by family, as the exhaustive search of Section V-B judges them.

A symbol that adaptive inference proposes has the roles that it has there. The roles of any other symbol follow from the
same definitions: what depends on the symbol alone (its kind, its parts, its members) is asked of the same functions,
and that nothing names it is a role of its own. Subsets of objects are enumerated as masks, in ascending order.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from grounding.errors import SearchError
from grounding.features import abstract, acting, concrete
from grounding.features.blocks import NO_ROLE, Block, Slot, Space, make_space
from grounding.features.families import FAMILIES
from grounding.features.scope import Scope
from grounding.geometry.layout import Layout
from grounding.language.lexicon import known_colors
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
    ObjectSymbol,
    Ordinal,
    Region,
    Symbol,
)

MOST_THINGS = 15  # of a world whose power set is enumerated
SHAPES = tuple(kind for kind in CONTAINER_KINDS if kind != "robot")
_PROPOSE = {family.name: family.propose for family in FAMILIES}

Listed = list[tuple[Symbol, list[str]]]


def every(scope: Scope, family: str) -> Space:
    """All symbols of a family.

    Args:
        scope: the phrase, at the stage of the family.
        family: its name.

    Raises:
        SearchError: the world has so many things that their subsets cannot be listed.
    """
    if scope.layout.size > MOST_THINGS:
        raise SearchError(
            f"a world of {scope.layout.size} things has {2**scope.layout.size - 1:,} sets of things; exhaustive search "
            f"lists them for up to {MOST_THINGS} things, beyond that use adcg"
        )
    return _SPACES[family](scope, _PROPOSE[family](scope))


def _numbers(scope: Scope, proposals: Listed) -> Space:
    counted: list[Symbol] = [Cardinal(value) for value in range(1, scope.layout.size + 1)]
    return make_space(_with(proposals, concrete.judged(scope, counted)))


def _ordinals(scope: Scope, proposals: Listed) -> Space:
    ranks: list[Symbol] = [Ordinal(value) for value in (*range(1, scope.layout.size + 1), LAST)]
    return make_space(_with(proposals, concrete.judged(scope, ranks)))


def _objects(scope: Scope, proposals: Listed) -> Space:
    layout = scope.layout
    others: Listed = [
        (ObjectSymbol(name), ["in no set", *abstract.object_roles(scope, index)])
        for index, name in enumerate(layout.ids)
    ]
    others += [
        (ObjectSymbol(item.id), ["furniture unsaid"]) for item in layout.world.objects if item.id not in layout.index
    ]
    return make_space(_with(proposals, others))


def _with(proposals: Listed, others: Listed) -> Listed:
    """The proposals, and of the others those that are not proposed."""
    known = {symbol for symbol, _ in proposals}
    return [*proposals, *((symbol, roles) for symbol, roles in others if symbol not in known)]


def _attributes(scope: Scope, proposals: Listed) -> Space:
    ranks = (*range(1, scope.layout.size + 1), LAST, None)
    block = _product(ObjectAttribute, scope.layout, ranks, abstract.attribute_parts(scope), abstract.attribute_roles)
    return make_space(proposals, [block])


def _collections(scope: Scope, proposals: Listed) -> Space:
    counts = (*range(1, scope.layout.size + 1), None)
    block = _product(
        ContainerAttribute, scope.layout, counts, abstract.collection_parts(scope), abstract.collection_roles
    )
    return make_space(proposals, [block])


def _product(
    make: type[ObjectAttribute] | type[ContainerAttribute],
    layout: Layout,
    others: Sequence[int | None],
    parts: abstract.Parts,
    roles: Callable[[str, str, str, str], list[str]],
) -> Block:
    """All types x colours x relations x ranks or counts; a part that nobody says is said by "other"."""
    values: tuple[Sequence[str | int | None], ...] = (
        (*sorted(layout.types), None), (*known_colors(), None), (*SPATIAL_REFERENCES, None), others,
    )  # fmt: skip
    shape = tuple(len(column) for column in values)
    speaking: tuple[Mapping[Any, str], ...] = parts
    said = [[part.get(value, "other") for value in column] for column, part in zip(values, speaking, strict=True)]
    speakers = [sorted(set(column)) for column in said]
    combined = [roles(*who) for who in itertools.product(*speakers)]
    places = np.ix_(
        *(np.array([who.index(name) for name in column]) for column, who in zip(said, speakers, strict=True))
    )
    slots = []
    for number in range(len(combined[0])):
        names = tuple(dict.fromkeys(row[number] for row in combined))
        table = np.array([names.index(row[number]) for row in combined]).reshape([len(who) for who in speakers])
        slots.append(Slot(names, table[places]))
    places_of = [{value: i for i, value in enumerate(column)} for column in values]

    def symbol(index: int) -> Symbol:
        place = np.unravel_index(index, shape)
        return make(*(column[int(i)] for column, i in zip(values, place, strict=True)))  # type: ignore[arg-type]

    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, make):
            return None
        last = symbol.index if isinstance(symbol, ObjectAttribute) else symbol.number
        where = [
            known.get(value)
            for known, value in zip(places_of, (symbol.object_type, symbol.color, symbol.relation, last), strict=True)
        ]
        return None if None in where else int(np.ravel_multi_index([i or 0 for i in where], shape))

    return Block(shape, tuple(slots), symbol, find)


def _containers(scope: Scope, proposals: Listed) -> Space:
    layout = scope.layout
    hands = _hands(layout)
    listed = _with(proposals, [(Container("robot", hands), ["robot unsaid", "kind robot"])] if hands else [])
    if not layout.size:
        return make_space(listed)
    masks = np.arange(1, 1 << layout.size)
    counts = [abstract.count_roles(scope, count) for count in range(layout.size + 1)]
    sizes = np.bitwise_count(masks)
    strange = (masks & ~scope.fitting.wanted) != 0
    members = abstract.member_roles(scope, -1)[:1] or [NO_ROLE]  # of a set with members that are not wanted
    shared = [
        Slot(("named by nothing",), np.zeros(1, dtype=int)),
        Slot((NO_ROLE, *members), strange.astype(int)),
        *(_slot([row[number] for row in counts], sizes) for number in range(len(counts[0]))),
    ]
    blocks = []
    for kind in SHAPES:
        constant = [Slot((role,), np.zeros(1, dtype=int)) for role in abstract.kind_roles(scope, kind)]
        blocks.append(
            Block(masks.shape, (*constant, *shared), _container(layout, kind), _container_place(layout, kind))
        )
    return make_space(listed, blocks)


def _container(layout: Layout, kind: str) -> Callable[[int], Symbol]:
    return lambda index: Container(kind, layout.names(index + 1))


def _container_place(layout: Layout, kind: str) -> Callable[[Symbol], int | None]:
    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, Container) or symbol.kind != kind:
            return None
        return _mask_place(layout, symbol.objects)

    return find


def _mask_place(layout: Layout, objects: tuple[str, ...]) -> int | None:
    """The place of a set of things in the enumeration; None for the empty set and for sets with furniture."""
    if not objects or not all(name in layout.index for name in objects):
        return None
    return layout.mask(objects) - 1


def _slot(names: Sequence[str], indices: np.ndarray) -> Slot:
    """A slot whose role is found in a list of names, some of which are the same."""
    different = tuple(dict.fromkeys(names))
    return Slot(different, np.array([different.index(name) for name in names])[indices])


def _hands(layout: Layout) -> tuple[str, ...]:
    return tuple(item.id for item in layout.world.objects if item.type == "robot")


def _regions(scope: Scope, proposals: Listed) -> Space:
    layout = scope.layout
    relations = acting.region_relations(scope)
    references = {(kind, objects): how for kind, objects, how in acting.region_references(scope)}
    fixed: list[tuple[str, tuple[str, ...]]] = [
        ("object", (item.id,)) for item in layout.world.objects if item.id not in layout.index
    ]
    fixed += [("robot", _hands(layout))] if _hands(layout) else []
    others: Listed = [
        (Region(relation, kind, objects),
         acting.region_roles(relation, relations.get(relation, "nobody"), kind,
                             references.get((kind, objects), "of nothing said")))
        for relation in SPATIAL_REFERENCES
        for kind, objects in fixed
    ]  # fmt: skip
    listed = _with(proposals, others)
    if not layout.size:
        return make_space(listed)
    return make_space(listed, [_region_block(layout, kind, relations, references) for kind in ("object", *SHAPES)])


def _region_block(
    layout: Layout, kind: str, relations: dict[str, str], references: dict[tuple[str, tuple[str, ...]], str]
) -> Block:
    """The regions of all sets of things as a container of a kind, or as mere objects."""
    shape = len(SPATIAL_REFERENCES), (1 << layout.size) - 1
    hows = ["of nothing said"]
    how_of = np.zeros(shape[1], dtype=int)
    for (other, objects), how in references.items():
        place = _mask_place(layout, objects)
        if other == kind and place is not None:
            hows.append(how)
            how_of[place] = len(hows) - 1
    rows = [
        [acting.region_roles(relation, relations.get(relation, "nobody"), kind, how) for how in hows]
        for relation in SPATIAL_REFERENCES
    ]
    which = np.arange(shape[0])[:, None]
    slots = []
    for number in range(len(rows[0][0])):
        names = tuple(dict.fromkeys(row[number] for by_how in rows for row in by_how))
        table = np.array([[names.index(row[number]) for row in by_how] for by_how in rows])
        by_relation, by_how = (table == table[:, :1]).all(), (table == table[:1]).all()
        slots.append(Slot(names, table[:, :1] if by_relation else table[0][how_of] if by_how else table[which, how_of]))
    lone = np.zeros(shape, dtype=np.int8)
    lone[SPATIAL_REFERENCES.index("between"), (1 << np.arange(layout.size)) - 1] = 1
    slots.append(Slot((NO_ROLE, "between one"), lone))

    def symbol(index: int) -> Symbol:
        relation, place = divmod(index, shape[1])
        return Region(SPATIAL_REFERENCES[relation], kind, layout.names(place + 1))

    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, Region) or symbol.kind != kind:
            return None
        place = _mask_place(layout, symbol.objects)
        return None if place is None else SPATIAL_REFERENCES.index(symbol.relation) * shape[1] + place

    return Block(shape, tuple(slots), symbol, find)


def _actions(scope: Scope, proposals: Listed) -> Space:
    """Every kind of action on every set of things, without a destination or to a region of one object."""
    layout = scope.layout
    if not layout.size:
        return make_space(proposals)
    things = [item.id for item in layout.world.objects]
    destinations: list[Region | None] = [None]
    destinations += [Region(relation, "object", (name,)) for relation in SPATIAL_REFERENCES for name in things]
    named = dict(acting.action_destinations(scope))
    whence = [named.get(region, "to a region unsaid") for region in destinations]
    hows = ["on nothing said"]
    how_of = np.zeros((1 << layout.size) - 1, dtype=int)
    for objects, how in acting.action_targets(scope, scope.source("object")):
        place = _mask_place(layout, objects)
        if place is not None:
            hows.append(how)
            how_of[place] = len(hows) - 1
    said = {action.kind for action in scope.own.actions}
    blocks = [_action_block(layout, kind, kind in said, destinations, whence, hows, how_of) for kind in ACTION_KINDS]
    return make_space(proposals, blocks)


def _action_block(
    layout: Layout,
    kind: str,
    said: bool,
    destinations: list[Region | None],
    whence: list[str],
    hows: list[str],
    how_of: np.ndarray,
) -> Block:
    shape = len(how_of), len(destinations) if kind == "place" else 1
    to = np.arange(shape[1])
    pairs = [f"{how}|{where}" for how in hows for where in whence]
    slots = (
        Slot((f"kind {kind}" if said else "kind unsaid",), np.zeros((1, 1), dtype=int)),
        _slot(hows, how_of[:, None]),
        _slot(whence, to[None]),
        _slot(pairs, how_of[:, None] * len(whence) + to[None]),
        _slot([f"{kind}|{where}" for where in whence], to[None]),
    )
    places = {region: i for i, region in enumerate(destinations)}

    def symbol(index: int) -> Symbol:
        objects, place = divmod(index, shape[1])
        return Action(kind, layout.names(objects + 1), destinations[place])

    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, Action) or symbol.kind != kind:
            return None
        objects, place = _mask_place(layout, symbol.objects), places.get(symbol.destination, shape[1])
        return None if objects is None or place >= shape[1] else objects * shape[1] + place

    return Block(shape, slots, symbol, find)


def _as_proposed(scope: Scope, proposals: Listed) -> Space:
    """Families whose members are all proposed for every phrase."""
    return make_space(proposals)


_SPACES: dict[str, Callable[[Scope, Listed], Space]] = {
    "type": _as_proposed,
    "color": _as_proposed,
    "spatial": _as_proposed,
    "cardinal": _numbers,
    "ordinal": _ordinals,
    "kind": _as_proposed,
    "verb": _as_proposed,
    "object": _objects,
    "attribute": _attributes,
    "collection": _collections,
    "container": _containers,
    "region": _regions,
    "action": _actions,
}
