"""What a place is a part of: "the end of the row", "its left", "the middle of the table"."""

from __future__ import annotations

from grounding.lexicon.words import is_layout, is_rim, is_table
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import Condition, Referent, Region, again

_OF = (["of"], ["in"], ["from"])


def whole_of(reader: Reads, noun: Noun) -> Referent | None:
    """What a place is a part of; None where its words do not say so."""
    mentioned = reader.context.mentioned
    if mentioned is not None and noun.text.split(" ", 1)[0] == "its":
        return again(mentioned)
    whole = noun_of_whole(noun)
    return None if whole is None else reader.refer(whole)


def noun_of_whole(noun: Noun) -> Noun | None:
    """The noun of what a place is a part of."""
    for modifier in noun.modifiers:
        if modifier.tag == "PP" and [word.text for word in modifier.words][-1:] in _OF:
            for child in modifier.phrases:
                return read_noun(child)
    return None


def region_of(noun: Noun, further: Region | None = None) -> Region:
    """The place that a noun names, within another one where that is said: "the middle of the left edge"."""
    names = list(noun.directions)
    if not names and noun.agent and not noun.middle:
        names = ["front"]  # "your side"
    if further is not None:
        names += [name for name in further.names if name not in names]
    middle = noun.middle or (further is not None and further.middle)
    rim = any(is_rim(word) for word in noun.text.split())
    whole = noun_of_whole(noun)
    texts = noun.text.split()
    table = (whole is not None and whole.head == "table") or any(is_table(text) for text in texts[:-1])
    table = table and not any(is_layout(text) for text in texts)
    return Region(tuple(names), middle, noun.place == "corner", rim, noun.place is None, noun.agent, table)


def at(region: Region, said: str = "") -> Condition:
    """To lie in a place."""
    return Condition("at", region=region, said=said)
