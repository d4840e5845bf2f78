"""A noun with what all its modifiers do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from grounding.graded.modifiers.adjoining import counting_off, points_together
from grounding.graded.modifiers.ranks import by_distance
from grounding.graded.relations import distance_to
from grounding.graded.values import Effect, Rank, Value
from grounding.language.tree import Phrase
from grounding.meaning.nouns import Noun, read_noun
from grounding.world import Array

if TYPE_CHECKING:
    from grounding.graded.reader import Reader


def with_modifiers(reader: Reader, noun: Noun, base: Array) -> tuple[Noun, list[Effect]]:
    """A noun with the effects of its modifiers; "closest ... to you" is taken together.

    Args:
        reader: that reads the modifiers.
        noun: to which they belong.
        base: how well every object agrees with its words, shape (n,).

    Returns:
        The noun without what was taken together with a modifier, and the effects.
    """
    effects: list[Effect] = []
    if noun.distance and reader.context is not None and noun.text.split(" ", 1)[0] == "its":  # "its nearest neighbour"
        sign = 1.0 if noun.distance == "near" else -1.0
        owner = Value("objects", reader.context)
        effects.append(Rank(-sign * distance_to(reader.scene, owner), None, 0.3 * reader.scene.edge))
        noun = replace(noun, distance=None)
    modifiers = points_together(_separate(noun.modifiers))
    for place, modifier in enumerate(modifiers):
        if place + 1 < len(modifiers) and (counted := counting_off(reader, noun, modifier)) is not None:
            effects += counted
            continue
        if noun.distance and (reference := _complement(modifier)) is not None:
            away = "from" in modifier.text.split()
            found = by_distance(reader, read_noun(reference), noun.distance, None, away=away)
            if found:
                noun = replace(noun, distance=None)
                effects += found
                continue
        effects += reader.effects(modifier, base)
    return noun, effects


def _separate(modifiers: Sequence[Phrase]) -> list[Phrase]:
    """Modifiers, those one by one that "and" joins to a complement: "from you and next to a red one"."""
    found: list[Phrase] = []
    for modifier in modifiers:
        parts = modifier.phrases
        joined = modifier.tag == "PP" and len(parts) > 1 and all(part.tag == "PP" for part in parts)
        if joined and all(word.tag == "CC" for word in modifier.words) and _complement(parts[0]) is not None:
            found += parts
        else:
            found.append(modifier)
    return found


def _complement(modifier: Phrase) -> Phrase | None:
    """The noun phrase of "to X" and "from X", nothing else before it."""
    texts = [word.text for word in modifier.words]
    if modifier.tag == "PP" and texts in (["to"], ["from"], ["away", "from"]) and len(modifier.phrases) == 1:
        return modifier.phrases[0] if modifier.phrases[0].tag == "NP" else None
    return None
