"""Objects, attributes, collections and containers: what is proposed for a phrase, and in which roles."""

from __future__ import annotations

import itertools

from grounding.features.scope import Scope
from grounding.geometry.masks import indices_of
from grounding.symbols import Container, ContainerAttribute, ObjectAttribute, ObjectSymbol, ObjectType, Symbol

Proposals = list[tuple[Symbol, list[str]]]

_CHILDREN = ("head", "mod", "inner", "object", "dest", "subject", "part")


def objects(scope: Scope) -> Proposals:
    """Every object that is in some named set; an object's roles are the sets it is in."""
    layout = scope.layout
    proposals: Proposals = []
    members: dict[int, list[str]] = {index: list(names) for index, names in scope.sets.of_object.items()}
    if scope.fitting.kinds:
        for (_, mask), fits in scope.fitting.named.items():
            for index in indices_of(mask):
                members.setdefault(index, []).extend(f"member {name}" for name in fits)
    for _, mask in scope.own_abstract.containers:
        for index in indices_of(mask):
            members.setdefault(index, [])
    for index, names in sorted(members.items()):
        roles = list(dict.fromkeys(names))
        roles += [f"in own {kind}" for kind, mask in scope.own_abstract.containers if mask >> index & 1]
        for role, source in scope.child_sources.items():
            if source.objects >> index & 1:
                roles.append(f"in {role}")
                if source.objects & (source.objects - 1) == 0:
                    roles.append(f"is {role}")
        proposals.append((ObjectSymbol(layout.ids[index]), roles))
    furniture: dict[str, list[str]] = {name: ["furniture of own container"] for name in scope.own_abstract.hands}
    for role, source in scope.child_sources.items():
        for name in source.furniture:
            furniture.setdefault(name, []).append(f"furniture of {role}")
    for item in layout.world.objects:
        if item.id not in layout.index and item.type in scope.own.types:
            furniture.setdefault(item.id, []).append("furniture of own type")
        if item.id not in layout.index and ObjectType(item.type) in scope.named:
            furniture.setdefault(item.id, []).append("furniture named")
    proposals += [(ObjectSymbol(name), roles) for name, roles in sorted(furniture.items())]
    return proposals


def attributes(scope: Scope) -> Proposals:
    """Object attributes from what the phrase, its head and its modifiers speak of, and those of the children."""
    found: dict[ObjectAttribute, list[str]] = {}
    for symbol, types_, colors_, relations_, indices_ in _combinations(scope):
        attribute = ObjectAttribute(symbol[0], symbol[1], symbol[2], symbol[3])
        found[attribute] = [f"type {types_}", f"color {colors_}", f"relation {relations_}", f"index {indices_}",
                            f"ranks {relations_}|{indices_}"]  # fmt: skip
    for role, source in scope.child_sources.items():
        for attribute in source.attributes:
            found.setdefault(attribute, []).append(f"is {role}")
    return list(found.items())


def _combinations(
    scope: Scope,
) -> list[tuple[tuple[str | None, str | None, str | None, int | None], str, str, str, str]]:
    """All (type, colour, relation, index) that can be made of what is said, with who says each part."""
    own, head, mod = scope.own, scope.source("head"), scope.source("mod")
    if not (own.types or head.attributes):
        return []
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
    return [
        ((t, c, r, i), types[t], colors[c], relations[r], indices[i])
        for t, c, r, i in itertools.product(types, colors, relations, indices)
    ]


def collections(scope: Scope) -> Proposals:
    """Container attributes from what the phrase and its head speak of, and those of the children."""
    own = scope.own
    found: dict[ContainerAttribute, list[str]] = {}
    if own.types or own.numbers or scope.plural or scope.universal:
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
        for t, c, r, n in itertools.product(types, colors, relations, numbers):
            found[ContainerAttribute(t, c, r, n)] = [
                f"type {types[t]}", f"color {colors[c]}", f"relation {relations[r]}", f"number {numbers[n]}",
                f"all {types[t]}|{colors[c]}|{relations[r]}|{numbers[n]}",
            ]  # fmt: skip
    for role, source in scope.child_sources.items():
        for collection in source.collections:
            found.setdefault(collection, []).append(f"is {role}")
    return list(found.items())


def containers(scope: Scope) -> Proposals:
    """Arrangements that fit what is said, groups that are named sets, and the children's containers."""
    found: dict[tuple[str, int], list[str]] = {}
    fitting, sets = scope.fitting, scope.sets
    for key, names in fitting.named.items():
        found[key] = [*names]
    for mask, names in sets.by_mask.items():
        if mask & (mask - 1):
            found.setdefault(("group", mask), []).extend(names)
    for role, source in scope.child_sources.items():
        for key in source.containers:
            found.setdefault(key, []).append(f"is {role}")
        if source.objects & (source.objects - 1) and not source.containers:
            found.setdefault(("group", source.objects), []).append(f"objects of {role}")
    arrangements = scope.layout.by_members
    robot = _robots(scope)
    counts = {count for _, count in sets.numbers}
    proposals: Proposals = robot
    for (kind, mask), roles in found.items():
        roles.append(f"kind {kind}")
        if fitting.kinds:
            roles.append("kind said" if kind in fitting.kinds else "other kind said")
        if counts:
            roles.append("count said" if mask.bit_count() in counts else "other count said")
        if mask & ~fitting.wanted:
            roles.append("unwanted members")
        if kind == "group":
            roles += [f"as {name}" for name in sets.by_mask.get(mask, ())]
        arrangement = arrangements.get((kind, mask))
        if arrangement is not None:
            roles += arrangement.quality
        proposals.append((Container(kind, scope.layout.names(mask)), roles))
    return proposals


def _robots(scope: Scope) -> Proposals:
    """The robot as the container of its recorded hands, where it is spoken of."""
    found: dict[tuple[str, ...], list[str]] = {}
    hands = tuple(item.id for item in scope.layout.world.objects if item.type == "robot")
    if hands and (scope.own.robot or Container("robot") in scope.named):
        found.setdefault(hands, []).append("robot of own")
    for role, source in scope.child_sources.items():
        if source.hands:
            found.setdefault(source.hands, []).append(f"robot of {role}")
    return [(Container("robot", names), [*roles, "kind robot"]) for names, roles in found.items()]
