"""Symbols of the paper's XML corpus as symbols of Γ.

| element | symbol |
| --- | --- |
| `object` | `ObjectSymbol` |
| `object_type`, `object_color` | `ObjectType`, `ObjectColor` |
| `spatial_relation` | `SpatialReference` |
| `index`, `number` | `Ordinal`, `Cardinal` |
| `container` | `Container` |
| `object_property` | `ObjectAttribute` |
| `abstract_container` | `ContainerAttribute`; its `index` is "first" throughout and says nothing |
| `region`, `region_container` | `Region` of an object, of a container |
| `action` | `Action` |
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from grounding.corpus.elements import Element
from grounding.errors import CorpusError, SymbolError
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
)

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh",
             "twelfth")  # fmt: skip
_NUMBERS = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")

Names = Mapping[str, str]


def read_symbol(element: Element, names: Names) -> Symbol:
    """Translate one element of a `grounding_set`.

    Args:
        element: the symbol.
        names: ids by the names that the file's world gives.

    Raises:
        CorpusError: an unknown symbol or object; names the line and the element.
    """
    reader = _READERS.get(element.tag)
    if reader is None:
        raise CorpusError(f"{element}: unknown symbol; known are {', '.join(sorted(_READERS))}")
    try:
        return reader(element, names)
    except SymbolError as error:
        raise CorpusError(f"{element}: {error}") from error


def _object_id(element: Element, name: str, names: Names) -> str:
    if name not in names:
        raise CorpusError(f"{element}: no object {name!r} in the world of this file")
    return names[name]


def _members(element: Element, names: Names) -> tuple[str, ...]:
    return tuple(_object_id(child, child.get("name"), names) for child in element.all("object"))


def _count(element: Element, text: str, words: tuple[str, ...]) -> int:
    """A number from a word or digits."""
    if text in words:
        return words.index(text) + 1
    if text.isdecimal() and int(text) > 0:
        return int(text)
    raise CorpusError(f"{element}: unknown number {text!r}; known are {', '.join(words)} and digits")


def _known(text: str) -> str | None:
    return None if text == "na" else text


def _attribute(element: Element, names: Names) -> Symbol:
    return ObjectAttribute(
        _known(element.get("object_type")),
        _known(element.attributes.get("color", "na")),
        _relation(_known(element.get("relation_type"))),
        _count(element, element.get("index"), _ORDINALS),
    )


def _relation(name: str | None) -> str | None:
    return None if name is None else SpatialReference(name).name  # refuses a name that is none


def _collection(element: Element, names: Names) -> Symbol:
    number = _count(element, element.get("num"), _NUMBERS)
    return ContainerAttribute(_known(element.get("type")), _known(element.attributes.get("color", "na")), None, number)


def _region(element: Element, names: Names) -> Symbol:
    references = list(element.all("container", "object"))
    if len(references) != 1:
        raise CorpusError(f"{element}: expected one object or container to be beside, found {len(references)}")
    reference = references[0]
    if reference.tag == "object":
        return Region(element.get("type"), "object", (_object_id(reference, reference.get("name"), names),))
    return Region(element.get("type"), reference.get("type"), _members(reference, names))


def _action(element: Element, names: Names) -> Symbol:
    objects = []
    for parameter in element.all("parameter"):
        for key, name in parameter.attributes.items():
            if key != "pick_object":
                raise CorpusError(f"{parameter}: unknown parameter {key!r}; known is pick_object")
            objects.append(_object_id(parameter, name, names))
    return Action(element.get("type"), tuple(objects))


_READERS: dict[str, Callable[[Element, Names], Symbol]] = {
    "object": lambda element, names: ObjectSymbol(_object_id(element, element.get("name"), names)),
    "object_type": lambda element, names: ObjectType(element.get("type")),
    "object_color": lambda element, names: ObjectColor(element.get("type", "color")),
    "spatial_relation": lambda element, names: SpatialReference(element.get("type")),
    "index": lambda element, names: Ordinal(_count(element, element.get("type", "value"), _ORDINALS)),
    "number": lambda element, names: Cardinal(_count(element, element.get("value", "type"), _NUMBERS)),
    "container": lambda element, names: Container(element.get("type"), _members(element, names)),
    "object_property": _attribute,
    "abstract_container": _collection,
    "region": _region,
    "region_container": _region,
    "action": _action,
}
