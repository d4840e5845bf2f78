"""Lengths and ways within the phrases of a destination: "two spaces", "up two spaces", "half a block above X"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.meaning.nouns import Noun, read_noun
from grounding.symbols import Cardinal, Ordinal

LINES = frozenset("row rows column columns line lines level levels".split())
"""Nouns of arrangements that also measure how far."""
_DECIMAL = re.compile(r"\d+\.\d+|\.\d+")
_AMOUNTS = {"half": 0.5, "quarter": 0.25, "couple": 2.0, "few": 2.5, "several": 3.0, "twice": 2.0, "once": 1.0}
_DEFINITE = frozenset("the this that these those both all".split())
_RESULTS = frozenset("so until making creating forming where such".split())
_RELATING = frozenset("between on onto of touching touches touch next with by beside near against atop among".split())
_THINGS = ("block", "container", "pronoun", "table")


class Metres(float):
    """A length in metres; other lengths count blocks."""


def number(text: str) -> float | None:
    """The number that a word says, parts included."""
    if text in _AMOUNTS:
        return _AMOUNTS[text]
    if _DECIMAL.fullmatch(text):
        return float(text)
    return next((float(s.value) for s in meanings(text) if isinstance(s, Cardinal)), None)


def ordinal(text: str) -> int:
    """The rank that a word says, from 1; 0 where it says none."""
    return next((s.value for s in meanings(text) if isinstance(s, Ordinal) and s.value > 0), 0)


def stories(noun: Noun) -> int:
    """The height of the tower that a noun asks for, in blocks; 0 where it does not say."""
    if noun.number:
        return noun.number
    counts = (number(m.leaves[1].text) for m in noun.modifiers if m.leaves[0].text == "of" and len(m.leaves) > 1)
    return int(next((value for value in counts if value), 0))


def peeled(noun: Noun) -> tuple[Noun, list[Phrase]]:
    """A noun without what says how far to go from it or what shall come about: "the tower" "up two spaces"."""
    if noun.conjoined and all(is_length(read_noun(p), p.text.split()) or number(p.text) for p in noun.conjoined[1:]):
        first, ways = peeled(read_noun(noun.conjoined[0]))
        if ways:
            return first, [*ways, *noun.conjoined[1:], *noun.modifiers]
    apart = [m for m in noun.modifiers if is_course(m)]
    kept = tuple(m for m in noun.modifiers if m not in apart)
    return (replace(noun, modifiers=kept) if apart else noun), apart


def is_course(phrase: Phrase) -> bool:
    """Tells whether a phrase tells a way to go: directions and lengths, and no thing."""
    first = phrase.leaves[0].text
    if first in _RESULTS or (first in ("in", "at") and len(phrase.leaves) > 2 and w.is_measure(phrase.leaves[2].text)):
        return True
    nouns = [p for p in phrase.preorder() if p.tag == "NP"]
    if first == "by" and nouns and all(is_length(read_noun(p), [leaf.text for leaf in p.leaves]) for p in nouns):
        return True
    lengths = [is_length(read_noun(p), [leaf.text for leaf in p.leaves]) for p in nouns]
    things = any(
        not length and not p.phrases and read_noun(p).head in _THINGS for p, length in zip(nouns, lengths, strict=True)
    )
    return any(lengths) and not things and any(w.directions(leaf.text) for leaf in phrase.leaves)


def is_length(noun: Noun, texts: list[str]) -> bool:
    """Tells whether a noun phrase may be a distance: "two spaces", "half a block", "one row"."""
    bare = not (noun.colors or noun.modifiers or noun.ordinals or noun.distance or noun.lone or noun.other)
    counted = any(number(text) is not None for text in texts) or texts[:1] in (["a"], ["an"])
    if not (bare and counted) or _DEFINITE & set(texts):
        return False
    if noun.head == "measure" or noun.head == "other":
        return noun.head == "measure" or all(number(text) is not None for text in texts)
    if noun.head == "container":
        return texts[-1] in LINES and not noun.directions and not noun.middle and texts[0] not in ("a", "an")
    numbered = any(number(text) is not None for text in texts)
    return noun.head == "block" and numbered and not noun.directions and not noun.middle


def opens_distance(phrase: Phrase, noun: Noun, before: Sequence[str]) -> bool:
    """Tells whether a noun phrase says how far from something: "two blocks" "above the tower", "one" "left of X".

    Args:
        phrase: the noun phrase.
        noun: as it was read.
        before: the two words before it.
    """
    if noun.head not in ("block", "measure", "other") or not noun.modifiers or noun.colors or noun.conjoined:
        return False
    base = phrase
    while base.phrases and base.phrases[0].tag == "NP" and base.children[0] is base.phrases[0]:
        base = base.phrases[0]
    texts = [word.text for word in base.words]
    if not texts or number(texts[0]) is None and texts[0] not in ("a", "an", "about"):
        return False
    plain = all(
        number(t) is not None or t in ("a", "an", "about", "and", "more") or w.is_measure(t) or w.is_block(t)
        for t in texts
    )
    counted = any(number(t) is not None for t in texts) or any(w.is_measure(t) for t in texts)
    led = any(w.directions(leaf.text) or leaf.text in ("behind", "from") for leaf in noun.modifiers[0].leaves[:5])
    related = (
        before[-1:] == ["to"]
        and before[:1] != ["to"]
        and w.is_beside(before[0])
        or bool(before and before[-1] in _RELATING)
    )
    return plain and counted and (led or all(number(t) is not None for t in texts)) and not related
