"""A modifier taken apart: its own words, the noun phrase to which it relates, a measure."""

from __future__ import annotations

from dataclasses import dataclass

from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase, Word
from grounding.lexicon import words as w
from grounding.lexicon.vocabulary import vocabulary
from grounding.lexicon.whereto import metres
from grounding.meaning.goal.lengths import Metres, number
from grounding.meaning.nouns import Noun, read_noun, read_words
from grounding.symbols import Cardinal

_EMPHASIZED = frozenset("next in beside behind above below on at by near under to against between up".split())


@dataclass(frozen=True, eq=False)
class Heard:
    """The parts of a modifier.

    Attributes:
        further: directions that were said before and share the reference.
        said: its own words, read as those of a noun.
        texts: its own words and those of a phrase that leads to its noun phrase.
        nested: a phrase within that says all, where its own words say nothing.
        child: the noun phrase to which it relates, or None.
        noun: the same, read.
        measure: how many blocks away, or how far in `Metres`, or None.
        counting: whether blocks are counted and not lengths.
        strict: whether its words narrow a direction.
    """

    further: tuple[str, ...]
    said: Noun
    texts: list[str]
    nested: Phrase | None
    child: Phrase | None
    noun: Noun | None
    measure: float | None
    counting: bool
    strict: bool

    @property
    def metric(self) -> bool:
        """Whether its measure is a length in metres and not in blocks."""
        return isinstance(self.measure, Metres)

    @property
    def ordinal(self) -> int | None:
        """The rank that its own words ask for."""
        return self.said.ordinals[0] if self.said.ordinals else None

    @property
    def last(self) -> str:
        """The word before the noun phrase; "" where there is none."""
        return self.texts[-1] if self.texts else ""

    def directions(self) -> tuple[str, ...]:
        """The directions that are named; some prepositions are one whatever stands beside them."""
        texts = self.texts
        fixed = [name for text in texts for name in vocabulary().values("preposition", text)]
        if fixed:
            return (min(fixed, key=("up", "down", "back").index),)
        return (*self.further, *(name for text in texts for name in w.directions(text)))


def hear(phrase: Phrase, further: tuple[str, ...] = ()) -> Heard:
    """Take a modifier apart."""
    leaves = _without_emphasis(phrase.words)
    said = read_words(leaves)
    texts = [word.text for word in leaves]
    measure: float | None = None
    counting = False
    child: Phrase | None = None
    for inner in phrase.phrases:
        if inner.tag == "NP":
            size = _measure(inner)
            if size is None:
                child = child or inner
            elif measure is None:
                measure, counting = size, read_noun(inner).head == "block"
    if child is None and texts == ["of"]:  # "of nine blocks" tells of what, not how far
        child, measure, counting = next((c for c in phrase.phrases if c.tag == "NP"), None), None, False
    nested = next((c for c in phrase.phrases if c.tag in ("PP", "ADVP")), None) if child is None else None
    silent = not said.distance and not said.ordinals and not said.directions and measure is None
    if nested is not None and not silent:
        child = next((c for c in nested.phrases if c.tag == "NP"), None)
        texts += [word.text for word in _without_emphasis(nested.words)]
        nested = None
    noun = read_noun(child) if child is not None else None
    emphasized = len(leaves) < len(phrase.words)
    strict = emphasized or any(w.is_strict(text) and not w.directions(text) for text in texts)
    return Heard(further, said, texts, nested, child, noun, measure, counting, strict)


def _without_emphasis(words: tuple[Word, ...]) -> tuple[Word, ...]:
    """Words without a "right" that stands for "directly": "right next to"."""
    return tuple(
        word
        for place, word in enumerate(words)
        if not (word.text == "right" and place + 1 < len(words) and words[place + 1].text in _EMPHASIZED)
    )


def _measure(phrase: Phrase) -> float | None:
    """How far a noun phrase measures, in blocks or metres: "two spaces", "10 cm"; None where it measures nothing."""
    texts = [leaf.text for leaf in phrase.leaves]
    unit = metres(texts[-1])
    if unit is not None:
        counts = [found for text in texts[:-1] if (found := number(text)) is not None]
        return Metres(unit * (counts[0] if counts else 1.0))
    noun = read_noun(phrase)
    bare = not (noun.colors or noun.modifiers or noun.directions or noun.distance or noun.middle or noun.lone)
    counted = next((s.value for t in texts for s in meanings(t) if isinstance(s, Cardinal)), None)
    if noun.head == "measure" or (
        bare and counted is not None and "the" not in texts and noun.head in ("block", "other")
    ):
        if "half" in texts:
            return 0.5 if counted is None or counted == 1 else counted + 0.5
        return float(counted) if counted is not None else 3.0 if "few" in texts else 1.0
    return None
