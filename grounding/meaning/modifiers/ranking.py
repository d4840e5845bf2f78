"""Modifiers that rank: "closest to X", "farthest from you", "third from the left"."""

from __future__ import annotations

from dataclasses import replace

from grounding.meaning.nouns import Noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import OBJECTS, PERSON, PLACE, SETS, Condition, Referent
from grounding.meaning.wholes import region_of, whole_of

NEAREST, FARTHEST = "nearest", "farthest"


def person_of(noun: Noun) -> Referent:
    """Somebody from whom is measured: the robot where nobody is named."""
    return Referent(PERSON, person=noun.agent or "robot", text=noun.text)


def by_distance(reader: Reads, noun: Noun, distance: str, rank: int | None, *, away: bool) -> list[Condition]:
    """Ranks by distance: "closest to X", "farthest from X", "furthest to the left".

    Args:
        reader: that reads the noun.
        noun: from which is measured.
        distance: "near" or "far".
        rank: asked for, or None.
        away: whether it is measured "from" a place, not "to" it.
    """
    reference = reader.refer(noun)
    if reference.sort not in (OBJECTS, SETS, PLACE, PERSON):
        return []
    far = distance == "far" and (reference.sort != PLACE or away)
    return [Condition(FARTHEST if far else NEAREST, (reference,), rank=rank, said=distance)]


def counted_from(reader: Reads, noun: Noun, rank: int | None) -> list[Condition]:
    """Ranks by counting from a place or from somebody: "third from the left"."""
    if noun.head == "block" and noun.directions and is_plain(noun):
        noun = replace(noun, head="place")  # "third from the bottom block"
    reference = reader.refer(noun)
    if reference.sort == PLACE and reference.region is not None:
        return [Condition("extreme", region=reference.region, rank=rank)]
    if reference.sort == PERSON:
        return [Condition(NEAREST, (reference,), rank=rank, said="near")]
    whole = whole_of(reader, noun) if noun.head == "place" else None
    if whole is not None and whole.sort == SETS:
        return [Condition("member", (whole,)), Condition("extreme", region=region_of(noun), rank=rank)]
    if reference.sort == OBJECTS and reference.region is not None:
        return [Condition(NEAREST, (reference,), rank=rank, said="near")]
    return []


def is_plain(noun: Noun) -> bool:
    """Whether a noun says nothing but what stands before it: "the bottom block"."""
    return not (noun.modifiers or noun.ordinals or noun.distance or noun.colors)
