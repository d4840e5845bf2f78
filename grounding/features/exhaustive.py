"""Every symbol of Γ for a phrase, by family, as the exhaustive search of Section V-B judges them.

A symbol that adaptive inference proposes has the roles that it has there. The roles of any other symbol follow from the
same definitions: what depends on the symbol alone (its kind, its parts, its members) is asked of the same functions,
and that nothing names it is a role of its own. `grounding.space` says which symbols there are; subsets of objects are
enumerated as there, in the order of their masks.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from grounding.errors import SearchError
from grounding.features import abstract, concrete
from grounding.features.blocks import Space, make_space, with_others
from grounding.features.every_action import every_action
from grounding.features.every_attribute import every_attribute, every_collection
from grounding.features.every_set import every_container, every_region
from grounding.features.families import FAMILIES
from grounding.features.scope import Scope
from grounding.space import largest_number
from grounding.symbols import LAST, Cardinal, ObjectSymbol, Ordinal, Symbol

MOST_THINGS = 15  # of a world whose power set is listed
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
    proposals = _PROPOSE[family](scope)
    return replace(_SPACES[family](scope, proposals), proposed=len(proposals))


def _numbers(scope: Scope, proposals: Listed) -> Space:
    counts: list[Symbol] = [Cardinal(value) for value in range(1, largest_number(scope.layout.size) + 1)]
    return make_space(with_others(proposals, concrete.judged(scope, counts)))


def _ordinals(scope: Scope, proposals: Listed) -> Space:
    ranks: list[Symbol] = [Ordinal(value) for value in (*range(1, largest_number(scope.layout.size) + 1), LAST)]
    return make_space(with_others(proposals, concrete.judged(scope, ranks)))


def _objects(scope: Scope, proposals: Listed) -> Space:
    layout = scope.layout
    others: Listed = [
        (ObjectSymbol(name), ["in no set", *abstract.object_roles(scope, index)])
        for index, name in enumerate(layout.ids)
    ]
    others += [
        (ObjectSymbol(item.id), ["furniture unsaid"]) for item in layout.world.objects if item.id not in layout.index
    ]
    return make_space(with_others(proposals, others))


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
    "attribute": every_attribute,
    "collection": every_collection,
    "container": every_container,
    "region": every_region,
    "action": every_action,
}
