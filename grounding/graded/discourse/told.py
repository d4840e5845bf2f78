"""What a text has told so far, and how a noun or a modifier that is heard next changes it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from grounding.graded.reader import Reader
from grounding.graded.values import Membership, Rank, Restriction
from grounding.language.tree import Phrase
from grounding.lexicon import degrees
from grounding.meaning.discourse.told import is_informative, with_further
from grounding.meaning.discourse.verbs import LOOKING
from grounding.meaning.nouns import Noun, read_noun
from grounding.world import Array

_KEPT = 0.1  # of what was told before, so much is left of what does not agree with what follows
_STATED = 0.05  # the same after a statement
_OUTSIDE = 0.15  # who speaks of several and then of one mostly means one of them


@dataclass
class Told:
    """What a text has told so far.

    Attributes:
        target: how well each object is what shall be handled, shape (n,), or None.
        sets: where several are.
        mentioned: what was spoken of last, shape (n,), or None.
        mentioned_sets: where that were several.
        plural: whether that were several.
        kind: of action.
        destination: phrases that tell where to, the words of their clauses as phrases of their own.
        doubt: pieces that were not used.
        continued: whether a further clause says what shall be done with "it".
        whole: the text, in which a destination is looked for where no phrase was told apart.
    """

    target: Array | None = None
    sets: tuple[tuple[np.ndarray, float], ...] = ()
    mentioned: Array | None = None
    mentioned_sets: tuple[tuple[np.ndarray, float], ...] = ()
    plural: bool = False
    kind: str = "pick"
    destination: list[Phrase] = field(default_factory=list)
    doubt: int = 0
    continued: bool = False
    whole: Phrase | None = None


def one_of(noun: Noun, told: Told) -> Noun:
    """A rank or side without a noun is one of those that were spoken of: "the lower", "the second"."""
    bare = noun.head in ("place", "other") and noun.place is None
    if told.mentioned is not None and told.plural and bare and (noun.directions or noun.middle or noun.ordinals):
        return replace(noun, head="block")
    return noun


def take(noun: Noun, reader: Reader, told: Told, context: Array | None = None) -> None:
    """Something to be handled is named.

    Args:
        noun: that names it.
        reader: of the scene.
        told: so far.
        context: what "it" and "its" are within the noun, shape (n,), where that is not what was spoken of before.
    """
    if noun.head == "pronoun" or (noun.head == "block" and not is_informative(noun) and not noun.plural):
        _take_again(noun, reader, told)
        return
    before = told.mentioned if told.mentioned is not None else told.target
    reader.context = before if context is None else context
    reader.several = told.mentioned is not None and told.plural
    whole = told.kind == "clear" and noun.head in ("place", "table")
    value = reader.everything_in(noun) if whole else reader.noun(noun)
    if value.kind not in ("objects", "sets"):
        told.doubt += 1
        return
    if noun.head == "container" and not noun.plural:  # nobody picks up a row of one
        several = tuple(item for item in value.sets if int(item[0].sum()) > 1)
        if not several:
            told.doubt += 1
            return
        value = replace(value, sets=several)
    weights = value.weights
    if told.mentioned is not None and told.plural and noun.head == "block" and context is None:
        inside = told.mentioned > 0.3 * degrees.peak(told.mentioned)
        fainter = 1.0 if _excludes(noun) else _OUTSIDE
        weights = np.maximum(weights * np.where(inside, 1.0, fainter), reader.within(noun, told.mentioned))
    if told.target is not None:
        weights = weights * _agreed(told.target / degrees.peak(told.target))
    told.target = weights
    told.sets = value.sets if value.kind == "sets" else ()


def _excludes(noun: Noun) -> bool:
    """Whether a noun says what it is not: "the one that is not in that row"."""
    return any(leaf.text in ("not", "n't", "outside") for modifier in noun.modifiers for leaf in modifier.leaves)


def _take_again(noun: Noun, reader: Reader, told: Told) -> None:
    """What was spoken of is named again, by "it" or "the block"; else what was handled before."""
    if told.target is not None:
        return
    if told.mentioned is not None:
        told.target = told.mentioned
    elif noun.head == "block" or reader.history:
        told.target = reader.value_of(noun)


def _agreed(held: Array) -> Array:
    """How much is left of what was told, where it holds only to a degree of what follows."""
    return np.asarray(_KEPT + (1 - _KEPT) * held)


def mention(noun: Noun, reader: Reader, told: Told) -> None:
    """Something is spoken of before it is said what to do."""
    reader.context = told.mentioned
    reader.several = told.plural
    value = reader.noun(noun)
    if value.kind in ("objects", "sets") and value.weights.any():
        told.mentioned = value.weights / float(value.weights.max())
        told.mentioned_sets = value.sets if value.kind == "sets" else ()
        told.plural = value.kind == "sets"


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
    value = reader.noun(noun)
    if value.kind in ("objects", "sets") and value.weights.any() and told.target is not None:
        told.target = told.target * (1.0 - 0.9 * value.weights / float(value.weights.max()))


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
        told.target = told.target * (_STATED + (1 - _STATED) * previous / degrees.peak(previous))
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
    for effect in reader.effects(piece, told.target / degrees.peak(told.target)):
        if isinstance(effect, Restriction):
            told.target = told.target * _agreed(effect.weights)
        elif isinstance(effect, Membership):
            told.target = told.target * _agreed(np.max([mask * chance for mask, chance in effect.sets[:4]], axis=0))
        elif isinstance(effect, Rank):
            told.target = reader.ranked_again(told.target, effect)


def _begin(piece: Phrase, reader: Reader, told: Told) -> None:
    """A text begins with a piece: it names something, or tells where it is."""
    if piece.tag == "NP":
        name(piece, reader, told)
    if piece.tag not in ("PP", "SBAR"):
        return
    everything = np.ones(reader.scene.n)
    for effect in reader.effects(piece, everything):
        if isinstance(effect, Restriction) and effect.weights.any():
            told.target = effect.weights
        elif isinstance(effect, Rank):
            told.target = reader.ranked_again(everything, effect)
        elif isinstance(effect, Membership) and effect.sets:
            told.mentioned, told.plural = effect.sets[0][0].astype(float), True
