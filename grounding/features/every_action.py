"""All actions for a phrase: taking every set of things, and placing every set in every region beside it.

There are 3^N placings and more. A placing's roles depend on how its objects and its destination came about, and all
but a few sets and regions came about in no way: those placings are counted in closed form and judged together.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.features import acting
from grounding.features.blocks import Block, Slot, Space, make_slot, make_space, with_others
from grounding.features.every_set import place_of, subsets
from grounding.features.scope import Scope
from grounding.geometry.layout import Layout
from grounding.space import ARRANGEMENT_KINDS, DIRECTIONS, KINDS, PAIRING, PLACE, TAKING_KINDS, SymbolSpace
from grounding.symbols import SPATIAL_REFERENCES, Action, Region, Symbol

_UNNAMED = "on nothing said"
_ELSEWHERE = "to a region unsaid"
_BESIDE = "beside itself"

Listed = list[tuple[Symbol, list[str]]]
Named = dict[tuple[str, ...], str]  # sets of ids, with how they came about


def every_action(scope: Scope, proposals: Listed) -> Space:
    """Taking every set of things; placing every set in every region that is beside it."""
    layout = scope.layout
    if not layout.size:
        return make_space(proposals)
    targets = {
        names: how for names, how in acting.action_targets(scope, scope.source("object"))
        if all(name in layout.index for name in names)
    }  # fmt: skip
    found = acting.action_destinations(scope)
    nowhere = found[-1][1]
    regions = {region: whence for region, whence in found if region is not None}
    beside = set(scope.source("dest").relations) if any(whence == _BESIDE for _, whence in found) else set()
    said = {action.kind for action in scope.own.actions}
    blocks = [_taking(layout, kind, kind in said, targets, nowhere) for kind in TAKING_KINDS]
    blocks.append(_beside(layout, 1, PLACE in said, targets, [relation in beside for relation in DIRECTIONS]))
    if layout.size > 1:
        blocks.append(_beside(layout, 2, PLACE in said, targets, [PAIRING in beside]))
    listed = with_others(proposals, _between_named(layout, PLACE in said, targets, regions))
    return make_space(listed, blocks, _placings(layout, PLACE in said, targets, list(regions), regions, listed))


def _kind(kind: str, said: bool) -> str:
    return f"kind {kind}" if said else "kind unsaid"


def _roles(kind: str, said: bool, how: str, whence: str) -> list[str]:
    return [_kind(kind, said), how, whence, f"{how}|{whence}", f"{kind}|{whence}"]


def _hows(layout: Layout, masks: np.ndarray, targets: Named) -> tuple[list[str], np.ndarray]:
    """How sets came about: the different ways, and which of them is whose."""
    ways, of = [_UNNAMED], np.zeros(len(masks), dtype=int)
    for names, how in targets.items():
        place = place_of(masks, layout, names)
        if place is not None:
            ways.append(how)
            of[place] = len(ways) - 1
    return ways, of


def _taking(layout: Layout, kind: str, said: bool, targets: Named, nowhere: str) -> Block:
    masks = subsets(layout, 1)
    ways, of = _hows(layout, masks, targets)
    rows = [_roles(kind, said, how, nowhere) for how in ways]
    slots = tuple(make_slot([row[i] for row in rows], of) for i in range(len(rows[0])))

    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, Action) or symbol.kind != kind or symbol.destination is not None:
            return None
        return place_of(masks, layout, symbol.objects)

    return Block(masks.shape, slots, lambda index: Action(kind, layout.names(int(masks[index]))), find)


def _beside(layout: Layout, least: int, said: bool, targets: Named, relations: Sequence[bool]) -> Block:
    """Placing sets of so many things and more in regions of their own: in each direction, or between themselves."""
    masks = subsets(layout, least)
    names = DIRECTIONS if least == 1 else (PAIRING,)
    ways, of = _hows(layout, masks, targets)
    rows = [_roles(PLACE, said, how, whence) for whence in (f"{_BESIDE} unsaid", _BESIDE) for how in ways]
    which = len(ways) * np.array(relations, dtype=int)[:, None] + of[None]
    slots: tuple[Slot, ...] = tuple(make_slot([row[i] for row in rows], which) for i in range(len(rows[0])))

    def symbol(index: int) -> Symbol:
        relation, place = divmod(index, len(masks))
        objects = layout.names(int(masks[place]))
        return Action(PLACE, objects, Region(names[relation], "object", objects))

    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, Action) or symbol.kind != PLACE or symbol.destination is None:
            return None
        region, place = symbol.destination, place_of(masks, layout, symbol.objects)
        if place is None or region.kind != "object" or region.objects != symbol.objects or region.relation not in names:
            return None
        return names.index(region.relation) * len(masks) + place

    return Block(which.shape, slots, symbol, find)


def _between_named(layout: Layout, said: bool, targets: Named, regions: dict[Region, str]) -> Listed:
    """Placing a set that came about somehow in a region that did."""
    return [
        (Action(PLACE, names, region), _roles(PLACE, said, how, whence))
        for names, how in targets.items()
        for region, whence in regions.items()
        if not set(names) & set(region.objects)
    ]


def _placings(
    layout: Layout, said: bool, targets: Named, named: list[Region], regions: dict[Region, str], listed: Listed
) -> list[tuple[list[str], int]]:
    """All other placings, by their roles, with their numbers.

    Let T be the named sets and D the named regions. There are |T| x |D| placings within those, which are listed; those
    of T elsewhere, of other sets to D, and of other sets elsewhere follow from the sizes of disjoint sets.
    """
    n, hands = layout.size, len([item for item in layout.world.objects if item.type == "robot"])
    furniture = len(layout.world.objects) - n
    both = sum(not set(names) & set(region.objects) for names in targets for region in named)
    groups: dict[tuple[str, ...], int] = {}
    total = _all_placings(layout) - _own_regions(n) - both - _others_listed(listed, targets, regions)
    for names, how in targets.items():
        free = n - len(names)
        reach = len(DIRECTIONS) * (free + furniture) + _robots(hands)
        reach += len(SPATIAL_REFERENCES) * (1 + len(ARRANGEMENT_KINDS)) * (2**free - free - 1)
        reach -= sum(not set(names) & set(region.objects) for region in named)
        key = tuple(_roles(PLACE, said, how, _ELSEWHERE))
        groups[key] = groups.get(key, 0) + reach
        total -= reach
    for region, whence in regions.items():
        taken = {name for name in region.objects if name in layout.index}
        sets = 2 ** (n - len(taken)) - 1 - sum(not set(names) & set(region.objects) for names in targets)
        key = tuple(_roles(PLACE, said, _UNNAMED, whence))
        groups[key] = groups.get(key, 0) + sets
        total -= sets
    key = tuple(_roles(PLACE, said, _UNNAMED, _ELSEWHERE))
    groups[key] = groups.get(key, 0) + total
    return [(list(roles), count) for roles, count in groups.items() if count > 0]


def _others_listed(listed: Listed, targets: Named, regions: dict[Region, str]) -> int:
    """How many placings are listed that do not join a named set with a named region: those of children."""
    return sum(
        isinstance(symbol, Action)
        and symbol.kind == PLACE
        and symbol.destination is not None
        and symbol.destination.objects != symbol.objects
        and not (symbol.objects in targets and symbol.destination in regions)
        for symbol, _ in listed
    )


def _robots(hands: int) -> int:
    """How many regions of the robot there are."""
    own = len(DIRECTIONS)
    return own + (0 if not hands else own if hands == 1 else len(SPATIAL_REFERENCES))


def _own_regions(n: int) -> int:
    """How many placings are to a region of the placed things themselves."""
    return len(DIRECTIONS) * n + len(SPATIAL_REFERENCES) * (2**n - n - 1)


def _all_placings(layout: Layout) -> int:
    counts = SymbolSpace.of_world(layout.world).counts
    return next(kind.size(counts) for kind in KINDS if kind.name == "placings of sets")
