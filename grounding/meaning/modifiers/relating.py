"""What a modifier that names one relation says: its readings in their order."""

from __future__ import annotations

from dataclasses import replace

from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.meaning.modifiers.by_reference import BY_REFERENCE, directed
from grounding.meaning.modifiers.by_words import BY_WORDS, by_itself
from grounding.meaning.modifiers.heard import Heard, hear
from grounding.meaning.nouns import Noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import Condition


def relate(reader: Reads, phrase: Phrase, head: Noun, further: tuple[str, ...] = ()) -> list[Condition]:
    """What a modifier says.

    Args:
        reader: that reads what it relates to.
        phrase: the modifier.
        head: the noun that is modified.
        further: directions that were said before and share the reference.
    """
    heard = hear(phrase, further)
    if heard.nested is not None:
        return [_narrowed(condition, heard) for condition in reader.conditions(heard.nested, head)]
    noun = heard.noun
    if heard.said.lone or (noun is not None and noun.lone and not noun.colors and not noun.modifiers):
        return [Condition("alone")]
    if noun is None or (noun.head == "table" and (heard.said.directions or heard.said.distance)):
        return by_itself(reader, heard)
    if _is_middle_line(heard, noun):
        noun = replace(noun, head="place")
    for by_words in BY_WORDS:
        if (found := by_words(reader, heard, noun)) is not None:
            return found
    noun = directed(heard, noun)
    reference = reader.refer(noun)
    part = next((c for c in reference.conditions if c.concept == "part"), None)
    if head.ordinals and heard.last == "from" and part is not None and part.region is not None:
        counted = replace(part.region, rim=False, bare=True)  # "the second block" "from the top of the tower"
        return [Condition("extreme", region=counted), Condition("member", part.of)]
    if _is_elliptic(heard):
        reference = replace(reference, like=True)
    for by_reference in BY_REFERENCE:
        if (found := by_reference(reader, heard, noun, reference)) is not None:
            return found
    return []


def _narrowed(condition: Condition, heard: Heard) -> Condition:
    """A condition with what stands before its phrase: "almost" "touching X", "directly" "behind X"."""
    if condition.concept == "touching" and any(w.is_nearly(text) for text in heard.texts):
        return replace(condition, nearly=True)
    if condition.concept in ("toward", "off_middle", "beside") and heard.strict:
        return replace(condition, strict=True)
    return condition


def _is_elliptic(heard: Heard) -> bool:
    """Whether only a number is named: "of the three", which are of the kind of what is modified."""
    noun = heard.noun
    return noun is not None and heard.child is not None and noun.head == "block" and noun.plural and not any(
        w.is_block(leaf.text) or w.containers(leaf.text) for leaf in heard.child.leaves
    )


def _is_middle_line(heard: Heard, noun: Noun) -> bool:
    """Whether something is measured from a line that nothing lies along: "right of the center line"."""
    told = noun.number or noun.directions or noun.ordinals or noun.colors or noun.modifiers
    measured = heard.said.directions or any(w.is_ranking(text) for text in heard.texts)
    return noun.head == "container" and noun.middle and bool(measured) and not told and noun.text.endswith(" line")
