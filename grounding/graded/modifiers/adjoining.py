"""Modifiers that say one thing together: "on the right" "in the middle", "two spaces up" "and one left of X"."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from grounding.graded.modifiers.heard import hear
from grounding.graded.relations import stepped
from grounding.graded.values import Effect, Rank, Restriction
from grounding.language.tree import Phrase
from grounding.meaning.nouns import Noun, read_noun
from grounding.world import Array

if TYPE_CHECKING:
    from grounding.graded.reader import Reader

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


def _point(one: Phrase, other: Phrase) -> Phrase | None:
    places = [_bare_place(phrase) for phrase in (one, other)]
    nouns = [read_noun(place) for place in places if place is not None]
    if len(nouns) < 2 or nouns[0].middle == nouns[1].middle or any(n.middle and n.directions for n in nouns):
        return None
    leaves = tuple(leaf for place in places if place is not None for leaf in place.leaves)
    return Phrase("PP", (one.words[0], Phrase("NP", leaves)))


def _bare_place(phrase: Phrase) -> Phrase | None:
    """The noun phrase of "on the right", "in the middle", nothing else being said; None for others."""
    if phrase.tag != "PP" or len(phrase.children) != 2 or len(phrase.words) != 1 or phrase.words[0].text not in _WITHIN:
        return None
    inner = phrase.phrases[0]
    noun = read_noun(inner)
    plain = inner.tag == "NP" and noun.head == "place" and noun.place in (None, "side") and not noun.modifiers
    return inner if plain and (noun.middle or len(noun.directions) == 1) and not noun.agent else None


def counting_off(reader: Reader, noun: Noun, modifier: Phrase) -> list[Effect] | None:
    """For example "the second block down": ordinals count from the top."""
    if not noun.ordinals or modifier.phrases or len(modifier.words) != 1:
        return None
    start = _COUNTED_OFF.get(modifier.words[0].text)
    if start is None:
        return None
    scene = reader.scene
    return [Rank(scene.xy @ scene.direction(start, reader.view), None, 0.3 * scene.edge)]


def steps_from(reader: Reader, parts: Sequence[Phrase], base: Array) -> list[Effect] | None:
    """For example "two spaces up and one left of X": a place so many steps along every axis from a reference."""
    heard = [hear(part, base) for part in parts]
    steps = [(h.directions(), h.measure) for h in heard if h.measure is not None and h.directions()]
    references = [h.noun for h in heard if h.noun is not None]
    if len(steps) != len(heard) or len(heard) < 2 or len(references) != 1:
        return None
    value = reader.noun(references[0])
    if value.kind not in ("objects", "sets", "place"):
        return None
    return [Restriction(stepped(reader.scene, value, [(n, float(m)) for n, m in steps if m is not None], reader.view))]
