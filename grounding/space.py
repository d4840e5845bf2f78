"""Γ, counted and enumerated: which symbols there are for N objects and given labels (Section III of Paul et al., 2016).

This module alone says which symbols Γ contains, for a world or for so many objects. Every kind has a size in closed
form and the generator of `grounding.enumeration` that yields its symbols. Sizes are exact integers of any length;
containers grow as 2^N, and placings, which pair a set with a region beside it, as 3^N.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

from grounding.enumeration import (
    ARRANGEMENT_KINDS,
    DIRECTIONS,
    PAIRING,
    PLACE,
    ROBOT,
    TAKING_KINDS,
    enumerate_actions,
    enumerate_container_attributes,
    enumerate_container_regions,
    enumerate_containers,
    enumerate_object_attributes,
    enumerate_object_regions,
    enumerate_placings,
    enumerate_robot_regions,
    enumerate_set_regions,
)
from grounding.errors import SymbolError
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
    ObjectColor,
    ObjectSymbol,
    ObjectType,
    Ordinal,
    Region,
    SpatialReference,
    Symbol,
)
from grounding.world import World

NUMBER_WORDS = 20  # numbers and ranks go so far at least: as far as words for them do
UNKNOWN = "unknown"  # the colour that nobody knows is no label


class Counts(NamedTuple):
    """What the sizes depend on.

    Attributes:
        objects: N, things that can be meant and moved.
        types: T, labels.
        colors: C, labels.
        furniture: F, what else can be meant: the table, hands.
        hands: H, how many of the furniture are the robot's hands.
        numbers: K, the largest cardinal and ordinal.
    """

    objects: int
    types: int = 0
    colors: int = 0
    furniture: int = 0
    hands: int = 0
    numbers: int = NUMBER_WORDS


@dataclass(frozen=True)
class SymbolSpace:
    """Γ for given objects and labels.

    Attributes:
        objects: ids of the things, sorted.
        types: labels.
        colors: labels.
        furniture: ids of what else is there.
        hands: ids of the robot's hands, among the furniture.
    """

    objects: tuple[str, ...]
    types: tuple[str, ...] = ()
    colors: tuple[str, ...] = ()
    furniture: tuple[str, ...] = ()
    hands: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        for name in ("objects", "types", "colors", "furniture", "hands"):
            values = tuple(sorted(getattr(self, name)))
            double = next((a for a, b in itertools.pairwise(values) if a == b), None)
            if double is not None:
                raise SymbolError(f"{name}: {double!r} occurs twice; every one is named once")
            object.__setattr__(self, name, values)
        strangers = set(self.hands) - set(self.furniture)
        if strangers:
            raise SymbolError(f"hands {', '.join(sorted(strangers))} are not among the furniture")

    @classmethod
    def of_world(cls, world: World, types: Iterable[str] = (), colors: Iterable[str] = ()) -> SymbolSpace:
        """Γ for a world.

        Args:
            world: Υ.
            types: labels beside those that occur in the world, e.g. those that words can name.
            colors: likewise.
        """
        things = {item.id for item in world.things}
        return cls(
            tuple(things),
            tuple({*types, *(item.type for item in world.objects)}),
            tuple({*colors, *(item.color for item in world.objects)} - {UNKNOWN}),
            tuple(item.id for item in world.objects if item.id not in things),
            tuple(item.id for item in world.objects if item.type == ROBOT),
        )

    @classmethod
    def of_size(cls, objects: int, types: Iterable[str] = (), colors: Iterable[str] = ()) -> SymbolSpace:
        """Γ for so many objects, b1, b2, ..., and no furniture."""
        return cls(tuple(f"b{i}" for i in range(1, objects + 1)), tuple(types), tuple(colors))

    @property
    def counts(self) -> Counts:
        """What the sizes depend on."""
        return Counts(
            len(self.objects), len(self.types), len(self.colors), len(self.furniture), len(self.hands), self.numbers
        )

    @property
    def numbers(self) -> int:
        """The largest cardinal and ordinal."""
        return largest_number(len(self.objects))

    def __iter__(self) -> Iterator[Symbol]:
        """All symbols of Γ, kind by kind, each once."""
        return itertools.chain.from_iterable(kind.symbols(self) for kind in KINDS)

    def __contains__(self, symbol: object) -> bool:
        """Whether a symbol is one of Γ; told from its parts, without enumeration."""
        match symbol:
            case ObjectSymbol(name):
                return name in self.objects or name in self.furniture
            case ObjectType(name):
                return name in self.types
            case ObjectColor(name):
                return name in self.colors
            case SpatialReference():
                return True
            case Cardinal(value):
                return 0 < value <= self.numbers
            case Ordinal(value):
                return value == LAST or 0 < value <= self.numbers
            case Container(kind, members):
                return not members or self._is_reference(kind, members) and (kind == ROBOT or len(members) > 1)
            case ObjectAttribute(object_type, color, _, index):
                return self._are_labels(object_type, color) and (index is None or Ordinal(index) in self)
            case ContainerAttribute(object_type, color, _, number):
                return self._are_labels(object_type, color) and (number is None or Cardinal(number) in self)
            case Region(relation, kind, members):
                return self._is_reference(kind, members) and (relation != PAIRING or len(members) > 1)
            case Action(kind, members, region):
                if not members or not self._are_things(members):
                    return not members and region is None
                if region is None or kind != PLACE:
                    return region is None and kind != PLACE
                beside_itself = region.kind == "object" and region.objects == members
                return region in self and (beside_itself or not set(members) & set(region.objects))
        return False

    def _are_things(self, members: tuple[str, ...]) -> bool:
        return set(members) <= set(self.objects) and len(set(members)) == len(members)

    def _are_labels(self, object_type: str | None, color: str | None) -> bool:
        return (object_type is None or object_type in self.types) and (color is None or color in self.colors)

    def _is_reference(self, kind: str, members: tuple[str, ...]) -> bool:
        """Whether regions can be of these."""
        if kind == ROBOT:
            return members in ((), self.hands)
        if len(members) == 1:
            return kind == "object" and ObjectSymbol(members[0]) in self
        return len(members) > 1 and self._are_things(members)


def largest_number(objects: int) -> int:
    """The largest cardinal and ordinal in Γ: of so many objects, or the largest that has a word of its own."""
    return max(objects, NUMBER_WORDS)


def _several(n: int) -> int:
    """How many subsets of n objects have two and more members."""
    return 2**n - n - 1


def _apart(n: int) -> int:
    """How many pairs of disjoint subsets of n objects there are, the first of two and more, the second of any."""
    return 3**n - 2**n - n * 2 ** (n - 1) - _several(n) if n else 0


def _robot_regions(c: Counts) -> int:
    d, r = len(DIRECTIONS), len(SPATIAL_REFERENCES)
    return d + (0 if not c.hands else d if c.hands == 1 else r)


def _placings(c: Counts) -> int:
    n, d, r, a = c.objects, len(DIRECTIONS), len(SPATIAL_REFERENCES), len(ARRANGEMENT_KINDS)
    anything = 2**n - 1
    single = d * n * (2**n // 2 - 1) if n else 0
    beside = d * n + r * _several(n)
    return single + d * c.furniture * anything + r * (1 + a) * _apart(n) + _robot_regions(c) * anything + beside


class Kind(NamedTuple):
    """One kind of symbol.

    Attributes:
        name: as it is listed.
        example: a symbol of this kind, in the notation.
        abstract: whether it belongs to the abstract symbols; the others are concrete.
        formula: the size in the letters of `COUNTED`, `FIXED` and `SHORTHANDS`.
        size: the size in closed form.
        symbols: yields them all.
    """

    name: str
    example: str
    abstract: bool
    formula: str
    size: Callable[[Counts], int]
    symbols: Callable[[SymbolSpace], Iterator[Symbol]]


_R, _D, _A, _V = len(SPATIAL_REFERENCES), len(DIRECTIONS), len(ARRANGEMENT_KINDS), len(ACTION_KINDS)
COUNTED = {"N": "objects", "F": "furniture", "H": "hands", "T": "types", "C": "colors", "K": "numbers"}
FIXED = {"R": _R, "D": _D, "A": _A, "V": _V}  # references, those that need no pair, arrangements, kinds of action
SHORTHANDS = {
    "P": ("2^N - 1", "sets of objects"),
    "S": ("2^N - N - 1", "sets of two and more"),
    "Q": ("3^N - 2^(N+1) - N 2^(N-1) + N + 1", "pairs of disjoint sets, the one of two and more"),
}

KINDS: tuple[Kind, ...] = (
    Kind("objects", "object(b3)", False, "N + F",
         lambda c: c.objects + c.furniture, lambda s: map(ObjectSymbol, (*s.objects, *s.furniture))),
    Kind("types", "type(block)", False, "T",
         lambda c: c.types, lambda s: map(ObjectType, s.types)),
    Kind("colours", "color(red)", False, "C",
         lambda c: c.colors, lambda s: map(ObjectColor, s.colors)),
    Kind("spatial references", "spatial(left)", False, "R",
         lambda c: _R, lambda s: map(SpatialReference, SPATIAL_REFERENCES)),
    Kind("cardinals", "cardinal(5)", False, "K",
         lambda c: c.numbers, lambda s: map(Cardinal, range(1, s.numbers + 1))),
    Kind("ordinals", "ordinal(3)", False, "K + 1",
         lambda c: c.numbers + 1, lambda s: map(Ordinal, (*range(1, s.numbers + 1), LAST))),
    Kind("kinds of container", "container(row)", False, "A + 1",
         lambda c: _A + 1, lambda s: map(Container, CONTAINER_KINDS)),
    Kind("kinds of action", "action(pick)", False, "V",
         lambda c: _V, lambda s: map(Action, ACTION_KINDS)),
    Kind("containers", "container(row; b1 b2 b3)", True, "A S",
         lambda c: _A * _several(c.objects), lambda s: enumerate_containers(s.objects)),
    Kind("container of the hands", "container(robot; left_hand right_hand)", True, "1 if H > 0",
         lambda c: int(c.hands > 0), lambda s: iter([Container(ROBOT, s.hands)] if s.hands else [])),
    Kind("object attributes", "attribute(block, red, left, 3)", True, "(T + 1) (C + 1) (R + 1) (K + 2)",
         lambda c: (c.types + 1) * (c.colors + 1) * (_R + 1) * (c.numbers + 2),
         lambda s: enumerate_object_attributes(s.types, s.colors, s.numbers)),
    Kind("container attributes", "collection(block, red, -, 5)", True, "(T + 1) (C + 1) (R + 1) (K + 1)",
         lambda c: (c.types + 1) * (c.colors + 1) * (_R + 1) * (c.numbers + 1),
         lambda s: enumerate_container_attributes(s.types, s.colors, s.numbers)),
    Kind("regions of objects", "region(right, object; b3)", True, "D (N + F)",
         lambda c: _D * (c.objects + c.furniture),
         lambda s: enumerate_object_regions((*s.objects, *s.furniture))),
    Kind("regions of sets", "region(between, object; b1 b2)", True, "R S",
         lambda c: _R * _several(c.objects), lambda s: enumerate_set_regions(s.objects)),
    Kind("regions of containers", "region(left, row; b1 b2 b3)", True, "A R S",
         lambda c: _A * _R * _several(c.objects), lambda s: enumerate_container_regions(s.objects)),
    Kind("regions of the robot", "region(front, robot; )", True, "B = D; 2 D if H = 1; D + R if H > 1",
         _robot_regions, lambda s: enumerate_robot_regions(s.hands)),
    Kind("actions on sets", "action(pick; b3)", True, "(V - 1) P",
         lambda c: len(TAKING_KINDS) * (2**c.objects - 1), lambda s: enumerate_actions(s.objects)),
    Kind("placings of sets", "action(place; b3; right, object; b7)", True,
         "D N 2^(N-1) + (D F + B) P + (1 + A) R Q + R S",
         _placings, lambda s: enumerate_placings(s.objects, s.furniture, s.hands)),
)  # fmt: skip


def total(counts: Counts, abstract: bool | None = None) -> int:
    """The size of Γ.

    Args:
        counts: what it depends on.
        abstract: only the abstract symbols if True, only the concrete ones if False.
    """
    return sum(kind.size(counts) for kind in KINDS if abstract is None or kind.abstract == abstract)
