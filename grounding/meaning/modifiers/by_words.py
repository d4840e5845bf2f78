"""Readings of a modifier by its own words, before what it relates to is looked at.

Each tells what the modifier says, or None where it is not of its kind; the first that does is taken.
"""

from __future__ import annotations

from collections.abc import Callable

from grounding.lexicon import words as w
from grounding.meaning.modifiers.enclosing import enclosing
from grounding.meaning.modifiers.having import having
from grounding.meaning.modifiers.heard import Heard
from grounding.meaning.modifiers.ranking import FARTHEST, NEAREST, by_distance, counted_from, is_plain, person_of
from grounding.meaning.nouns import Noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import OBJECTS, PERSON, PLACE, SETS, Condition, Referent, Region, again
from grounding.meaning.wholes import at, whole_of

WordReading = Callable[[Reads, Heard, Noun], "list[Condition] | None"]


def by_itself(reader: Reads, heard: Heard) -> list[Condition]:
    """A modifier without a noun phrase: "farthest away", "above", "third"."""
    said = heard.said
    if said.colors:  # "that is red"
        return [Condition("colour", words=said.colors)]
    if said.distance and any(w.is_ranking(text) for text in heard.texts):
        concept = NEAREST if said.distance == "near" else FARTHEST
        return [Condition(concept, (person_of(said),), rank=heard.ordinal, said=said.distance)]
    if said.directions:
        return _directed(reader, heard)
    return [at(Region(middle=True))] if said.middle else []


def _directed(reader: Reads, heard: Heard) -> list[Condition]:
    said, mentioned = heard.said, reader.context.mentioned
    if heard.measure is not None and mentioned is not None:  # "from two spaces below"
        return [Condition("measured", (again(mentioned),), said.directions, number=heard.measure, metric=heard.metric)]
    region = Region(said.directions, said.middle, len(said.directions) > 1, bare=True, owner=said.agent)
    if heard.ordinal is not None or any(w.is_extreme(text) for text in heard.texts):  # "that is second highest"
        return [Condition("extreme", region=region, rank=heard.ordinal)]
    return [at(region)]


def _ranking(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "closest to the tower"."""
    ranking = [text for text in heard.texts if w.is_ranking(text)]
    if not ranking:
        return None
    return by_distance(reader, noun, w.distance(ranking[-1]) or "near", heard.ordinal, away="from" in heard.texts)


def _between(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "between the towers"."""
    said = next((text for text in heard.texts if w.is_between(text)), None)
    return None if said is None else [Condition("between", enclosing(reader, noun), said=said)]


def _surrounded(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "surrounded by red blocks"."""
    said = next((text for text in heard.texts if w.is_surrounded(text)), None)
    return None if said is None else [Condition("surrounded", enclosing(reader, noun), said=said)]


def _counted(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "third from the left", "from the bottom"."""
    start = noun.head in ("place", "agent") or (noun.directions and is_plain(noun))
    part = noun.head == "place" and heard.ordinal is None and whole_of(reader, noun) is not None
    if part and reader.refer(noun).sort == OBJECTS:
        return None  # "from the top of the tower"
    if heard.ordinal is not None or (heard.last == "from" and start and not heard.said.distance):
        return counted_from(reader, noun, heard.ordinal) or None
    return None


def _far_from(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "far from the tower"."""
    if heard.said.distance != "far" or heard.last != "from":
        return None
    return by_distance(reader, noun, "far", heard.ordinal, away=True)


def _all_the_way(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "all the way to the left", "far on the right", "more to the left"."""
    far = "far" in (heard.said.distance, noun.distance) and noun.head == "place"
    if not {"way", "most", "more"} & set(heard.texts) and not far:
        return None
    reference = reader.refer(noun)
    if reference.sort != PLACE:
        return None
    return [Condition("extreme", region=reference.region, rank=heard.ordinal, said="way")]


def _side_of(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "to the left of X": a direction from X and not a place on the table, nor a part of a set."""
    if noun.head != "place" or noun.place is not None or noun.middle:
        return None
    whole = whole_of(reader, noun)
    if whole is None or whole.sort not in (PERSON, OBJECTS, SETS):
        return None
    if whole.sort == PERSON:
        return [Condition("before", (whole,), noun.directions)]
    inside = heard.texts[:1] in (["in"], ["at"], ["from"], ["of"]) and "front" not in noun.directions
    if whole.sort == SETS and (inside or _is_end(noun, whole)):
        return None
    toward = (*heard.further, *noun.directions)
    if heard.measure is not None:
        return [
            Condition("measured", (whole,), toward, number=heard.measure, counting=heard.counting, metric=heard.metric)
        ]
    return [Condition("toward", (whole,), toward, owner=noun.agent, strict=heard.strict, said=heard.last)]


def _of_others(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "not with the other red ones", "separated from the others": others than each that is compared."""
    if not (noun.other and noun.plural and noun.head == "block"):
        return None
    if w.is_apart(heard.texts):
        return [Condition("apart_others", words=noun.colors)]
    if heard.last == "with" or any(w.is_beside(text) for text in heard.texts):
        return [Condition("with_others", words=noun.colors)]
    return None


def _is_end(noun: Noun, whole: Referent) -> bool:
    """Whether the top or the bottom of a tower is meant, which belongs to it."""
    return "tower" in whole.kinds and bool({"up", "down"} & set(noun.directions)) and len(noun.directions) == 1


def _having(reader: Reads, heard: Heard, noun: Noun) -> list[Condition] | None:
    """For example "with a red block to its left"."""
    if heard.child is None or heard.last != "with" or noun.head not in ("block", "container"):
        return None
    return having(reader, heard.child)


BY_WORDS: tuple[WordReading, ...] = (
    _ranking,
    _between,
    _surrounded,
    _counted,
    _far_from,
    _all_the_way,
    _side_of,
    _of_others,
    _having,
)
