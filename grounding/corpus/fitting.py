"""Suits a sampled sentence to a world: colours, numbers and kinds that do not occur there give way to some that do."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from grounding.corpus.words import BLOCKS, LENGTHS
from grounding.geometry.layout import Layout
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase, Word
from grounding.symbols import Cardinal, Container, ObjectColor

SHARE = 0.85  # of the words that do not suit the world; the others stay and make sentences that mean nothing there
SINGLED = 0.6  # of the blocks that others are next to are told apart by a colour of their own, where there is one
SINGULAR = ("block", "box", "cube", "brick", "piece", "one")
_NUMBERS = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
_NOUNS = {
    "row": ("row", "row", "line"), "column": ("column", "column", "line"), "group": ("group", "cluster", "bunch"),
    "circle": ("circle", "ring"), "tower": ("tower", "stack", "pile"),
}  # fmt: skip


@dataclass(frozen=True)
class Vocabulary:
    """What there is to speak of in a world.

    Attributes:
        colors: of its blocks.
        rare: those of a single block.
        sizes: of its arrangements and of the sets of one colour.
        kinds: of its arrangements.
    """

    colors: tuple[str, ...]
    sizes: tuple[int, ...]
    kinds: tuple[str, ...]
    rare: tuple[str, ...] = ()
    _by_kind: dict[str, tuple[int, ...]] = field(default_factory=dict)

    def sizes_of(self, kind: str) -> tuple[int, ...]:
        """Of the arrangements of a kind."""
        return self._by_kind.get(kind, ())


def vocabulary(layout: Layout, arrangements: Sequence[tuple[str, int]]) -> Vocabulary:
    """What there is to speak of in a world whose arrangements are known."""
    counts = Counter(item.color for item in layout.things)
    colors = tuple(sorted(counts))  # each once: rare ones are worth speaking of
    sizes = sorted({mask.bit_count() for _, mask in arrangements} | {n for n in counts.values() if n > 1})
    kinds = tuple(sorted({kind for kind, _ in arrangements}))
    by_kind = {kind: tuple(sorted(m.bit_count() for k, m in arrangements if k == kind)) for kind in kinds}
    rare = tuple(sorted(color for color, number in counts.items() if number == 1 and color != "unknown"))
    return Vocabulary(colors, tuple(n for n in sizes if 2 <= n <= 10), kinds, rare, by_kind)


def fit(tree: Phrase, words: Vocabulary, rng: np.random.Generator) -> Phrase:
    """The tree with colours, kinds of arrangement and numbers that occur in the world.

    Args:
        tree: a gold tree.
        words: of the world.
        rng: the only source of chance.
    """
    return _fit(tree, words, rng, None)


def _fit(phrase: Phrase, words: Vocabulary, rng: np.random.Generator, kind: str | None) -> Phrase:
    children: list[Word | Phrase] = []
    said = [child for child in phrase.children if isinstance(child, Word)]
    counts = phrase.tag == "NP" and bool(said) and _counts(said)
    for child in phrase.children:
        if isinstance(child, Phrase):
            fitted = _fit(child, words, rng, kind if phrase.tag == "PP" else None)
            if words.rare and (phrase.tag == "PP" or _joins(phrase)) and rng.random() < SINGLED:
                fitted = _singled(fitted, words, rng)
            if phrase.tag == "NP" and child.tag == "NP" and kind is None:
                kind = _kind(fitted)
            children.append(fitted)
        else:
            children.append(_word(child, words, rng, counts, kind))
            if phrase.tag == "NP" and kind is None and isinstance(children[-1], Word):
                kind = _kind_of(children[-1])
    return Phrase(phrase.tag, tuple(children))


def _joins(phrase: Phrase) -> bool:
    return phrase.tag == "NP" and any(word.tag == "CC" for word in phrase.words)


def _singled(phrase: Phrase, words: Vocabulary, rng: np.random.Generator) -> Phrase:
    """The block that something stands next to, told apart by a colour that no other has."""
    if phrase.tag != "NP" or phrase.phrases or phrase.words[0].text != "the" or phrase.words[-1].tag != "NN":
        return phrase
    if phrase.words[-1].text not in SINGULAR or not 2 <= len(phrase.words) <= 3:
        return phrase
    if len(phrase.words) == 3 and not any(isinstance(s, ObjectColor) for s in meanings(phrase.words[1].text)):
        return phrase
    color = Word(words.rare[int(rng.integers(len(words.rare)))], "JJ", 0)
    return Phrase("NP", (phrase.words[0], color, phrase.words[-1]))


def _counts(said: Sequence[Word]) -> bool:
    """Whether a number among these words counts blocks rather than lengths."""
    return said[-1].text not in LENGTHS or said[-1].text in BLOCKS


def _kind_of(word: Word) -> str | None:
    kinds = [s.kind for s in meanings(word.text) if isinstance(s, Container) and s.kind != "robot"]
    return kinds[0] if kinds and word.tag == "NN" else None


def _kind(phrase: Phrase) -> str | None:
    return next((kind for kind in map(_kind_of, phrase.words) if kind), None)


def _word(word: Word, words: Vocabulary, rng: np.random.Generator, counts: bool, kind: str | None) -> Word:
    symbols = meanings(word.text)
    if not symbols or rng.random() > SHARE:
        return word
    colors = [s.name for s in symbols if isinstance(s, ObjectColor)]
    if colors and colors[0] not in words.colors and "unknown" not in words.colors:
        return Word(words.colors[int(rng.integers(len(words.colors)))], word.tag, word.index)
    kinds = [s.kind for s in symbols if isinstance(s, Container) and s.kind != "robot"]
    if kinds and word.tag == "NN" and words.kinds and not set(kinds) & set(words.kinds):
        nouns = _NOUNS[words.kinds[int(rng.integers(len(words.kinds)))]]
        return Word(nouns[int(rng.integers(len(nouns)))], word.tag, word.index)
    numbers = [s.value for s in symbols if isinstance(s, Cardinal)]
    if counts and numbers and numbers[0] > 1 and word.tag == "CD":
        sizes = words.sizes_of(kind) if kind else words.sizes
        if sizes and numbers[0] not in sizes and (kind or rng.random() < 0.6):
            value = sizes[int(rng.integers(len(sizes)))]
            return Word(str(value) if word.text.isdecimal() else _NUMBERS[value - 1], word.tag, word.index)
    return word
