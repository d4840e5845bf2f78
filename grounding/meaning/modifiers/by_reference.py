"""Readings of a modifier by what it relates to: people, places, sets and objects.

Each tells what the modifier says, or None where it is not of its kind; the first that does is taken.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from grounding.lexicon import words as w
from grounding.meaning.modifiers.enclosing import enclosing
from grounding.meaning.modifiers.heard import Heard
from grounding.meaning.nouns import Noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import OBJECTS, PERSON, PLACE, SETS, TABLE, Condition, Referent
from grounding.meaning.wholes import at, noun_of_whole

ReferenceReading = Callable[[Reads, Heard, Noun, Referent], "list[Condition] | None"]

_THINGS = (OBJECTS, SETS)
_AMONG = ("of", "from", "in", "among")


def _middle_of(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """In the middle of several: the middle one of them, or what lies between them."""
    if noun.head != "place" or not noun.middle or noun.directions or reference.sort != OBJECTS:
        return None
    whole = noun_of_whole(noun)
    if whole is None:
        return [Condition("same", (reference,))]
    return [Condition("centre", (reference, *enclosing(reader, whole)))]


def _outside(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "outside the row", "outside of the circle", within which something may lie that is no part of it."""
    if "outside" not in heard.texts or reference.sort not in _THINGS:
        return None
    return [Condition("outside", (reference,))]


def _apart(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "separated from the others"."""
    if not w.is_apart(heard.texts) or reference.sort not in _THINGS:
        return None
    return [Condition("apart", (reference,))]


def _by_somebody(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "in front of you", "near me"."""
    if reference.sort != PERSON:
        return None
    names = heard.directions()
    if names:
        return [Condition("before", (reference,), names)]
    return [Condition("nearest", (reference,), rank=heard.ordinal, said="near")] if heard.said.distance else []


def _relation(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "diagonal from the tower": a relation that is a module of the lexicon."""
    said = next((text for text in heard.texts if w.related(text)), None)
    if said is None or reference.sort not in _THINGS:
        return None
    return [Condition("relation", (reference,), (str(w.related(said)),), said=said)]


def _toward(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "behind the tower", "two blocks left of the tower"."""
    names = heard.directions()
    if not names:
        return None
    if heard.measure is not None and reference.sort in (*_THINGS, PLACE):
        counting, metric = heard.counting, heard.metric
        return [Condition("measured", (reference,), names, number=heard.measure, counting=counting, metric=metric)]
    if reference.sort in _THINGS:
        return [Condition("toward", (reference,), names, strict=heard.strict, said=heard.last)]
    region = reference.region
    if reference.sort == PLACE and region is not None and region.middle and not region.names:
        return [Condition("off_middle", words=names, strict=heard.strict)]
    return None


def _touching(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "touching the tower"."""
    said = next((text for text in heard.texts if w.is_touching(text)), None)
    if reference.sort not in _THINGS or said is None:
        return None
    return [Condition("touching", (reference,), nearly=any(w.is_nearly(t) for t in heard.texts), said=said)]


def _beside(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "next to the tower"."""
    said = next((text for text in heard.texts if w.is_beside(text)), None)
    if reference.sort not in _THINGS or said is None:
        return None
    return [Condition("beside", (reference,), strict=heard.strict, said=said)]


def _in_place(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "on the left side"; "at the end of the row" means objects already."""
    if reference.sort == PLACE and reference.region is not None:
        return [at(reference.region, heard.last), *reference.conditions]
    if reference.sort == OBJECTS and reference.region is not None:
        return [Condition("same", (reference,))]
    return None


def _on_table(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "on the table", where others stand on blocks."""
    if reference.sort != TABLE or heard.last not in ("on", "from", "off"):
        return None
    return [Condition("on_table", (reference,) if reference.conditions else (), said=heard.last)]


def _off(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "off the red block", "from the tower": on which it stands."""
    stands = reference.sort == OBJECTS or (reference.sort == SETS and reference.kinds[:1] == ("tower",))
    if not stands or reference.plural or noun.head == "place":
        return None
    return [Condition("on", (reference,), said=heard.last)] if w.is_off(heard.last) or "off" in heard.texts else None


def _on_tower(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "on the tower": on its top, of which it may be a part."""
    tower = reference.sort == SETS and reference.kinds[:1] == ("tower",) and not reference.plural
    return [Condition("on", (reference,), said=heard.last)] if tower and w.is_on(heard.last) else None


def _in_set(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "in the row"."""
    return [Condition("member", (reference,), said=heard.last)] if reference.sort == SETS else None


def _on(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "on the red block"."""
    return [Condition("on", (reference,))] if reference.sort == OBJECTS and w.is_on(heard.last) else None


def _among(reader: Reads, heard: Heard, noun: Noun, reference: Referent) -> list[Condition] | None:
    """For example "of the red one"."""
    return [Condition("among", (reference,))] if reference.sort == OBJECTS and heard.last in _AMONG else None


BY_REFERENCE: tuple[ReferenceReading, ...] = (
    _middle_of,
    _outside,
    _apart,
    _by_somebody,
    _relation,
    _toward,
    _touching,
    _beside,
    _in_place,
    _on_table,
    _off,
    _on_tower,
    _in_set,
    _on,
    _among,
)


def directed(heard: Heard, noun: Noun) -> Noun:
    """A bare place takes the directions before it: "behind and to the left"."""
    if noun.head == "place" and noun.place is None and not noun.middle and not noun.agent:
        return replace(noun, directions=(*noun.directions, *heard.directions()))
    return noun
