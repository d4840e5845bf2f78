"""What a modifier that names one relation does: its readings in their order."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from grounding.graded.modifiers.by_reference import BY_REFERENCE
from grounding.graded.modifiers.by_words import BY_WORDS, by_itself
from grounding.graded.modifiers.heard import Heard, hear
from grounding.graded.surroundings import lone
from grounding.graded.values import Effect, Restriction, Value
from grounding.language.tree import Phrase
from grounding.lexicon import colour
from grounding.lexicon import words as w
from grounding.meaning.nouns import Noun
from grounding.world import Array

if TYPE_CHECKING:
    from grounding.graded.reader import Reader


def relate(reader: Reader, phrase: Phrase, base: Array, further: tuple[str, ...] = ()) -> list[Effect]:
    """What a modifier does to the objects of the noun that it follows.

    Args:
        reader: that reads what it relates to.
        phrase: the modifier.
        base: how well every object agrees with the noun, shape (n,).
        further: directions that were said before and share the reference.
    """
    heard = hear(phrase, base, further)
    if heard.nested is not None:
        return reader.effects(heard.nested, base)
    noun = heard.noun
    if heard.said.lone or (noun is not None and noun.lone and not noun.colors and not noun.modifiers):
        return [Restriction(lone(reader.scene, base))]
    if noun is None or (noun.head == "table" and (heard.said.directions or heard.said.distance)):
        return by_itself(reader, heard)
    if _is_middle_line(heard, noun):
        noun = replace(noun, head="place")
    for by_words in BY_WORDS:
        if (found := by_words(reader, heard, noun)) is not None:
            return found
    noun = _directed(heard, noun)
    value = _among_the_same(reader, heard, noun) if _is_elliptic(heard) else reader.noun(noun)
    for by_reference in BY_REFERENCE:
        if (found := by_reference(reader, heard, noun, value)) is not None:
            return found
    return []


def _is_elliptic(heard: Heard) -> bool:
    """Whether only a number is named: "of the three"."""
    noun = heard.noun
    return noun is not None and heard.child is not None and noun.head == "block" and noun.plural and not any(
        w.is_block(leaf.text) or w.containers(leaf.text) for leaf in heard.child.leaves
    )


def _among_the_same(reader: Reader, heard: Heard, noun: Noun) -> Value:
    """What several mean that are of the kind of what is modified: "the red block ... of the three" red blocks."""
    return reader.chosen(noun, colour.truth(reader.scene, noun.colors) * heard.base)


def _is_middle_line(heard: Heard, noun: Noun) -> bool:
    """Whether something is measured from a line that nothing lies along: "right of the center line"."""
    told = noun.number or noun.directions or noun.ordinals or noun.colors or noun.modifiers
    measured = heard.said.directions or any(w.is_ranking(text) for text in heard.texts)
    return noun.head == "container" and noun.middle and bool(measured) and not told and noun.text.endswith(" line")


def _directed(heard: Heard, noun: Noun) -> Noun:
    """A bare place takes the directions before it: "behind and to the left"."""
    if noun.head == "place" and noun.place is None and not noun.middle and not noun.agent:
        return replace(noun, directions=(*noun.directions, *heard.directions()))
    return noun
