"""Regions and actions: what is proposed for a phrase, and in which roles."""

from __future__ import annotations

from grounding.features.scope import Scope
from grounding.features.sources import Source
from grounding.geometry.masks import indices_of
from grounding.symbols import Action, Region, SpatialReference, Symbol, sided

Proposals = list[tuple[Symbol, list[str]]]

_MOST_REFERENCES = 8  # of one object that is not settled
_TOO_MANY = 64  # actions that would be proposed where nothing but a type is said


def regions(scope: Scope) -> Proposals:
    """Regions of what the children grounded to, along the directions that are spoken of; the children's regions."""
    found: dict[Region, list[str]] = {}
    relations = region_relations(scope)
    for kind, objects, how in region_references(scope):
        for relation, who in relations.items():
            if relation == "between" and len(objects) < 2:
                continue
            found[Region(relation, kind, objects)] = region_roles(relation, who, kind, how)
    for role, source in scope.child_sources.items():
        for region in source.regions:
            found.setdefault(region, []).append(f"is {role}")
    return list(found.items())


def region_roles(relation: str, who: str, kind: str, how: str) -> list[str]:
    """Roles of a region, from who says its relation and how its reference came about."""
    return [
        "region made", f"relation of {who}", f"relation {sided(relation)}", how, f"{how}|{who}",
        f"{sided(relation)}|{kind}",
    ]  # fmt: skip


def region_relations(scope: Scope) -> dict[str, str]:
    """The directions that regions can have, with who speaks of them."""
    relations: dict[str, str] = {}
    if scope.phrase.tag in ("NP", "PP"):
        for role, source in (("own", scope.own), ("head", scope.source("head"))):
            for relation in source.relations:
                relations.setdefault(relation, role)
        for symbol in scope.named:
            if isinstance(symbol, SpatialReference):
                relations.setdefault(symbol.name, "word")
    return relations


def region_references(scope: Scope) -> list[tuple[str, tuple[str, ...], str]]:
    """What regions can be of: (kind, ids, how it came about)."""
    if scope.phrase.tag not in ("NP", "PP"):
        return []
    return [found for role in ("mod", "inner") for found in _references(scope, scope.source(role), role)]


def _references(scope: Scope, source: Source, role: str) -> list[tuple[str, tuple[str, ...], str]]:
    """What a region can be of: (kind, ids, how it came about)."""
    found: list[tuple[str, tuple[str, ...], str]] = []
    layout = scope.layout
    for kind, mask in source.containers:
        found.append((kind, layout.names(mask), f"container of {role}"))
    if len(source.containers) > 1:
        union = 0
        for _, mask in source.containers:
            union |= mask
        found.append((source.containers[0][0], layout.names(union), f"containers of {role}"))
    if source.objects:
        names = layout.names(source.objects)
        how = "object" if len(names) == 1 else "objects"
        found.append(("object", names, f"{how} of {role}"))
    found += [("object", (name,), f"furniture of {role}") for name in source.furniture]
    if source.robot:
        found.append(("robot", source.hands, f"robot of {role}"))
    if source.attributes and not source.objects:
        pool = possible(scope, source)
        if 0 < pool.bit_count() <= _MOST_REFERENCES:
            found.append(("object", layout.names(pool), f"possible objects of {role}"))
    return found


def possible(scope: Scope, source: Source) -> int:
    """The things that a source leaves possible where it has not settled on any."""
    layout = scope.layout
    pool = layout.everything
    for attribute in source.attributes[:1]:
        pool &= layout.matching(attribute.object_type, attribute.color)
    for collection in source.collections[:1]:
        pool &= layout.matching(collection.object_type, collection.color)
    for _, mask in source.containers[:1]:
        pool &= mask
    for region in source.regions[:1]:
        pool &= layout.within(region)
    return pool


def actions(scope: Scope) -> Proposals:
    """Actions on what the object phrase grounded to or, where it left several possible, on each of them."""
    found: dict[Action, list[str]] = {}
    kinds = [action.kind for action in scope.own.actions if not action.objects] or [
        symbol.kind for symbol in scope.named if isinstance(symbol, Action)
    ]
    target = scope.source("object")
    destinations = action_destinations(scope)
    for names, how in action_targets(scope, target):
        for kind in kinds:
            for region, whence in destinations:
                if (kind == "place") == (whence.startswith("nowhere")):
                    continue  # a place has a destination, nothing else has
                if region is not None and set(region.objects) & set(names) and whence != "beside itself":
                    continue
                if whence == "beside itself":
                    for relation in scope.source("dest").relations:
                        own_region = Region(relation, "object", names)
                        found.setdefault(Action(kind, names, own_region), []).extend(
                            [f"kind {kind}", how, whence, f"{how}|{whence}"]
                        )
                    continue
                found.setdefault(Action(kind, names, region), []).extend(
                    [f"kind {kind}", how, whence, f"{how}|{whence}", f"{kind}|{whence}"]
                )
    for role, source in scope.child_sources.items():
        for action in source.actions:
            if action.objects:
                found.setdefault(action, []).append(f"is {role}")
    return list(found.items())


def action_targets(scope: Scope, target: Source) -> list[tuple[tuple[str, ...], str]]:
    """What actions can be on: (ids, how it came about)."""
    layout = scope.layout
    if target.objects:
        names = layout.names(target.objects)
        return [(names, "the object" if len(names) == 1 else "the objects")]
    pool = possible(scope, target)
    if not pool or not (target.attributes or target.collections or target.kinds):
        return []
    if target.attributes:
        return [((layout.ids[i],), "a possible object") for i in list(indices_of(pool))[:_TOO_MANY]]
    if target.kinds:
        lists = scope.fitting.lists
        return [(layout.names(a.mask), "a possible container") for a in lists.get("counted", lists["seen"])]
    counts = set(target.numbers)
    counted = "" if not counts else " as counted" if pool.bit_count() in counts else " against the count"
    return [(layout.names(pool), f"all that match{counted}")]


def action_destinations(scope: Scope) -> list[tuple[Region | None, str]]:
    """Where to: (region, how it came about); a lone direction is beside the object itself."""
    destination = scope.source("dest")
    found: list[tuple[Region | None, str]] = []
    for region in destination.regions:
        if region.kind == "object" and len(region.objects) > 1 and region.relation != "between":
            found += [(Region(region.relation, "object", (name,)), "to a possible region") for name in region.objects]
        else:
            found.append((region, "to region"))
    if destination.relations and not destination.regions:
        found.append((None, "beside itself"))
    found.append((None, "nowhere though said" if found or destination.symbols else "nowhere"))
    return found
