"""The symbols of Γ one by one: a generator for every kind that grows with the objects.

Each symbol is made when it is asked for, and made once. Subsets of objects come in the order of their masks: bit i is
the i-th id. `grounding.space` counts what is enumerated here.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from grounding.symbols import (
    ACTION_KINDS,
    CONTAINER_KINDS,
    LAST,
    SPATIAL_REFERENCES,
    Action,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    Region,
)

ROBOT = "robot"  # the container of the robot's hands: of these only, whatever else there is
ARRANGEMENT_KINDS = tuple(kind for kind in CONTAINER_KINDS if kind != ROBOT)
PLACE = "place"  # the action that has a destination
TAKING_KINDS = tuple(kind for kind in ACTION_KINDS if kind != PLACE)
PAIRING = "between"  # the reference that needs two
DIRECTIONS = tuple(name for name in SPATIAL_REFERENCES if name != PAIRING)


def subsets(ids: Sequence[str], least: int = 1) -> Iterator[tuple[str, ...]]:
    """The subsets of at least so many members, in the order of their masks: bit i is the i-th id."""
    for mask in range(1 << len(ids)):
        if mask.bit_count() >= least:
            yield tuple(name for i, name in enumerate(ids) if mask >> i & 1)


def enumerate_containers(ids: Sequence[str]) -> Iterator[Container]:
    """(σ, O_j) for every arrangement σ and every O_j of two and more of the ids."""
    for members in subsets(ids, 2):
        for kind in ARRANGEMENT_KINDS:
            yield Container(kind, members)


def enumerate_object_attributes(types: Sequence[str], colors: Sequence[str], numbers: int) -> Iterator[ObjectAttribute]:
    """Π_O: every type, colour, spatial reference and rank, each of which can be left unsaid."""
    ranks = (None, *range(1, numbers + 1), LAST)
    parts = ((None, *types), (None, *colors), (None, *SPATIAL_REFERENCES), ranks)
    return itertools.starmap(ObjectAttribute, itertools.product(*parts))


def enumerate_container_attributes(
    types: Sequence[str], colors: Sequence[str], numbers: int
) -> Iterator[ContainerAttribute]:
    """Π_η: every type, colour, spatial reference and number, each of which can be left unsaid."""
    parts = ((None, *types), (None, *colors), (None, *SPATIAL_REFERENCES), (None, *range(1, numbers + 1)))
    return itertools.starmap(ContainerAttribute, itertools.product(*parts))


def enumerate_object_regions(ids: Sequence[str]) -> Iterator[Region]:
    """Regions of one object each."""
    for name in ids:
        for relation in DIRECTIONS:
            yield Region(relation, "object", (name,))


def enumerate_set_regions(ids: Sequence[str]) -> Iterator[Region]:
    """Regions of two and more objects that form no arrangement: between them, left of them."""
    for members in subsets(ids, 2):
        for relation in SPATIAL_REFERENCES:
            yield Region(relation, "object", members)


def enumerate_container_regions(ids: Sequence[str]) -> Iterator[Region]:
    """R_η: regions of containers."""
    for container in enumerate_containers(ids):
        for relation in SPATIAL_REFERENCES:
            yield Region(relation, container.kind, container.objects)


def enumerate_robot_regions(hands: Sequence[str]) -> Iterator[Region]:
    """Regions of the robot itself and of its hands."""
    for relation in DIRECTIONS:
        yield Region(relation, ROBOT, ())
    if hands:
        for relation in SPATIAL_REFERENCES if len(hands) > 1 else DIRECTIONS:
            yield Region(relation, ROBOT, tuple(hands))


def enumerate_regions(ids: Sequence[str], furniture: Sequence[str] = (), hands: Sequence[str] = ()) -> Iterator[Region]:
    """All regions."""
    yield from enumerate_object_regions((*ids, *furniture))
    yield from enumerate_set_regions(ids)
    yield from enumerate_container_regions(ids)
    yield from enumerate_robot_regions(hands)


def enumerate_actions(ids: Sequence[str]) -> Iterator[Action]:
    """Actions without a destination on every set of objects."""
    for members in subsets(ids):
        for kind in TAKING_KINDS:
            yield Action(kind, members)


def enumerate_placings(
    ids: Sequence[str], furniture: Sequence[str] = (), hands: Sequence[str] = ()
) -> Iterator[Action]:
    """Every set of objects to every region that is not of any of them, and to the regions beside itself."""
    whole = (1 << len(ids)) - 1
    bits = {name: 1 << i for i, name in enumerate(ids)}
    sets: list[tuple[str, ...]] = [()]  # by mask
    for name in ids:
        sets += [(*members, name) for members in sets]
    for region in enumerate_regions(ids, furniture, hands):
        free = whole & ~sum(bits.get(name, 0) for name in region.objects)
        chosen = free & -free
        while chosen:
            yield Action(PLACE, sets[chosen], region)
            chosen = (chosen - free) & free  # the next subset of `free`
        if region.kind == "object" and free != whole:
            yield Action(PLACE, region.objects, region)
