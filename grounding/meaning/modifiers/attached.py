"""What all the modifiers of a noun say."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from grounding.language.tree import Phrase
from grounding.meaning.modifiers.adjoining import counting_off, points_together, sides_of_possessions
from grounding.meaning.modifiers.ranking import FARTHEST, NEAREST, by_distance
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import Condition, again


def attached(reader: Reads, noun: Noun) -> tuple[Noun, list[Condition]]:
    """A noun with what its modifiers say; "closest ... to you" is taken together.

    Returns:
        The noun without what was taken together with a modifier, and the conditions.
    """
    found: list[Condition] = []
    mentioned = reader.context.mentioned
    if noun.distance and mentioned is not None and noun.text.split(" ", 1)[0] == "its":  # "its nearest neighbour"
        concept = NEAREST if noun.distance == "near" else FARTHEST
        found.append(Condition(concept, (again(mentioned),), said=noun.distance))
        noun = replace(noun, distance=None)
    modifiers = points_together(sides_of_possessions(_separate(noun.modifiers)))
    for place, modifier in enumerate(modifiers):
        counted = counting_off(noun, modifier) if place + 1 < len(modifiers) else None
        if counted is not None:
            found.append(counted)
            continue
        if noun.distance and (reference := complement(modifier)) is not None:
            away = "from" in modifier.text.split()
            ranks = by_distance(reader, read_noun(reference), noun.distance, None, away=away)
            if ranks:
                noun = replace(noun, distance=None)
                found += ranks
                continue
        found += reader.conditions(modifier, noun)
    return noun, found


def _separate(modifiers: Sequence[Phrase]) -> list[Phrase]:
    """Modifiers, those one by one that "and" joins to a complement: "from you and next to a red one"."""
    found: list[Phrase] = []
    for modifier in modifiers:
        parts = modifier.phrases
        joined = modifier.tag == "PP" and len(parts) > 1 and all(part.tag == "PP" for part in parts)
        if joined and all(word.tag == "CC" for word in modifier.words) and complement(parts[0]) is not None:
            found += parts
        else:
            found.append(modifier)
    return found


def complement(modifier: Phrase) -> Phrase | None:
    """The noun phrase of "to X" and "from X", nothing else before it."""
    texts = [word.text for word in modifier.words]
    if modifier.tag == "PP" and texts in (["to"], ["from"], ["away", "from"]) and len(modifier.phrases) == 1:
        return modifier.phrases[0] if modifier.phrases[0].tag == "NP" else None
    return None
