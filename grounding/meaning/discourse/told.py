"""What a text has told so far, and how a noun or a modifier that is heard next changes it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from grounding.language.tree import Phrase
from grounding.meaning.discourse.verbs import LOOKING
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import OBJECTS, SETS, Condition, Referent, again

_THINGS = (OBJECTS, SETS)


@dataclass
class Told:
    """What a text has told so far.

    Attributes:
        target: what shall be handled, or None.
        mentioned: what was spoken of last, or None.
        plural: whether that were several.
        kind: of action.
        destination: phrases that tell where to, the words of their clauses as phrases of their own.
        doubt: pieces that were not used.
        continued: whether a further clause says what shall be done with "it".
        whole: the text, in which a destination is looked for where no phrase was told apart.
    """

    target: Referent | None = None
    mentioned: Referent | None = None
    plural: bool = False
    kind: str = "pick"
    destination: list[Phrase] = field(default_factory=list)
    doubt: int = 0
    continued: bool = False
    whole: Phrase | None = None


def is_informative(noun: Noun) -> bool:
    """Whether a noun says more than that it is a thing."""
    return bool(noun.colors or noun.modifiers or noun.directions or noun.ordinals or noun.distance or noun.middle
                or noun.lone or noun.number or noun.size)  # fmt: skip


def with_further(noun: Noun, *modifiers: Phrase) -> Noun:
    """A noun with further modifiers."""
    return replace(noun, modifiers=(*noun.modifiers, *modifiers))


def one_of(noun: Noun, told: Told) -> Noun:
    """A rank or side without a noun is one of those that were spoken of: "the lower", "the second"."""
    bare = noun.head in ("place", "other") and noun.place is None
    if told.mentioned is not None and told.plural and bare and (noun.directions or noun.middle or noun.ordinals):
        return replace(noun, head="block")
    return noun


def take(noun: Noun, reader: Reader, told: Told, context: Referent | None = None) -> None:
    """Something to be handled is named.

    Args:
        noun: that names it.
        reader: of the text.
        told: so far.
        context: what "it" and "its" are within the noun, where that is not what was spoken of before.
    """
    if noun.head == "pronoun" or (noun.head == "block" and not is_informative(noun) and not noun.plural):
        _take_again(noun, reader, told)
        return
    before = told.mentioned if told.mentioned is not None else told.target
    with reader.within(before if context is None else context, several=told.mentioned is not None and told.plural):
        found = _everything_in(noun, reader) if _clears(noun, told) else reader.refer(noun)
    if found.sort not in _THINGS:
        told.doubt += 1
        return
    if told.mentioned is not None and told.plural and noun.head == "block" and context is None:
        found = _among(found, noun, told.mentioned)
    if told.target is not None:
        found = found.having(Condition("same", (told.target,), said="told"))
    told.target = found


def _clears(noun: Noun, told: Told) -> bool:
    return told.kind == "clear" and noun.head in ("place", "table")


def _everything_in(noun: Noun, reader: Reader) -> Referent:
    """All that lies on the table or on a side of it: what "clear the left side" means."""
    place = reader.refer(noun)
    inside = () if place.region is None else (Condition("at", region=place.region, said="clear"),)
    return Referent(SETS, inside, plural=True, universal=True, text=noun.text)


def _among(found: Referent, noun: Noun, mentioned: Referent) -> Referent:
    """One of those that were spoken of, unless the noun already says of which, or excludes them."""
    if any(condition.concept == "those" for condition in found.conditions) or _excludes(noun):
        return found
    return found.having(Condition("those", (mentioned,), said="told"))


def _excludes(noun: Noun) -> bool:
    """Whether a noun says what it is not: "the one that is not in that row"."""
    return any(leaf.text in ("not", "n't", "outside") for modifier in noun.modifiers for leaf in modifier.leaves)


def _take_again(noun: Noun, reader: Reader, told: Told) -> None:
    """What was spoken of is named again, by "it" or "the block"; else what was handled before."""
    if told.target is not None:
        return
    if told.mentioned is not None:
        told.target = told.mentioned
    elif noun.head == "block" or reader.context.handled:
        with reader.within(None):
            told.target = reader.refer(noun)


def mention(noun: Noun, reader: Reader, told: Told) -> None:
    """Something is spoken of before it is said what to do."""
    before = told.mentioned if told.plural else None
    with reader.within(told.mentioned, several=told.plural):
        found = reader.refer(noun)
    if before is not None and found.sort == SETS and noun.head == "container" and not noun.plural:
        found = found.having(Condition("member", (before,), said="told"))  # "the grid of six: its far row"
    if found.sort in _THINGS:
        told.mentioned = found
        told.plural = found.sort == SETS


def name(phrase: Phrase, reader: Reader, told: Told) -> None:
    """A noun phrase by itself names the target."""
    noun = one_of(read_noun(phrase), told)
    if noun.head == "other" and any(text in LOOKING for text in noun.unknown):
        inner = [p for m in noun.modifiers for p in m.phrases if p.tag == "NP"]
        if inner:
            mention(read_noun(inner[0]), reader, told)
            return
    take(noun, reader, told)


def deny(subject: Noun, nouns: Sequence[Noun], rest: Iterable[Phrase], reader: Reader, told: Told) -> None:
    """For example "it is not the one next to the tower"."""
    noun = with_further(nouns[0] if nouns else replace(subject, head="block"), *rest)
    with reader.within(told.mentioned if told.mentioned is not None else told.target):
        denied = reader.refer(noun)
    if denied.sort in _THINGS and told.target is not None:
        told.target = again(told.target, Condition("same", (denied,), negated=True))


def state(subject: Noun, nouns: Sequence[Noun], rest: Iterable[Phrase], reader: Reader, told: Told) -> None:
    """For example "the block is on the left", "it is the red one next to the tower"."""
    named = nouns[0] if nouns and nouns[0].head in ("block", "container", "place") else subject
    noun = with_further(named, *rest)
    if nouns and noun.head == "place":
        noun = replace(subject, directions=noun.directions, middle=noun.middle, modifiers=noun.modifiers)
    if noun.head == "pronoun":
        noun = replace(noun, head="block")
    if noun.head != "block":
        return
    mentioned = told.mentioned
    previous = mentioned if told.target is None and not told.plural else told.target
    told.target = told.mentioned = None
    take(noun, reader, told)
    told.mentioned = mentioned
    if previous is not None and told.target is not None:
        told.target = told.target.having(Condition("same", (previous,), said="stated"))
    elif told.target is None:
        told.target = previous


def add(piece: Phrase, reader: Reader, told: Told) -> None:
    """A piece that belongs to what was named before it."""
    if told.destination and told.kind == "place":
        told.destination.append(piece)
        return
    if told.target is None:
        _begin(piece, reader, told)
        return
    with reader.within(told.mentioned if told.mentioned is not None else told.target):
        conditions = reader.conditions(piece, Noun(head="block"))
    if conditions:
        told.target = again(told.target, *conditions)


def _begin(piece: Phrase, reader: Reader, told: Told) -> None:
    """A text begins with a piece: it names something, or tells where it is."""
    if piece.tag == "NP":
        name(piece, reader, told)
    if piece.tag not in ("PP", "SBAR"):
        return
    conditions = reader.conditions(piece, Noun(head="block"))
    if not conditions:
        return
    if all(condition.chooses for condition in conditions) and conditions[0].of:
        told.mentioned, told.plural = conditions[0].of[0], True
    else:
        of = (Condition("those", (told.mentioned,), said="told"),) if told.mentioned is not None and told.plural else ()
        told.target = Referent(OBJECTS, (*conditions, *of), text=piece.text)
