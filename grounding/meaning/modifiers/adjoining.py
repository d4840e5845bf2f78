"""Modifiers that say one thing together: "on the right" "in the middle", "two spaces up" "and one left of X"."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.language.tree import Phrase
from grounding.meaning.modifiers.having import of_itself
from grounding.meaning.modifiers.heard import hear
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import OBJECTS, PLACE, SETS, Condition, Region

_COUNTED_OFF = {"down": "back", "up": "front"}
_WITHIN = frozenset("in on at near to".split())


def points_together(modifiers: Sequence[Phrase]) -> list[Phrase]:
    """Modifiers, a side and a middle next to each other as one point: "on the right" "in the middle"."""
    found: list[Phrase] = []
    for modifier in modifiers:
        joined = _point(found[-1], modifier) if found else None
        if joined is None:
            found.append(modifier)
        else:
            found[-1] = joined
    return found


def sides_of_possessions(modifiers: Sequence[Phrase]) -> list[Phrase]:
    """Modifiers, a side of what has something joined to what it has: "with a red block" "on its left"."""
    found: list[Phrase] = []
    for modifier in modifiers:
        before = found[-1] if found else None
        has = before is not None and before.tag == "PP" and [w.text for w in before.words] == ["with"]
        if before is not None and has and len(before.phrases) == 1 and of_itself(modifier) and modifier.tag == "PP":
            found[-1] = Phrase("PP", (*before.words, Phrase("NP", (before.phrases[0], modifier))))
        else:
            found.append(modifier)
    return found


def _point(one: Phrase, other: Phrase) -> Phrase | None:
    places = [place for phrase in (one, other) if (place := _bare_place(phrase)) is not None]
    nouns = [read_noun(place) for place in places]
    if len(nouns) < 2 or nouns[0].middle == nouns[1].middle or any(n.middle and n.directions for n in nouns):
        return None
    leaves = tuple(leaf for place in places for leaf in place.leaves)
    return Phrase("PP", (one.words[0], Phrase("NP", leaves)))


def _bare_place(phrase: Phrase) -> Phrase | None:
    """The noun phrase of "on the right", "in the middle", nothing else being said; None for others."""
    if phrase.tag != "PP" or len(phrase.children) != 2 or len(phrase.words) != 1 or phrase.words[0].text not in _WITHIN:
        return None
    inner = phrase.phrases[0]
    noun = read_noun(inner)
    plain = inner.tag == "NP" and noun.head == "place" and noun.place in (None, "side") and not noun.modifiers
    return inner if plain and (noun.middle or len(noun.directions) == 1) and not noun.agent else None


def counting_off(noun: Noun, modifier: Phrase) -> Condition | None:
    """For example "the second block down": ordinals count from the top."""
    if not noun.ordinals or modifier.phrases or len(modifier.words) != 1:
        return None
    start = _COUNTED_OFF.get(modifier.words[0].text)
    return None if start is None else Condition("extreme", region=Region((start,), bare=True))


def steps_from(reader: Reads, parts: Sequence[Phrase]) -> list[Condition] | None:
    """For example "two spaces up and one left of X": a place so many steps along every axis from a reference."""
    heard = [hear(part) for part in parts]
    counted = [h for h in heard if not h.metric and h.directions()]
    steps = tuple((h.directions(), h.measure) for h in counted if h.measure is not None)
    references = [h.noun for h in heard if h.noun is not None]
    if len(steps) != len(heard) or len(heard) < 2 or len(references) != 1:
        return None
    reference = reader.refer(references[0])
    if reference.sort not in (OBJECTS, SETS, PLACE):
        return None
    return [Condition("stepped", (reference,), ways=steps)]
