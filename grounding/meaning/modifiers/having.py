"""Modifiers that say what something has beside it: "that has a red block to its left", "with a tower"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.meaning.nouns import read_noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import OBJECTS, SETS, Condition


def having(reader: Reads, possession: Phrase) -> list[Condition]:
    """What has X "to its left" lies to the right of X; else it is near X."""
    noun = read_noun(possession)
    plain = replace(noun, modifiers=tuple(m for m in noun.modifiers if not of_itself(m)))
    reference = reader.refer(plain)
    if reference.sort not in (OBJECTS, SETS):
        return []
    found: list[Condition] = []
    for modifier in noun.modifiers:
        if of_itself(modifier):
            opposite = tuple(w.OPPOSITE[name] for leaf in modifier.leaves for name in w.directions(leaf.text))
            found.append(Condition("toward", (reference,), opposite, said="has"))
    return found or [Condition("beside", (reference,), said="has")]


def of_itself(modifier: Phrase) -> bool:
    """Whether a modifier relates to the thing itself: "to its left"."""
    texts = [leaf.text for leaf in modifier.leaves]
    return bool({"its", "it"} & set(texts)) and any(w.directions(text) for text in texts)


def possessions(children: Sequence[Phrase]) -> list[Phrase]:
    """The complements of "has", where a side of the one that has was parsed beside what it has there."""
    found: list[Phrase] = []
    for child in children:
        if found and found[-1].tag == "NP" and child.tag == "PP" and of_itself(child):
            found[-1] = Phrase("NP", (found[-1], child))
        else:
            found.append(child)
    return found
