"""All object attributes Π_O and container attributes Π_η for a phrase: every combination of their parts."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from grounding.features import attributes
from grounding.features.blocks import Block, Space, make_slot, make_space
from grounding.features.scope import Scope
from grounding.language.lexicon import known_colors
from grounding.space import UNKNOWN, largest_number
from grounding.symbols import LAST, SPATIAL_REFERENCES, ContainerAttribute, ObjectAttribute, Symbol

_NOBODY = "other"  # who says a part that nobody says

Listed = list[tuple[Symbol, list[str]]]


def every_attribute(scope: Scope, proposals: Listed) -> Space:
    """Types x colours x relations x ranks."""
    ranks = (None, *range(1, largest_number(scope.layout.size) + 1), LAST)
    block = _product(ObjectAttribute, scope, ranks, attributes.attribute_parts(scope), attributes.attribute_roles)
    return make_space(proposals, [block])


def every_collection(scope: Scope, proposals: Listed) -> Space:
    """Types x colours x relations x counts."""
    counts = (None, *range(1, largest_number(scope.layout.size) + 1))
    block = _product(ContainerAttribute, scope, counts, attributes.collection_parts(scope), attributes.collection_roles)
    return make_space(proposals, [block])


def _product(
    make: type[ObjectAttribute] | type[ContainerAttribute],
    scope: Scope,
    last: Sequence[int | None],
    parts: attributes.Parts,
    roles: Callable[[str, str, str, str], list[str]],
) -> Block:
    """All combinations of parts, in the order of `grounding.space`."""
    types = sorted({*scope.layout.types, *scope.own.types})
    colors = sorted({*known_colors(), *scope.layout.colors} - {UNKNOWN})
    values: tuple[Sequence[Any], ...] = ((None, *types), (None, *colors), (None, *SPATIAL_REFERENCES), last)
    shape = tuple(len(column) for column in values)
    speaking: tuple[Mapping[Any, str], ...] = parts
    said = [[part.get(value, _NOBODY) for value in column] for column, part in zip(values, speaking, strict=True)]
    speakers = [sorted(set(column)) for column in said]
    combined = [roles(*who) for who in itertools.product(*speakers)]
    axes = [np.array([who.index(name) for name in column]) for column, who in zip(said, speakers, strict=True)]
    which = np.ravel_multi_index(np.ix_(*axes), [len(who) for who in speakers])
    slots = tuple(make_slot([row[number] for row in combined], which) for number in range(len(combined[0])))
    places = [{value: i for i, value in enumerate(column)} for column in values]

    def symbol(index: int) -> Symbol:
        chosen = [column[int(i)] for column, i in zip(values, np.unravel_index(index, shape), strict=True)]
        return make(*chosen)

    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, ObjectAttribute | ContainerAttribute) or type(symbol) is not make:
            return None
        rank = symbol.index if isinstance(symbol, ObjectAttribute) else symbol.number
        asked = (symbol.object_type, symbol.color, symbol.relation, rank)
        where = [known[value] for known, value in zip(places, asked, strict=True) if value in known]
        return int(np.ravel_multi_index(where, shape)) if len(where) == len(shape) else None

    return Block(shape, slots, symbol, find)
