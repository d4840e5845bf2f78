"""Descriptions of blocks by what is true of them: next to, between, touching, surrounded by what others can be told by.

What relates two blocks is seldom true of a sentence that is drawn without looking at the world. So a block is chosen
first, then something about it that holds of no other block of its kind, and the description takes the place of a noun
phrase in a sampled sentence. Annotation checks it like all others.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from grounding.corpus.base_phrases import BasePhrases
from grounding.corpus.meaning import NotAnnotatable
from grounding.corpus.prepositions import MOST_REFERENCES
from grounding.corpus.selector import Selector
from grounding.corpus.sight import sight_of
from grounding.corpus.treebank import LaidWorld
from grounding.geometry.masks import indices_of, single
from grounding.language.tree import Phrase, Word
from grounding.symbols import Region

NOUNS = ("block", "block", "block", "box", "cube", "brick", "one")
_RANKS = (
    ("leftmost", "JJ"), ("rightmost", "JJ"), ("closest", "JJS"), ("farthest", "JJS"), ("top", "JJ"), ("bottom", "JJ"),
    ("nearest", "JJS"), ("furthest", "JJS"),
)  # fmt: skip
_RELATIONS: dict[str, tuple[str, ...]] = {
    "near": ("next/JJ to/IN", "beside/IN", "near/IN", "right/RB next/JJ to/IN", "by/IN", "adjacent/JJ to/IN"),
    "back": ("behind/IN", "above/IN", "directly/RB behind/IN", "just/RB above/IN"),
    "front": ("below/IN", "under/IN", "directly/RB below/IN", "beneath/IN"),
    "left": ("left/JJ of/IN",),
    "right": ("right/JJ of/IN",),
    "touching": ("touching/VBG",),
}
_BETWEEN = ("between/IN", "between/IN", "in/IN between/IN")
_TRIES = 4  # blocks that are looked at
_NUMBERS = {2: "two", 3: "three", 4: "four"}


class Guide:
    """Descriptions of the blocks of one world."""

    def __init__(self, world: LaidWorld) -> None:
        self.layout = world.layout
        self.sight = sight_of(world.layout)
        self._base = BasePhrases(Selector(world.layout), world.arrangements)
        self._told: dict[int, list[Phrase]] | None = None

    def describe(self, rng: np.random.Generator) -> Phrase | None:
        """A description by a relation that is true of one block only, or None where none was found."""
        found = (self._try(rng) for _ in range(_TRIES))
        return next(filter(None, found), None)

    def _try(self, rng: np.random.Generator) -> Phrase | None:
        layout = self.layout
        target = int(rng.integers(layout.size))
        item = layout.things[target]
        color = item.color if item.color != "unknown" and rng.random() < 0.6 else None
        pool = layout.matching(item.type, color)
        way = rng.random()
        if way < 0.3:
            modifier = self._between(rng, target, pool)
        elif way < 0.38:
            modifier = self._surrounded(rng, target, pool)
        else:
            modifier = self._beside(rng, target, pool)
        if modifier is None:
            return None
        noun = NOUNS[int(rng.integers(len(NOUNS)))]
        words = [("the", "DT"), *([(color, "JJ")] if color else []), (noun, "NN")]
        if rng.random() < 0.3:
            clause = Phrase("S", (Phrase("VP", (Word("is", "VBZ", 0), modifier)),))
            modifier = Phrase("SBAR", (Phrase("WHNP", (Word("that", "WDT", 0),)), clause))
        return Phrase("NP", (_flat(words), modifier))

    def _between(self, rng: np.random.Generator, target: int, pool: int) -> Phrase | None:
        told = [i for i in self._described() if i != target]
        pairs = list(combinations(told, 2))
        for place in rng.permutation(len(pairs))[:60]:
            pair = pairs[int(place)]
            names = tuple(self.layout.ids[i] for i in pair)
            inside = self.layout.within(Region("between", "object", names)) & pool
            if inside == 1 << target:
                first, second = (self._name(rng, i) for i in pair)
                both = Phrase("NP", (first, Word("and", "CC", 0), second))
                return Phrase("PP", (*_words(_pick(rng, _BETWEEN)), both))
        return None

    def _beside(self, rng: np.random.Generator, target: int, pool: int) -> Phrase | None:
        told = list(self._described())
        for place in rng.permutation(len(told))[:12]:
            other = told[int(place)]
            if other == target:
                continue
            holds = [name for name in _RELATIONS if self._inside(name, other) & pool == 1 << target]
            if holds:
                relation = _RELATIONS[holds[int(rng.integers(len(holds)))]]
                return Phrase("PP", (*_words(_pick(rng, relation)), self._name(rng, other)))
        return None

    def _inside(self, relation: str, other: int) -> int:
        if relation == "touching":
            found, clear = self.sight.touching(1 << other, self.layout.everything & ~(1 << other))
            return found if clear else 0
        return self.layout.within(Region(relation, "object", (self.layout.ids[other],)))

    def _surrounded(self, rng: np.random.Generator, target: int, pool: int) -> Phrase | None:
        colors = [color for color in sorted(self.layout.colors) if color != "unknown"]
        if not colors:
            return None
        color = colors[int(rng.integers(len(colors)))]
        near = self._inside("near", target) & self.layout.matching(None, color)
        number = near.bit_count()
        some = self.layout.matching(None, color).bit_count()
        if number not in _NUMBERS or some > MOST_REFERENCES:
            return None
        contact = rng.random() < 0.4
        words = [(_NUMBERS[number], "CD"), (color, "JJ"), ("blocks", "NNS")]
        start = "touching/VBG" if contact else "surrounded/VBN by/IN"
        return Phrase("PP", (*_words(start), _flat(words)))

    def _name(self, rng: np.random.Generator, index: int) -> Phrase:
        names = self._described()[index]
        flat = names[int(rng.integers(len(names)))]
        noun = NOUNS[int(rng.integers(len(NOUNS)))]
        return Phrase("NP", (*flat.words[:-1], Word(noun, "NN", 0)))

    def _described(self) -> dict[int, list[Phrase]]:
        """Flat noun phrases that single out a block, by its index."""
        if self._told is None:
            self._told = {}
            colors: list[str | None] = [None, *(c for c in sorted(self.layout.colors) if c != "unknown")]
            for color in colors:
                for rank in (None, *_RANKS):
                    words = [("the", "DT"), *([rank] if rank else []), *([(color, "JJ")] if color else [])]
                    self._tell(_flat([*words, ("block", "NN")]))
        return self._told

    def _tell(self, phrase: Phrase) -> None:
        assert self._told is not None
        try:
            meaning = self._base.annotate(phrase)
        except NotAnnotatable:
            return
        if single(meaning.chosen) and not meaning.unclear:
            self._told.setdefault(next(indices_of(meaning.chosen)), []).append(phrase)


def graft(tree: Phrase, description: Phrase) -> Phrase | None:
    """The tree with a description in place of its first noun phrase that means one block; None where it has none."""
    for phrase in tree.preorder():
        if _means_a_block(phrase):
            return _replaced(tree, phrase, description)
    return None


def _means_a_block(phrase: Phrase) -> bool:
    inner = phrase
    while inner.phrases and inner.tag == "NP":
        inner = inner.phrases[0]
    return phrase.tag == "NP" and inner.tag == "NP" and inner.words[-1].text in NOUNS and len(inner.words) > 1


def _replaced(tree: Phrase, old: Phrase, new: Phrase) -> Phrase:
    if tree is old:
        return new
    return Phrase(tree.tag, tuple(_replaced(c, old, new) if isinstance(c, Phrase) else c for c in tree.children))


def _flat(words: Sequence[tuple[str, str]]) -> Phrase:
    return Phrase("NP", tuple(Word(text, tag, 0) for text, tag in words))


def _words(text: str) -> tuple[Word, ...]:
    """Words with their tags: "next/JJ to/IN"."""
    return tuple(Word(word, tag, 0) for word, tag in (part.split("/") for part in text.split()))


def _pick(rng: np.random.Generator, choices: Sequence[str]) -> str:
    return choices[int(rng.integers(len(choices)))]
