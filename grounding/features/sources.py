"""What the parts of a phrase speak of: its own words and its children's groundings, digested alike."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase
from grounding.symbols import (
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
    symbol_key,
)


class Source(NamedTuple):
    """The digest of a set of symbols; every tuple is in a fixed order, without doubles."""

    types: tuple[str, ...]
    colors: tuple[str, ...]
    relations: tuple[str, ...]
    indices: tuple[int, ...]
    numbers: tuple[int, ...]
    kinds: tuple[str, ...]
    objects: int
    furniture: tuple[str, ...]
    containers: tuple[tuple[str, int], ...]
    regions: tuple[Region, ...]
    attributes: tuple[ObjectAttribute, ...]
    collections: tuple[ContainerAttribute, ...]
    actions: tuple[Action, ...]
    robot: bool
    hands: tuple[str, ...]
    symbols: frozenset[Symbol]
    concrete: str


NOTHING = Source((), (), (), (), (), (), 0, (), (), (), (), (), (), False, (), frozenset(), "")
_CONCRETE = (ObjectType, ObjectColor, SpatialReference, Cardinal, Ordinal)


def digest(symbols: frozenset[Symbol], layout: Layout) -> Source:
    """Sort symbols by what they say; attributes count as their parts."""
    if not symbols:
        return NOTHING
    types: dict[str, None] = {}
    colors: dict[str, None] = {}
    relations: dict[str, None] = {}
    indices: dict[int, None] = {}
    numbers: dict[int, None] = {}
    kinds: dict[str, None] = {}
    objects, furniture, containers, regions = 0, [], [], []
    attributes, collections, actions, robot = [], [], [], False
    hands: tuple[str, ...] = ()
    for symbol in sorted(symbols, key=symbol_key):
        match symbol:
            case ObjectSymbol(name):
                if name in layout.index:
                    objects |= 1 << layout.index[name]
                else:
                    furniture.append(name)
            case ObjectType(name):
                types[name] = None
            case ObjectColor(name):
                colors[name] = None
            case SpatialReference(name):
                relations[name] = None
            case Ordinal(value):
                indices[value] = None
            case Cardinal(value):
                numbers[value] = None
            case Container(kind, members):
                if kind == "robot":
                    robot, hands = True, members or hands
                elif members:
                    containers.append((kind, layout.mask(members)))
                else:
                    kinds[kind] = None
            case Region():
                regions.append(symbol)
            case ObjectAttribute(object_type, color, relation, index):
                attributes.append(symbol)
                _add(types, object_type)
                _add(colors, color)
                _add(relations, relation)
                if index is not None and (index != 1 or relation is None):
                    indices[index] = None
            case ContainerAttribute(object_type, color, relation, number):
                collections.append(symbol)
                _add(types, object_type)
                _add(colors, color)
                _add(relations, relation)
                if number is not None:
                    numbers[number] = None
            case Action():
                actions.append(symbol)
    regions.sort(key=lambda region: region.kind != "robot")
    return Source(
        tuple(types), tuple(colors), tuple(relations), tuple(indices), tuple(numbers), tuple(kinds), objects,
        tuple(furniture), tuple(containers), tuple(regions), tuple(attributes), tuple(collections), tuple(actions),
        robot, hands, symbols, _concrete(symbols),
    )  # fmt: skip


def _concrete(symbols: frozenset[Symbol]) -> str:
    """The concrete symbols among some, as one text."""
    return " ".join(
        sorted(
            str(symbol)
            for symbol in symbols
            if isinstance(symbol, _CONCRETE) or (isinstance(symbol, Container | Action) and not symbol.objects)
        )
    )


def _add(known: dict[str, None], value: str | None) -> None:
    if value is not None:
        known[value] = None


def child_roles(phrase: Phrase) -> tuple[str, ...]:
    """What each child phrase is to its parent: head, mod, part, inner, object, dest, subject, prt."""
    roles: list[str] = []
    conjoined = any(word.tag == "CC" for word in phrase.words)
    for child in phrase.phrases:
        if child.tag in ("PRT", "WHNP", "INTJ"):
            roles.append("prt")
        elif phrase.tag == "NP":
            roles.append("part" if conjoined else "head" if child.tag == "NP" and "head" not in roles else "mod")
        elif phrase.tag == "PP":
            roles.append("inner")
        elif phrase.tag == "VP":
            roles.append("object" if child.tag == "NP" else "inner" if child.tag in ("VP", "S") else "dest")
        else:
            roles.append("subject" if child.tag == "NP" else "inner")
    return tuple(roles)


def merge(sources: Iterable[Source], layout: Layout) -> Source:
    """The digest of all that several children say."""
    symbols: frozenset[Symbol] = frozenset().union(*(source.symbols for source in sources))
    return digest(symbols, layout)
