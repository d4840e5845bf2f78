"""Readings of a modifier by its own words, before what it relates to is looked for.

Each tells what the modifier does, or None where it is not of its kind; the first that does is taken.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from grounding.graded import scores
from grounding.graded.modifiers import enclosing
from grounding.graded.modifiers.having import having
from grounding.graded.modifiers.heard import Heard
from grounding.graded.modifiers.ranks import by_distance, counted_from, is_plain
from grounding.graded.people import before, distance_from
from grounding.graded.place_phrases import whole_of
from grounding.graded.places import closeness, in_place, located, make_place
from grounding.graded.relations import along, measured
from grounding.graded.values import Effect, Place, Rank, Restriction, Value
from grounding.lexicon import colour
from grounding.lexicon import words as w
from grounding.lexicon.alone import gaps_to_others
from grounding.meaning.nouns import Noun
from grounding.world.scene import ROBOT

if TYPE_CHECKING:
    from grounding.graded.reader import Reader

    WordReading = Callable[[Reader, Heard, Noun], list[Effect] | None]


def by_itself(reader: Reader, heard: Heard) -> list[Effect]:
    """A modifier without a noun phrase: "farthest away", "above", "third"."""
    scene, said = reader.scene, heard.said
    if said.colors:  # "that is red"
        return [Restriction(colour.truth(scene, said.colors))]
    if said.distance and any(w.is_ranking(text) for text in heard.texts):
        sign = 1.0 if said.distance == "near" else -1.0
        return [Rank(-sign * distance_from(scene, said.agent or ROBOT), heard.ordinal, 0.3 * scene.edge)]
    if said.directions:
        if heard.measure is not None and reader.context is not None:  # "from two spaces below"
            start = Value("objects", reader.context)
            return [Restriction(measured(scene, start, said.directions, reader.view, heard.measure))]
        place = make_place(scene, said.directions, said.agent or reader.view, middle=said.middle, bare=True)
        if heard.ordinal is not None or any(w.is_extreme(text) for text in heard.texts):  # "that is second highest"
            return [Rank(closeness(scene, place), heard.ordinal, 0.3 * scene.edge)]
        return located(scene, Value("place", heard.base, place=place), heard.base)
    if said.middle:
        return [Restriction(in_place(scene, Place(middle=True), heard.base))]
    return []


def _ranking(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "closest to the tower"."""
    ranking = [text for text in heard.texts if w.is_ranking(text)]
    if not ranking:
        return None
    return by_distance(reader, noun, w.distance(ranking[-1]) or "near", heard.ordinal, away="from" in heard.texts)


def _between(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "between the towers"."""
    if not any(w.is_between(text) for text in heard.texts):
        return None
    return [Restriction(enclosing.between(reader, noun))]


def _surrounded(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "surrounded by red blocks"."""
    if not any(w.is_surrounded(text) for text in heard.texts):
        return None
    return [Restriction(enclosing.surrounded(reader, noun))]


def _counted(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "third from the left", "from the bottom"."""
    start = noun.head in ("place", "agent") or (noun.directions and is_plain(noun))
    part = noun.head == "place" and heard.ordinal is None and whole_of(reader, noun) is not None
    if part and reader.noun(noun).kind == "objects":
        return None  # "from the top of the tower"
    if heard.ordinal is not None or (heard.last == "from" and start and not heard.said.distance):
        return counted_from(reader, noun, heard.ordinal) or None
    return None


def _far_from(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "far from the tower"."""
    if heard.said.distance != "far" or heard.last != "from":
        return None
    return by_distance(reader, noun, "far", heard.ordinal, away=True)


def _all_the_way(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "all the way to the left", "far on the right", "most to the left"."""
    far = "far" in (heard.said.distance, noun.distance) and noun.head == "place"
    if not {"way", "most"} & set(heard.texts) and not far:
        return None
    value = reader.noun(noun)
    if value.place is None or value.kind != "place":
        return None
    return [Rank(closeness(reader.scene, value.place), heard.ordinal, 0.3 * reader.scene.edge)]


def _side_of(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "to the left of X": a direction from X and not a place on the table, nor a part of a set."""
    if noun.head != "place" or noun.place is not None or noun.middle:
        return None
    scene = reader.scene
    whole = whole_of(reader, noun)
    if whole is None or whole.kind not in ("agent", "objects", "sets"):
        return None
    if whole.kind == "agent":
        return [before(scene, whole.agent or ROBOT, noun.directions)]
    inside = heard.texts[:1] in (["in"], ["at"], ["from"], ["of"]) and "front" not in noun.directions
    if whole.kind == "sets" and (inside or _is_end(reader, noun, whole)):
        return None
    toward = (*heard.further, *noun.directions)
    if heard.measure is not None:
        return [Restriction(measured(scene, whole, toward, reader.view, heard.measure, counting=heard.counting))]
    return [along(scene, whole, toward, noun.agent or reader.view, heard.strict)]


def _of_others(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
    """For example "not with the other red ones", "separated from the others": others than each that is compared."""
    if not (noun.other and noun.plural and noun.head == "block") or not heard.base.any():
        return None
    scene = reader.scene
    others = colour.truth(scene, noun.colors) if noun.colors else heard.base
    gaps = gaps_to_others(scene, others > 0.5)
    if w.is_apart(heard.texts):
        return [Restriction(1.0 - scores.beside(gaps, scene.edge, 1.0)), Rank(gaps, None, scene.edge)]
    if heard.last == "with" or any(w.is_beside(text) for text in heard.texts):
        return [Restriction(scores.beside(gaps, scene.edge, 1.5))]
    return None


def _is_end(reader: Reader, noun: Noun, whole: Value) -> bool:
    """Whether the top or the bottom of a tower is meant, which belongs to it."""
    upright = bool(whole.sets) and bool(reader.scene.stacked[whole.sets[0][0]].all())
    return upright and bool({"up", "down"} & set(noun.directions)) and len(noun.directions) == 1


def _having(reader: Reader, heard: Heard, noun: Noun) -> list[Effect] | None:
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
