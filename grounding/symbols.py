"""Γ: the symbols that phrases are related to (Section III of Paul et al., RSS 2016).

Concrete symbols are objects, labels (types and colours), spatial references, cardinals, ordinals and kinds of action.
Abstract ones are containers (σ, O_j), object attributes Π_O, container attributes Π_η, regions, and actions on
objects. All are immutable, hashable and compare by value; `str` gives a notation that `parse_symbol` reads back::

    object(b3)  type(block)  color(red)  spatial(left)  cardinal(5)  ordinal(3)
    container(row)  container(row; b1 b2 b3)
    attribute(block, red, left, 3)  collection(block, red, -, 5)
    region(right, object; b3)  region(left, row; b1 b2 b3)
    action(pick; b3)  action(place; b3; right, object; b7)
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from grounding.errors import SymbolError

SPATIAL_REFERENCES = ("left", "right", "front", "back", "near", "far", "center", "top", "bottom", "between")
CONTAINER_KINDS = ("row", "column", "group", "circle", "tower", "robot")
ACTION_KINDS = ("pick", "place", "clear")
LAST = -1  # the ordinal "last"


def sided(relation: str) -> str:
    """A spatial reference up to mirroring: left and right are both "side"."""
    return "side" if relation in ("left", "right") else relation


def _named(value: str | None) -> str:
    return "-" if value is None else value


def _members(objects: Iterable[str]) -> str:
    return " ".join(objects)


@dataclass(frozen=True, slots=True)
class ObjectSymbol:
    """An object of the world, by its id."""

    id: str

    def __str__(self) -> str:
        return f"object({self.id})"


@dataclass(frozen=True, slots=True)
class ObjectType:
    """A label: the type of an object ("block")."""

    name: str

    def __str__(self) -> str:
        return f"type({self.name})"


@dataclass(frozen=True, slots=True)
class ObjectColor:
    """A label: the colour of an object ("red")."""

    name: str

    def __str__(self) -> str:
        return f"color({self.name})"


@dataclass(frozen=True, slots=True)
class SpatialReference:
    """A direction or distance; one of `SPATIAL_REFERENCES`."""

    name: str

    def __post_init__(self) -> None:
        _one_of("spatial reference", self.name, SPATIAL_REFERENCES)

    def __str__(self) -> str:
        return f"spatial({self.name})"


@dataclass(frozen=True, slots=True)
class Cardinal:
    """A number of objects."""

    value: int

    def __str__(self) -> str:
        return f"cardinal({self.value})"


@dataclass(frozen=True, slots=True)
class Ordinal:
    """A rank, from 1; `LAST` for "last"."""

    value: int

    def __str__(self) -> str:
        return f"ordinal({self.value})"


@dataclass(frozen=True, slots=True)
class Container:
    """A container (σ, O_j): an arrangement of objects. Without objects, the kind alone ("the row").

    Attributes:
        kind: σ, one of `CONTAINER_KINDS`.
        objects: O_j, ids in sorted order.
    """

    kind: str
    objects: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        _one_of("container kind", self.kind, CONTAINER_KINDS)
        object.__setattr__(self, "objects", tuple(sorted(self.objects)))

    def __str__(self) -> str:
        return f"container({self.kind}; {_members(self.objects)})" if self.objects else f"container({self.kind})"


@dataclass(frozen=True, slots=True)
class ObjectAttribute:
    """An element of Π_O: what is said of one object, without saying which it is.

    Attributes:
        object_type: label, or None where nothing is said.
        color: label, or None.
        relation: the spatial reference along which the object is ranked, or None.
        index: its rank, or None.
    """

    object_type: str | None
    color: str | None = None
    relation: str | None = None
    index: int | None = None

    def __str__(self) -> str:
        index = "-" if self.index is None else str(self.index)
        return f"attribute({_named(self.object_type)}, {_named(self.color)}, {_named(self.relation)}, {index})"


@dataclass(frozen=True, slots=True)
class ContainerAttribute:
    """An element of Π_η: what is said of several objects, without saying which they are.

    Attributes:
        object_type: label of the members, or None.
        color: label of the members, or None.
        relation: the spatial reference in which they are extreme, or None.
        number: how many, or None.
    """

    object_type: str | None
    color: str | None = None
    relation: str | None = None
    number: int | None = None

    def __str__(self) -> str:
        number = "-" if self.number is None else str(self.number)
        return f"collection({_named(self.object_type)}, {_named(self.color)}, {_named(self.relation)}, {number})"


@dataclass(frozen=True, slots=True)
class Region:
    """A region R_η: the space in a direction of an object or of a container.

    Attributes:
        relation: a spatial reference; "top" is on it, "near" beside it.
        kind: "object", or the kind of the container.
        objects: ids of the reference, in sorted order.
    """

    relation: str
    kind: str
    objects: tuple[str, ...]

    def __post_init__(self) -> None:
        _one_of("relation of a region", self.relation, SPATIAL_REFERENCES)
        _one_of("reference of a region", self.kind, ("object", *CONTAINER_KINDS))
        object.__setattr__(self, "objects", tuple(sorted(self.objects)))

    def __str__(self) -> str:
        return f"region({self.relation}, {self.kind}; {_members(self.objects)})"


@dataclass(frozen=True, slots=True)
class Action:
    """An action on objects; `place` has the region it leads to.

    Attributes:
        kind: one of `ACTION_KINDS`.
        objects: ids in sorted order; empty for the kind alone.
        destination: the region that the objects are brought to, or None.
    """

    kind: str
    objects: tuple[str, ...] = ()
    destination: Region | None = None

    def __post_init__(self) -> None:
        _one_of("action", self.kind, ACTION_KINDS)
        object.__setattr__(self, "objects", tuple(sorted(self.objects)))

    def __str__(self) -> str:
        parts = [self.kind]
        if self.objects or self.destination:
            parts.append(_members(self.objects))
        if self.destination:
            parts.append(f"{self.destination.relation}, {self.destination.kind}")
            parts.append(_members(self.destination.objects))
        return f"action({'; '.join(parts)})"


Symbol = (
    ObjectSymbol
    | ObjectType
    | ObjectColor
    | SpatialReference
    | Cardinal
    | Ordinal
    | Container
    | ObjectAttribute
    | ContainerAttribute
    | Region
    | Action
)

_FORM = re.compile(r"\s*([a-z]+)\(([^()]*)\)")


def symbol_key(symbol: Symbol) -> tuple[str, str]:
    """A key that sorts symbols of all kinds, the same on every machine."""
    return type(symbol).__name__, str(symbol)


def parse_symbol(text: str) -> Symbol:
    """Read one symbol from its notation.

    Raises:
        SymbolError: naming the text and the form that would be right.
    """
    match = _FORM.fullmatch(text.strip())
    if match is None:
        raise SymbolError(f"no symbol: {text!r}; a symbol looks like object(b3) or container(row; b1 b2)")
    form, body = match.groups()
    sections = [section.strip() for section in body.split(";")]
    try:
        return _build(form, sections)
    except (SymbolError, ValueError) as error:
        raise SymbolError(f"no symbol: {text!r}: {error}") from error


def parse_symbols(text: str) -> frozenset[Symbol]:
    """Read any number of symbols, separated by blanks."""
    rest, symbols = text, []
    while rest.strip():
        match = _FORM.match(rest)
        if match is None:
            raise SymbolError(f"no symbol at {rest.strip()[:40]!r}; a symbol looks like object(b3)")
        symbols.append(parse_symbol(match.group(0)))
        rest = rest[match.end() :]
    return frozenset(symbols)


def format_symbols(symbols: Iterable[Symbol]) -> str:
    """Write symbols in sorted order, separated by blanks; `parse_symbols` reads them back."""
    return " ".join(str(symbol) for symbol in sorted(symbols, key=symbol_key))


def symbol_json(symbol: Symbol) -> dict[str, Any]:
    """A symbol as the plain values of a result's `groundings`."""
    match symbol:
        case ObjectSymbol(id):
            return {"symbol": "object", "objects": [id]}
        case ObjectType(name):
            return {"symbol": "type", "name": name}
        case ObjectColor(name):
            return {"symbol": "color", "name": name}
        case SpatialReference(name):
            return {"symbol": "spatial_reference", "name": name}
        case Cardinal(value):
            return {"symbol": "cardinal", "value": value}
        case Ordinal(value):
            return {"symbol": "ordinal", "value": value}
        case Container(kind, objects):
            return {"symbol": "container", "kind": kind, "objects": list(objects)}
        case ObjectAttribute(object_type, color, relation, index):
            return {"symbol": "object_attribute", "type": object_type, "color": color, "relation": relation,
                    "index": index}  # fmt: skip
        case ContainerAttribute(object_type, color, relation, number):
            return {"symbol": "container_attribute", "type": object_type, "color": color, "relation": relation,
                    "number": number}  # fmt: skip
        case Region(relation, kind, objects):
            return {"symbol": "region", "relation": relation, "kind": kind, "objects": list(objects)}
        case Action(kind, objects, destination):
            return {"symbol": "action", "action": kind, "objects": list(objects),
                    "destination": None if destination is None else symbol_json(destination)}  # fmt: skip


def _one_of(what: str, value: str, allowed: tuple[str, ...]) -> None:
    if value not in allowed:
        raise SymbolError(f"unknown {what} {value!r}; known are {', '.join(allowed)}")


def _build(form: str, sections: list[str]) -> Symbol:
    def fields(section: int, count: int) -> list[str | None]:
        values = [value.strip() for value in sections[section].split(",")]
        if len(values) != count or not all(values):
            raise ValueError(f"expected {count} fields in {sections[section]!r}")
        return [None if value == "-" else value for value in values]

    def number(text: str | None) -> int | None:
        return None if text is None else int(text)

    def expect(*counts: int) -> None:
        if len(sections) not in counts or not sections[0]:
            found = len(sections) if sections[0] else 0
            raise ValueError(f"expected {' or '.join(map(str, counts))} parts, set apart by ;, and found {found}")

    def members(section: int) -> tuple[str, ...]:
        return tuple(sections[section].split()) if len(sections) > section else ()

    def region(section: int) -> Region:
        relation, kind = fields(section, 2)
        return Region(str(relation), str(kind), members(section + 1))

    if form == "container":
        expect(1, 2)
        return Container(sections[0], members(1))
    if form == "attribute":
        expect(1)
        object_type, color, relation, index = fields(0, 4)
        return ObjectAttribute(object_type, color, relation, number(index))
    if form == "collection":
        expect(1)
        object_type, color, relation, count = fields(0, 4)
        return ContainerAttribute(object_type, color, relation, number(count))
    if form == "region":
        expect(2)
        return region(0)
    if form == "action":
        expect(1, 2, 4)
        return Action(sections[0], members(1), region(2) if len(sections) > 2 else None)
    simple: dict[str, Callable[[str], Symbol]] = {
        "object": ObjectSymbol,
        "type": ObjectType,
        "color": ObjectColor,
        "spatial": SpatialReference,
    }
    counted: dict[str, Callable[[int], Symbol]] = {"cardinal": Cardinal, "ordinal": Ordinal}
    if form in simple or form in counted:
        expect(1)
        if form == "object" and len(members(0)) != 1:
            raise ValueError("expected one id")
        return simple[form](sections[0]) if form in simple else counted[form](int(sections[0]))
    raise ValueError(f"unknown form {form!r}; known are {', '.join([*simple, *counted])}, container, attribute, "
                     "collection, region, action")  # fmt: skip
