"""Sentences drawn from productions, as gold trees."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from grounding.corpus.wording import (
    blocks,
    clauses,
    commands,
    destinations,
    places,
    relations,
    sentences,
    sets,
    statements,
)
from grounding.corpus.wording.notation import Branch, Leaf, Part, Production, Slot, read_productions
from grounding.corpus.wording.style import mend_articles, settle_adverbs, speak
from grounding.errors import CorpusError
from grounding.language.tree import Phrase, Word

FAMILIES = ("pick", "place", "clear", "statement", "description")
"""What sentences are for: commands of three kinds, statements of what moves where, noun phrases alone."""

MARKS = {
    "color": "colours",
    "history": "what was spoken of before: it, them, the block just moved",
    "viewer": "the speaker or the one spoken to: your left, closest to me",
    "arrangement": "rows, columns, groups and other sets",
    "stacked": "towers, and blocks on blocks",
    "compass": "north, southwest",
    "distance": "lengths of blocks and spaces",
    "several": "more than one sentence",
    "loose": "hesitation, dropped articles, words that a careful writer would not use",
    "deep": "a phrase that holds another of its kind",
}
_WEIGHTS = {"pick": 4.0, "place": 4.0, "clear": 0.6, "statement": 2.5, "description": 1.2}
_DEEPEST = 3
_DECAY = 0.5

Node = Word | Phrase
PRODUCTIONS: Mapping[str, tuple[Production, ...]] = read_productions(
    *(part.TEXT for part in (blocks, sets, places, relations, clauses, commands, destinations, statements, sentences))
)


@dataclass(frozen=True)
class Topics:
    """What sentences may speak of.

    Attributes:
        families: some of `FAMILIES`.
        without: some of `MARKS`: no production with one of these is used.
    """

    families: frozenset[str] = frozenset(FAMILIES)
    without: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        for found, known in ((self.families, FAMILIES), (self.without, tuple(MARKS))):
            wrong = sorted(found - set(known))
            if wrong:
                raise CorpusError(f"expected some of {', '.join(known)} and found {', '.join(wrong)}")
        if not self.families:
            raise CorpusError(f"expected at least one of {', '.join(FAMILIES)} and found none")


EVERYTHING = Topics()


@dataclass(frozen=True)
class Sample:
    """A sentence that was drawn.

    Attributes:
        tree: its gold tree, words numbered from 0.
        family: which of `FAMILIES` it is.
        productions: the names of those that made it, in the order of their use.
    """

    tree: Phrase
    family: str
    productions: tuple[str, ...]


def sample_tree(rng: np.random.Generator, topics: Topics = EVERYTHING) -> Phrase:
    """Draw the gold tree of one text.

    Args:
        rng: all chance comes from it.
        topics: what the text may speak of.

    Returns:
        the tree, a `FRAG` over the sentences where there are several.
    """
    return sample(rng, topics).tree


def sample(rng: np.random.Generator, topics: Topics = EVERYTHING) -> Sample:
    """Draw one text, with the names of the productions that made it."""
    families = [family for family in FAMILIES if family in topics.families]
    family = families[_choose(rng, [_WEIGHTS[name] for name in families])]
    drawing = _Drawing(rng, topics.without)
    parts = drawing.expand(family, 0)
    tree = parts[0] if len(parts) == 1 else Phrase("FRAG", tuple(parts))
    assert isinstance(tree, Phrase)
    tree = settle_adverbs(tree)
    if "loose" not in topics.without:
        tree, manners = speak(tree, rng)
        drawing.used.extend(manners)
    return Sample(mend_articles(renumber(tree)), family, tuple(drawing.used))


def sentences_of(tree: Phrase) -> tuple[Phrase, ...]:
    """The sentences of a text's tree, each numbered from 0."""
    return tuple(renumber(part) for part in tree.phrases) if tree.tag == "FRAG" else (tree,)


def sampled_sentences(count: int, seed: int) -> Iterator[Phrase]:
    """The sentences of so many texts on everything, to learn a grammar from."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        yield from sentences_of(sample_tree(rng))


def renumber(tree: Phrase) -> Phrase:
    """The same tree with its words numbered in order from 0."""
    count = 0

    def walk(node: Node) -> Node:
        nonlocal count
        if isinstance(node, Word):
            count += 1
            return Word(node.text, node.tag, count - 1)
        return Phrase(node.tag, tuple(walk(child) for child in node.children))

    numbered = walk(tree)
    assert isinstance(numbered, Phrase)
    return numbered


@dataclass
class _Drawing:
    rng: np.random.Generator
    without: frozenset[str]
    used: list[str] = field(default_factory=list)

    def expand(self, symbol: str, level: int) -> list[Node]:
        """What a symbol becomes, below so many productions that are marked as deep."""
        choices = _choices(self.without, level)[symbol]
        production = choices[_choose(self.rng, [_weight(choice, level) for choice in choices])]
        self.used.append(production.name)
        return self._fill(production.parts, level + ("deep" in production.marks))

    def _fill(self, parts: Sequence[Part], level: int) -> list[Node]:
        nodes: list[Node] = []
        for part in parts:
            if isinstance(part, Leaf):
                nodes.append(Word(*part.choices[int(self.rng.integers(len(part.choices)))], 0))
            elif isinstance(part, Branch):
                nodes.append(Phrase(part.tag, tuple(self._fill(part.parts, level))))
            elif part.chance == 1 or (part.symbol in _choices(self.without, level) and self.rng.random() < part.chance):
                nodes.extend(self.expand(part.symbol, level))
        return nodes


def _weight(production: Production, level: int) -> float:
    return production.weight * (_DECAY**level if "deep" in production.marks else 1.0)


def _choose(rng: np.random.Generator, weights: Sequence[float]) -> int:
    target = rng.random() * sum(weights)
    for index, weight in enumerate(weights):
        target -= weight
        if target < 0:
            return index
    return len(weights) - 1


def _choices(without: frozenset[str], level: int) -> Mapping[str, tuple[Production, ...]]:
    return _possible(without, min(level, _DEEPEST))


@lru_cache(maxsize=256)
def _possible(without: frozenset[str], level: int) -> Mapping[str, tuple[Production, ...]]:
    """Symbol -> the productions that can be finished; symbols without any are left out."""
    deeper = _possible(without, level + 1) if level < _DEEPEST else {}
    banned = without | {"deep"} if level == _DEEPEST else without
    kept = {
        symbol: tuple(
            production
            for production in productions
            if not production.marks & banned
            and ("deep" not in production.marks or all(_open(slot, deeper) for slot in production.slots()))
        )
        for symbol, productions in PRODUCTIONS.items()
    }
    while True:
        kept = {symbol: productions for symbol, productions in kept.items() if productions}
        again = {
            symbol: tuple(
                production
                for production in productions
                if "deep" in production.marks or all(_open(slot, kept) for slot in production.slots())
            )
            for symbol, productions in kept.items()
        }
        if again == kept:
            return kept
        kept = again


def _open(slot: Slot, table: Mapping[str, tuple[Production, ...]]) -> bool:
    return slot.chance < 1 or slot.symbol in table
