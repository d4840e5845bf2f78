"""Attributes of objects and of collections: what is proposed for a phrase, and in which roles."""

from __future__ import annotations

import itertools
from typing import NamedTuple

from grounding.features.scope import Scope
from grounding.symbols import ContainerAttribute, ObjectAttribute, Symbol

Proposals = list[tuple[Symbol, list[str]]]


class Parts(NamedTuple):
    """What an attribute can be made of, with who says each part; `others` are its ranks or its counts."""

    types: dict[str | None, str]
    colors: dict[str | None, str]
    relations: dict[str | None, str]
    others: dict[int | None, str]


NO_PARTS = Parts({}, {}, {}, {})


def attributes(scope: Scope) -> Proposals:
    """Object attributes from what the phrase, its head and its modifiers speak of, and those of the children."""
    parts = attribute_parts(scope)
    found: dict[ObjectAttribute, list[str]] = {}
    for t, c, r, i in itertools.product(*parts):
        found[ObjectAttribute(t, c, r, i)] = attribute_roles(
            parts.types[t], parts.colors[c], parts.relations[r], parts.others[i]
        )
    for role, source in scope.child_sources.items():
        for attribute in source.attributes:
            found.setdefault(attribute, []).append(f"is {role}")
    return list(found.items())


def attribute_roles(type_: str, color: str, relation: str, index: str) -> list[str]:
    """Roles of an object attribute, from who says its parts."""
    return [f"type {type_}", f"color {color}", f"relation {relation}", f"index {index}", f"ranks {relation}|{index}"]


def attribute_parts(scope: Scope) -> Parts:
    """All types, colours, relations and indices that object attributes can be made of."""
    own, head, mod = scope.own, scope.source("head"), scope.source("mod")
    if not (own.types or head.attributes):
        return NO_PARTS
    heads = head.attributes[0] if head.attributes else None
    types: dict[str | None, str] = {}
    colors: dict[str | None, str] = {}
    relations: dict[str | None, str] = {}
    indices: dict[int | None, str] = {}
    for value in own.types:
        types.setdefault(value, "own")
    for value in own.colors:
        colors.setdefault(value, "own")
    for value in own.relations:
        relations.setdefault(value, "own")
    for index in own.indices:
        indices.setdefault(index, "own")
    if heads is not None:
        types.setdefault(heads.object_type, "head")
        colors.setdefault(heads.color, "head")
        relations.setdefault(heads.relation, "head")
        indices.setdefault(heads.index, "head")
    for value in mod.relations:
        relations.setdefault(value, "mod")
    for index in mod.indices:
        indices.setdefault(index, "mod")
    colors.setdefault(None, "unsaid" if colors else "none")
    relations.setdefault(None, "unsaid" if relations else "none")
    indices.setdefault(1, "first")
    indices.setdefault(None, "none" if len(indices) == 1 else "unsaid")
    return Parts(types, colors, relations, indices)


def collections(scope: Scope) -> Proposals:
    """Container attributes from what the phrase and its head speak of, and those of the children."""
    parts = collection_parts(scope)
    found: dict[ContainerAttribute, list[str]] = {}
    for t, c, r, n in itertools.product(*parts):
        found[ContainerAttribute(t, c, r, n)] = collection_roles(
            parts.types[t], parts.colors[c], parts.relations[r], parts.others[n]
        )
    for role, source in scope.child_sources.items():
        for collection in source.collections:
            found.setdefault(collection, []).append(f"is {role}")
    return list(found.items())


def collection_roles(type_: str, color: str, relation: str, number: str) -> list[str]:
    """Roles of a container attribute, from who says its parts."""
    return [f"type {type_}", f"color {color}", f"relation {relation}", f"number {number}",
            f"all {type_}|{color}|{relation}|{number}"]  # fmt: skip


def collection_parts(scope: Scope) -> Parts:
    """All types, colours, relations and counts that container attributes can be made of."""
    own = scope.own
    if not (own.types or own.numbers or scope.plural or scope.universal):
        return NO_PARTS
    types: dict[str | None, str] = dict.fromkeys(own.types, "own")
    colors: dict[str | None, str] = dict.fromkeys(own.colors, "own")
    relations: dict[str | None, str] = dict.fromkeys(own.relations, "own")
    numbers: dict[int | None, str] = dict.fromkeys(own.numbers, "own")
    types.setdefault(None, "unsaid" if types else "none")
    colors.setdefault(None, "unsaid" if colors else "none")
    relations.setdefault(None, "unsaid" if relations else "none")
    if not numbers:
        numbers.setdefault(scope.sets.base.bit_count(), "counted")
    numbers.setdefault(None, "unsaid" if own.numbers else "none")
    return Parts(types, colors, relations, numbers)
