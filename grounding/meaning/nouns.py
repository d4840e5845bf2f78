"""Noun phrases, read for what they ask: a head, what restricts it, what selects within, and its modifiers."""

from __future__ import annotations

from dataclasses import dataclass, replace

from grounding.language.tree import Phrase, Word
from grounding.lexicon import words as w
from grounding.meaning.noun_words import NounWords

_KEPT = "noun"


@dataclass(frozen=True)
class Noun:
    """What a noun phrase says.

    Attributes:
        head: block, container, place, table, agent, pronoun, measure, or other.
        kinds: of container.
        types: of things: "pyramid" of "the red prism".
        place: "side" or "corner".
        colors: asked for; one of them is enough.
        number: how many, or None.
        counted: how many of each colour, where several colours are named: "three green and one blue block".
        plural: whether several are meant.
        ordinals: ranks, -1 for the last.
        distance: "near" or "far", a rank by distance.
        far: whether "far" is said, of a place or a thing.
        directions: that words before the head name.
        middle: whether the middle is asked for.
        lone: whether it stands apart.
        unstacked: whether that means only that it is not part of a stack: "the single block".
        other: whether what was spoken of is excluded.
        only: whether it is the only one.
        sized: the word for a size that was said of a thing; where all are of one size it tells a tower, or one alone.
        size: 1 for the largest arrangement, -1 for the smallest.
        agent: who is meant by a pronoun, or whose side it is.
        definite: False after "a", "some".
        universal: "all", "both".
        unknown: words that say nothing here.
        strange: whether the thing itself is named by a word that nobody knows.
        modifiers: phrases after the head.
        conjoined: further noun phrases joined with "and".
        text: its words.
    """

    head: str = "other"
    kinds: tuple[str, ...] = ()
    types: tuple[str, ...] = ()
    place: str | None = None
    colors: tuple[str, ...] = ()
    number: int | None = None
    counted: tuple[tuple[int | None, str], ...] = ()
    plural: bool = False
    ordinals: tuple[int, ...] = ()
    distance: str | None = None
    far: bool = False
    directions: tuple[str, ...] = ()
    middle: bool = False
    lone: bool = False
    unstacked: bool = False
    other: bool = False
    only: bool = False
    size: int = 0
    sized: str = ""
    agent: str | None = None
    definite: bool = True
    universal: bool = False
    unknown: tuple[str, ...] = ()
    strange: bool = False
    modifiers: tuple[Phrase, ...] = ()
    conjoined: tuple[Phrase, ...] = ()
    text: str = ""


def read_noun(phrase: Phrase) -> Noun:
    """Read a noun phrase; nested heads are read as one. What was read is kept with the phrase, which is immutable."""
    kept: dict[str, object] = phrase.__dict__
    noun = kept.get(_KEPT)
    if not isinstance(noun, Noun):
        noun = kept[_KEPT] = _as_set(_read(phrase))
    return noun


def is_measuring(noun: Noun) -> bool:
    """Whether a noun may only tell how far: "two blocks", "half a block"."""
    told = noun.colors or noun.modifiers or noun.ordinals or noun.directions or noun.distance or noun.lone
    return noun.head == "measure" or (noun.head == "block" and noun.number is not None and not noun.definite) or (
        noun.head == "block" and noun.number is not None and not told and not noun.text.startswith("the ")
    )


def _as_set(noun: Noun) -> Noun:
    """A grid that is told from others is one of blocks: "the green grid", "a grid of six"."""
    grid = noun.head == "table" and any(w.is_layout(text) for text in noun.text.split())
    made = any(m.leaves[0].text in ("of", "with") and len(m.leaves) > 1 for m in noun.modifiers)
    if grid and (noun.colors or noun.number or made):
        return replace(noun, head="container", kinds=("group",))
    return noun


def _read(phrase: Phrase) -> Noun:
    inner = [child for child in phrase.phrases if child.tag == "NP"]
    conjunction = any(word.tag == "CC" or word.text in ("and", "or") for word in phrase.words)
    if inner and conjunction and len(inner) > 1:
        joined = _extended(inner[0], inner[1:])
        if joined is not None:
            return read_noun(joined)
        parts = tuple(inner)
        first = read_noun(parts[0])
        rest = tuple(child for child in phrase.phrases if child.tag != "NP")
        nouns = [read_noun(part) for part in parts]
        if all(noun.head == "place" and noun.directions and not noun.modifiers for noun in nouns):
            names = tuple(dict.fromkeys(name for noun in nouns for name in noun.directions))
            return replace(first, directions=names, modifiers=rest, text=phrase.text)  # "the back and the right"
        return replace(first, conjoined=parts, modifiers=rest, text=phrase.text)
    own = read_words(phrase.words)
    if not inner:
        return replace(own, modifiers=_following(own.modifiers, phrase.phrases), text=phrase.text)
    head = read_noun(inner[0])
    others = tuple(child for child in phrase.phrases if child is not inner[0])
    return replace(_merged(head, own), modifiers=_following(head.modifiers, others), text=phrase.text)


def _following(before: tuple[Phrase, ...], after: tuple[Phrase, ...]) -> tuple[Phrase, ...]:
    """Modifiers in order; a bare direction takes what "of" names: "the box southwest" "of the tower"."""
    of = bool(before and after) and [word.text for word in after[0].words] == ["of"]
    named = before[-1].phrases if of else ()
    if of and len(named) == 1 and named[0].tag == "NP" and not named[0].phrases and _is_side(named[0]):
        whole = Phrase("NP", (named[0], after[0]))  # "to right" "of the tower"
        return (*before[:-1], Phrase("PP", (*before[-1].words, whole)), *after[1:])
    if of and not named and any(w.directions(word.text) for word in before[-1].words):
        return (*before[:-1], Phrase("PP", (*before[-1].children, *after[0].children)), *after[1:])
    return (*before, *after)


def _is_side(noun: Phrase) -> bool:
    """Whether a noun phrase names nothing but directions: "right", "the top"."""
    return all(w.directions(word.text) or word.tag == "DT" for word in noun.words)


def _extended(phrase: Phrase, further: list[Phrase]) -> Phrase | None:
    """A noun phrase whose last modifier asks for several, with what was joined to the whole: "between X" "and Y"."""
    children = phrase.children
    if not children or not isinstance(children[-1], Phrase):
        return None
    last = children[-1]
    if last.tag == "PP" and any(w.is_between(v.text) or w.is_surrounded(v.text) for v in last.words):
        inner = last.children[-1]
        if not isinstance(inner, Phrase) or inner.tag != "NP" or any(v.tag == "CC" for v in inner.words):
            return None
        joiner = Word("and", "CC", inner.leaves[-1].index + 1)
        together = Phrase("NP", (inner, joiner, *further))
        return Phrase(phrase.tag, (*children[:-1], Phrase("PP", (*last.children[:-1], together))))
    deeper = _extended(last, further)
    return None if deeper is None else Phrase(phrase.tag, (*children[:-1], deeper))


def read_words(leaves: tuple[Word, ...]) -> Noun:
    """Read the words of a base noun phrase."""
    found = NounWords()
    for place, word in enumerate(leaves):
        found.take(word, last=place == len(leaves) - 1)
    return Noun(**found.told(), text=" ".join(word.text for word in leaves))


def _merged(head: Noun, own: Noun) -> Noun:
    """A head with what is said before it."""
    return replace(
        head,
        colors=head.colors or own.colors,
        types=head.types or own.types,
        number=head.number or own.number,
        ordinals=head.ordinals or own.ordinals,
        distance=head.distance or own.distance,
        far=head.far or own.far,
        directions=(*own.directions, *head.directions),
        middle=head.middle or own.middle,
        lone=head.lone or own.lone,
        unstacked=head.unstacked or own.unstacked,
        other=head.other or own.other,
        unknown=(*own.unknown, *head.unknown),
        universal=head.universal or own.universal,
        head=own.head if head.head == "other" else head.head,
        kinds=head.kinds or own.kinds,
        strange=head.strange and own.head == "other",
    )
