"""What a noun of things says by itself and by its modifiers, as conditions."""

from __future__ import annotations

from grounding.meaning.modifiers.attached import attached
from grounding.meaning.modifiers.ranking import FARTHEST, NEAREST, person_of
from grounding.meaning.nouns import Noun
from grounding.meaning.reading import Reads
from grounding.meaning.referents import Condition, Region, again


def own_conditions(reader: Reads, noun: Noun) -> list[Condition]:
    """The conditions of a noun: what restricts it, then its modifiers, then what selects within."""
    bare, modifying = attached(reader, noun)
    found: list[Condition] = []
    if noun.colors:
        found.append(Condition("colour", words=noun.colors))
    if noun.types:
        found.append(Condition("kind", words=noun.types))
    if noun.strange:
        found.append(Condition("strange", said=noun.unknown[-1]))
    found += modifying
    if bare.lone:
        found.append(Condition("alone", counting=bare.unstacked))
    if bare.other:
        mentioned = reader.context.mentioned
        found.append(Condition("other", () if mentioned is None else (again(mentioned),), words=noun.colors))
    return found + selectors(bare)


def selectors(noun: Noun) -> list[Condition]:
    """What the words of a noun rank by: "nearest", "leftmost", "top left", "third", "middle"."""
    found: list[Condition] = []
    if noun.directions:
        region = Region(noun.directions, noun.middle, len(noun.directions) > 1, bare=True, owner=noun.agent)
        found.append(Condition("extreme", region=region))
    if noun.distance and not (noun.distance == "far" and noun.directions):  # "the farthest left" is the leftmost
        concept = NEAREST if noun.distance == "near" else FARTHEST
        found.append(Condition(concept, (person_of(noun),), said=noun.distance))
    found += [Condition("ordinal", rank=rank) for rank in noun.ordinals]
    if noun.middle and not noun.directions:
        found.append(Condition("middle"))
    if noun.size:
        found.append(Condition("size", number=float(noun.size), said=noun.sized))
    return found
