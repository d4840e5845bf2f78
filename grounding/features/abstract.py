"""Objects and containers: what is proposed for a phrase, and in which roles."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from grounding.features.discretiser import LOOKS, shape_roles
from grounding.features.scope import Scope
from grounding.geometry.masks import indices_of
from grounding.symbols import Container, ObjectSymbol, ObjectType, Symbol

Proposals = list[tuple[Symbol, list[str]]]

UNWANTED = "unwanted members"
_ROBOT = Container("robot")


def objects(scope: Scope) -> Proposals:
    """Every object that is in some named set; an object's roles are the sets it is in."""
    proposals: Proposals = []
    for index, names in sorted(_memberships(scope).items()):
        roles = [*dict.fromkeys(names), *dict.fromkeys(map(some, names)), *object_roles(scope, index)]
        proposals.append((ObjectSymbol(scope.layout.ids[index]), roles))
    proposals += [(ObjectSymbol(name), roles) for name, roles in sorted(_furniture(scope).items())]
    return proposals


def _memberships(scope: Scope) -> dict[int, list[str]]:
    """The things that are in some named set, with the names of these sets."""
    members: dict[int, list[str]] = {index: list(names) for index, names in scope.sets.of_object.items()}
    if scope.fitting.kinds:
        for (_, mask), fits in scope.fitting.named.items():
            for index in indices_of(mask):
                members.setdefault(index, []).extend(f"member {name}" for name in fits)
    for _, mask in scope.own_abstract.containers:
        for index in indices_of(mask):
            members.setdefault(index, [])
    ranked = scope.sets.ranked_by("own", scope.own_abstract.attributes)
    for role in ("head", "object"):
        ranked |= scope.sets.ranked_by(role, scope.source(role).attributes)
    for name, mask in ranked.items():
        for index in indices_of(mask):
            members.setdefault(index, []).append(name)
    return members


def _furniture(scope: Scope) -> dict[str, list[str]]:
    """The furniture that is spoken of, with who speaks of it."""
    layout = scope.layout
    furniture: dict[str, list[str]] = {name: ["furniture of own container"] for name in scope.own_abstract.hands}
    for role, source in scope.child_sources.items():
        for name in source.furniture:
            furniture.setdefault(name, []).append(f"furniture of {role}")
    for item in layout.world.objects:
        if item.id not in layout.index and item.type in scope.own.types:
            furniture.setdefault(item.id, []).append("furniture of own type")
        if item.id not in layout.index and ObjectType(item.type) in scope.named:
            furniture.setdefault(item.id, []).append("furniture named")
    return furniture


def object_roles(scope: Scope, index: int) -> list[str]:
    """Roles of a thing in what the phrase itself and its children have grounded to."""
    containers = scope.own_abstract.containers
    roles = [f"in own {kind}" for kind, mask in containers if mask >> index & 1]
    if containers:
        roles.append("in own container" if roles else "outside own container")
    told = scope.told_objects
    if told:
        inside = [named for mask, named in told if mask >> index & 1]
        share = "all" if len(inside) == len(told) else "some" if inside else "none"
        roles.append(f"in {share} of {min(len(told), 2)}")
        for named in inside:
            roles += named
    return roles


def containers(scope: Scope) -> Proposals:
    """Arrangements that fit what is said, groups that are named sets, and the children's containers."""
    found, sets = _named_containers(scope), scope.sets
    proposals: Proposals = _robots(scope)
    shapes = shape_roles(scope.layout).of(found)
    of_kind = {kind: (kind_roles(scope, kind), part_roles_of(scope, kind)) for kind, _ in found}
    of_count = {count: count_roles(scope, count) for count in {mask.bit_count() for _, mask in found}}
    unwanted, names_of = ~scope.fitting.wanted, scope.layout.names
    for ((kind, mask), roles), shape in zip(found.items(), shapes, strict=True):
        by_kind, wholes = of_kind[kind]
        roles += by_kind
        roles += of_count[mask.bit_count()]
        if mask & unwanted:
            roles.append(UNWANTED)
        roles += shape
        if mask in sets.by_mask:
            roles += look_roles(scope, mask, shape)
        for whole, parts in wholes:
            if mask != whole and not mask & ~whole:
                roles += parts
        proposals.append((Container(kind, names_of(mask)), roles))
    return proposals


def _named_containers(scope: Scope) -> dict[tuple[str, int], list[str]]:
    """The containers that come about somehow, by kind and members, with the names of how they do."""
    fitting, sets = scope.fitting, scope.sets
    found = {key: [*names] for key, names in fitting.named.items()}
    for mask, names in sets.by_mask.items():
        if mask & (mask - 1):
            found.setdefault(("group", mask), []).extend(names)
            found.setdefault((shape_roles(scope.layout).line_kind(mask), mask), []).extend(names)
    carried = {key for source in scope.child_sources.values() for key in source.containers}
    for key in sorted(carried):
        found.setdefault(key, []).append("carried upward" if len(carried) > 1 else "carried upward, the only one")
        if fitting.kinds:
            found[key].append(f"carried upward, {'kind said' if key[0] in fitting.kinds else 'other kind said'}")
    for role, source in scope.child_sources.items():
        for key in source.containers:
            found.setdefault(key, []).append(f"is {role}")
        if source.objects & (source.objects - 1) and not source.containers:
            found.setdefault(("group", source.objects), []).append(f"objects of {role}")
    return found


def kind_roles(scope: Scope, kind: str) -> list[str]:
    """Roles of a container that depend on its kind alone."""
    said = scope.fitting.kinds
    return [f"kind {kind}", *(["kind said" if kind in said else "other kind said"] if said else [])]


def count_roles(scope: Scope, count: int) -> list[str]:
    """Roles of a container that depend on the number of its members alone."""
    said = {number for _, number in scope.sets.numbers}
    return (["count said"] if count in said else ["other count said"]) if said else []


def member_roles(scope: Scope, mask: int) -> list[str]:
    """Roles of a container that depend on which its members are, not on where they lie."""
    return [UNWANTED] if mask & ~scope.fitting.wanted else []


@lru_cache(maxsize=4096)
def some(name: str) -> str:
    """The role of all sets that come about in the same way as a named one: `nth[all|own|own]` is "some nth"."""
    return f"some {name.partition('[')[0]}"


def look_roles(scope: Scope, mask: int, shape: Sequence[str]) -> list[str]:
    """Roles of a container that tell how each of the names of its members goes with how they look.

    A set's names give roles on several levels ("the two extreme ones of all along the modifier's direction", "some
    extreme ones", "some named set"), so that little training is enough for much of what they tell.
    """
    look = next((role for role in LOOKS if role in shape), None)
    names = scope.sets.by_mask.get(mask, ())
    if look is None or not names:
        return []
    ways = dict.fromkeys(map(some, names))
    return [f"some set {look}", *(f"{name} {look}" for name in names), *ways, *(f"{way} {look}" for way in ways)]


def part_roles_of(scope: Scope, kind: str) -> list[tuple[int, tuple[str, str]]]:
    """The children's containers, with the roles of a container of a kind that lies within."""
    return [
        (whole, (f"part of {role}", f"part of {role}, {'same' if other == kind else 'other'} kind"))
        for role, source in scope.child_sources.items()
        for other, whole in source.containers
    ]


def _robots(scope: Scope) -> Proposals:
    """The robot as the container of its recorded hands, where it is spoken of."""
    found: dict[tuple[str, ...], list[str]] = {}
    if scope.own.robot or _ROBOT in scope.named:
        hands = tuple(item.id for item in scope.layout.world.objects if item.type == "robot")
        if hands:
            found[hands] = ["robot of own"]
    for role, source in scope.child_sources.items():
        if source.hands:
            found.setdefault(source.hands, []).append(f"robot of {role}")
    return [(Container("robot", names), [*roles, "kind robot"]) for names, roles in found.items()]
