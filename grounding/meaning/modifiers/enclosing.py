"""Modifiers that say among what something lies: "between the towers", "surrounded by three red blocks and a cube"."""

from __future__ import annotations

from dataclasses import replace

from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import OBJECTS, Condition, Referent


def enclosing(reader: Reads, noun: Noun) -> tuple[Referent, ...]:
    """What encloses, part by part: "two green blocks and the blue one"; any that a plural may mean counts."""
    if noun.conjoined:
        return tuple(part for phrase in noun.conjoined for part in enclosing(reader, read_noun(phrase)))
    if len(noun.counted) > 1:
        return tuple(
            Referent(OBJECTS, (Condition("colour", words=(color,)),), number=number, plural=number != 1,
                     definite=False, text=color) for number, color in noun.counted
        )  # fmt: skip
    selected = noun.ordinals or noun.distance or noun.directions or noun.head != "block"
    found = reader.refer(noun if selected else replace(noun, plural=False, number=None, universal=False))
    several = noun.plural or noun.head != "block"
    return (replace(found, number=noun.number or (None if several else 1), plural=several),)
