"""All containers and all regions for a phrase: the power set of the things times kinds and relations (Section V-B)."""

from __future__ import annotations

import numpy as np

from grounding.features import abstract, acting
from grounding.features.blocks import NO_ROLE, Block, Slot, Space, make_slot, make_space, with_others
from grounding.features.discretiser import role_names, shape_roles
from grounding.features.scope import Scope
from grounding.geometry.layout import Layout
from grounding.space import ARRANGEMENT_KINDS, DIRECTIONS, ROBOT
from grounding.symbols import SPATIAL_REFERENCES, Container, Region, Symbol

_UNSAID = "nobody"  # who says a relation that nobody says
_UNNAMED = "of nothing said"  # how a reference came about that nothing names

Listed = list[tuple[Symbol, list[str]]]
Reference = tuple[str, tuple[str, ...]]


def subsets(layout: Layout, least: int = 2) -> np.ndarray:
    """The masks of all sets of at least so many things, ascending."""
    masks = np.arange(1 << layout.size)
    return masks[np.bitwise_count(masks) >= least]


def place_of(masks: np.ndarray, layout: Layout, objects: tuple[str, ...]) -> int | None:
    """Where a set of ids stands among masks; None if it is not among them, as a set with furniture is."""
    if not all(name in layout.index for name in objects):
        return None
    mask = layout.mask(objects)
    place = int(np.searchsorted(masks, mask))
    return place if place < len(masks) and masks[place] == mask else None


def _hands(layout: Layout) -> tuple[str, ...]:
    return tuple(item.id for item in layout.world.objects if item.type == ROBOT)


def every_container(scope: Scope, proposals: Listed) -> Space:
    """Every set of two and more things as every kind of arrangement, and the robot's hands."""
    layout = scope.layout
    hands = _hands(layout)
    listed = with_others(proposals, [(Container(ROBOT, hands), ["robot unsaid", "kind robot"])] if hands else [])
    masks = subsets(layout)
    if not len(masks):
        return make_space(listed)
    counts = [abstract.count_roles(scope, count) for count in range(layout.size + 1)]
    strange = (masks & ~scope.fitting.wanted) != 0
    members = abstract.member_roles(scope, -1)[:1] or [NO_ROLE]  # -1: a set with members that are not wanted
    shared = [
        make_slot(["named by nothing"], np.zeros(1, dtype=int)),
        make_slot([NO_ROLE, *members], strange.astype(int)),
        *(make_slot([row[i] for row in counts], np.bitwise_count(masks)) for i in range(len(counts[0]))),
    ]
    return make_space(listed, [_container_block(scope, kind, masks, shared) for kind in ARRANGEMENT_KINDS])


def _container_block(scope: Scope, kind: str, masks: np.ndarray, shared: list[Slot]) -> Block:
    layout = scope.layout
    parts = [
        make_slot([NO_ROLE, role], (((masks & ~whole) == 0) & (masks != whole)).astype(int))
        for whole, roles in abstract.part_roles_of(scope, kind)
        for role in roles
    ]
    constant = [make_slot([role], np.zeros(1, dtype=int)) for role in abstract.kind_roles(scope, kind)]
    codes = shape_roles(layout).every(kind, masks)
    shape = [Slot(names, of) for names, of in zip(role_names(kind), codes, strict=True)]
    found = [int(np.searchsorted(masks, mask)) for other, mask in layout.by_members if other == kind]

    def find(symbol: Symbol) -> int | None:
        right = isinstance(symbol, Container) and symbol.kind == kind
        return place_of(masks, layout, symbol.objects) if right and isinstance(symbol, Container) else None

    def symbol(index: int) -> Symbol:
        return Container(kind, layout.names(int(masks[index])))

    return Block(masks.shape, (*constant, *shared, *parts, *shape), symbol, find, tuple(found))


def every_region(scope: Scope, proposals: Listed) -> Space:
    """Every relation to every object, every set, every arrangement and the robot."""
    layout = scope.layout
    relations = acting.region_relations(scope)
    references = {(kind, objects): how for kind, objects, how in acting.region_references(scope)}
    hands = _hands(layout)
    lone: list[Reference] = [("object", (item.id,)) for item in layout.world.objects]
    lone += [(ROBOT, ())] + ([(ROBOT, hands)] if len(hands) == 1 else [])
    fixed = [(relation, reference) for reference in lone for relation in DIRECTIONS]
    fixed += [(relation, (ROBOT, hands)) for relation in SPATIAL_REFERENCES if len(hands) > 1]
    others: Listed = [
        (Region(relation, *reference), _roles(relation, reference[0], references.get(reference, _UNNAMED), relations))
        for relation, reference in fixed
    ]
    listed = with_others(proposals, others)
    masks = subsets(layout)
    if not len(masks):
        return make_space(listed)
    kinds = ("object", *ARRANGEMENT_KINDS)
    return make_space(listed, [_region_block(layout, kind, masks, relations, references) for kind in kinds])


def _roles(relation: str, kind: str, how: str, relations: dict[str, str]) -> list[str]:
    return acting.region_roles(relation, relations.get(relation, _UNSAID), kind, how)


def _region_block(
    layout: Layout, kind: str, masks: np.ndarray, relations: dict[str, str], references: dict[Reference, str]
) -> Block:
    """The regions of all sets of two and more things as a container of a kind, or as mere objects."""
    shape = len(SPATIAL_REFERENCES), len(masks)
    hows = [_UNNAMED]
    how_of = np.zeros(len(masks), dtype=int)
    for (other, objects), how in references.items():
        place = place_of(masks, layout, objects)
        if other == kind and place is not None:
            hows.append(how)
            how_of[place] = len(hows) - 1
    rows = [[_roles(relation, kind, how, relations) for how in hows] for relation in SPATIAL_REFERENCES]
    flat = [roles for by_how in rows for roles in by_how]
    whole = np.arange(shape[0])[:, None] * len(hows) + how_of[None]
    slots = []
    for number in range(len(flat[0])):
        names = [roles[number] for roles in flat]
        grid = np.array(names).reshape(shape[0], len(hows))
        if (grid == grid[:, :1]).all():  # it depends on the relation alone
            slots.append(make_slot(names, np.arange(shape[0])[:, None] * len(hows)))
        elif (grid == grid[:1]).all():  # on the reference alone
            slots.append(make_slot(names, how_of[None]))
        else:
            slots.append(make_slot(names, whole))

    def symbol(index: int) -> Symbol:
        relation, place = divmod(index, shape[1])
        return Region(SPATIAL_REFERENCES[relation], kind, layout.names(int(masks[place])))

    def find(symbol: Symbol) -> int | None:
        if not isinstance(symbol, Region) or symbol.kind != kind:
            return None
        place = place_of(masks, layout, symbol.objects)
        return None if place is None else SPATIAL_REFERENCES.index(symbol.relation) * shape[1] + place

    return Block(shape, tuple(slots), symbol, find)
