"""Generates annotated examples: samples gold trees, suits them to a world, keeps those whose meaning is clear there.

Worlds may come from elsewhere, settled by physics for instance: `recognise` finds the arrangements in them. Families of
sentences and outcomes are kept in balance. Which wordings are held out is told by a hash of the wording alone, see
`is_held_out`.
"""

from __future__ import annotations

import re
import zlib
from collections import Counter
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

import models
from grounding.corpus.annotate import annotate
from grounding.corpus.compositions import KINDS, compose_world, dressed, recognise
from grounding.corpus.fitting import Vocabulary, fit, vocabulary
from grounding.corpus.format import Example
from grounding.corpus.guided import Guide, graft
from grounding.corpus.meaning import NotAnnotatable
from grounding.corpus.sense import is_sensible
from grounding.corpus.strides import leaves_table
from grounding.corpus.treebank import LaidWorld, read_trees
from grounding.corpus.variation import vary
from grounding.corpus.wording import Topics, renumber, sample_tree, sentences_of
from grounding.language.lexicon import alike
from grounding.language.tree import Phrase
from grounding.symbols import Action, Symbol

__all__ = ["HELD_OUT_SHARE", "KINDS", "MOST_COPIES", "compose_world", "dressed", "generate", "is_held_out",
           "recognise", "wording_of", "written"]  # fmt: skip
MOST_COPIES = 4  # of one wording in a corpus
HELD_OUT_SHARE = 0.1
OUTCOME_SHARES = {"grounded": 0.8, "ambiguous": 0.1, "no_referent": 0.1}
FAMILY_SHARES = {"pick": 0.34, "place": 0.28, "statement": 0.16, "description": 0.12, "clear": 0.1}
_TREEBANK_SHARE = 0.15  # of the trees are variants of the treebank's
_GUIDED_SHARE = 0.2  # of the examples have a description that was found in the world
_TRIES = 160  # trees for a wanted example
_RICH_SHARE = 0.6  # of the examples are the richest of several: simple sentences are true more often
_CANDIDATES = 3
_MOST_ALTERNATIVES = 8  # what leaves more open is not said
_REFERRING = frozenset(("it", "that", "this", "moved", "placed", "put", "picked"))
_THINGS = frozenset(
    "block cube box brick one piece object square blocks cubes boxes bricks ones pieces objects".split()
)
_STATING = frozenset(("is", "'s"))


def generate(world: LaidWorld, rng: np.random.Generator, count: int, taken: Counter[str]) -> tuple[Example, ...]:
    """Annotated examples in one world.

    Args:
        world: with its arrangements.
        rng: the only source of chance.
        count: at most so many; fewer where little is true of the world.
        taken: how often each wording is in the corpus already; counted on.

    Returns:
        examples with ids unique for the world's name.
    """
    making = _Making(world, rng, taken, vocabulary(world.layout, world.arrangements), _unsaid(world), Guide(world))
    for _ in range(count):
        making.add(count)
    return tuple(making.found)


@dataclass
class _Making:
    world: LaidWorld
    rng: np.random.Generator
    taken: Counter[str]
    words: Vocabulary
    unsaid: frozenset[str]
    guide: Guide
    found: list[Example] = field(default_factory=list)
    _texts: set[str] = field(default_factory=set)
    _outcomes: Counter[str] = field(default_factory=Counter)

    def add(self, count: int) -> None:
        """One more example, if one is found."""
        families = list(FAMILY_SHARES)
        family = families[int(self.rng.choice(len(families), p=list(FAMILY_SHARES.values())))]
        topics = Topics(frozenset({family}), self.unsaid)
        best: Example | None = None
        guided = self.rng.random() < _GUIDED_SHARE
        wanted = 1 if guided else _CANDIDATES if self.rng.random() < _RICH_SHARE else 1
        for _ in range(_TRIES):
            tree = self._guided_tree(topics) if guided else self._tree(topics)
            if tree is None or self.taken[wording_of(tree)] >= MOST_COPIES or tree.text in self._texts:
                continue
            example = self._example(tree) if is_sensible(tree) else None
            if example is None or self._outcomes[example.outcome] >= self._most(example.outcome, count):
                continue
            if best is None or len(example.groundings) > len(best.groundings):
                best = example
            wanted -= 1
            if not wanted:
                break
        if best is not None:
            self._outcomes[best.outcome] += 1
            self._texts.add(best.tree.text)
            self.taken[wording_of(best.tree)] += 1
            self.found.append(best)

    def _tree(self, topics: Topics) -> Phrase:
        if self.rng.random() < _TREEBANK_SHARE:
            trees = _trees()
            tree = vary(trees[int(self.rng.integers(len(trees)))], self.rng)
        else:
            tree = sample_tree(self.rng, topics)
        return renumber(fit(tree, self.words, self.rng))

    def _guided_tree(self, topics: Topics) -> Phrase | None:
        description = self.guide.describe(self.rng)
        tree = None if description is None else graft(sample_tree(self.rng, topics), description)
        return None if tree is None else renumber(tree)

    def _most(self, outcome: str, count: int) -> float:
        """How many examples of an outcome a world gets."""
        return count if outcome == "grounded" else max(1.0, round(OUTCOME_SHARES[outcome] * count))

    def _example(self, tree: Phrase) -> Example | None:
        layout = self.world.layout
        history: tuple[str, ...] = ()
        try:
            groundings, outcome = annotate(tree, layout, self.world.arrangements)
        except NotAnnotatable:
            if not _points_back(tree):
                return None
            history = (layout.ids[int(self.rng.integers(layout.size))],)
            try:
                groundings, outcome = annotate(tree, layout, self.world.arrangements, history)
            except NotAnnotatable:
                return None
        if _actions(groundings[0]) > _MOST_ALTERNATIVES or any(
            leaves_table(tree, layout, symbol) for symbol in groundings[0] if isinstance(symbol, Action)
        ):
            return None
        name = f"{self.world.name}-{len(self.found)}"
        text = written(tree, self.rng)
        return Example(name, self.world.name, text, tree, groundings, outcome, history)


def written(tree: Phrase, rng: np.random.Generator) -> str:
    """The words of a tree as people type them: with capitals, commas and full stops or without.

    Args:
        tree: of one sentence or several.
        rng: the only source of chance.
    """
    sentences = [re.sub(" (?=['’])", "", part.text) for part in sentences_of(tree)]
    capital, stop = rng.random() < 0.6, rng.random() < 0.6
    if capital:
        sentences = [sentence[:1].upper() + sentence[1:] for sentence in sentences]
    joint = ". " if stop or capital or rng.random() < 0.7 else ", "
    return joint.join(sentences) + ("." if stop and tree.tag != "NP" else "")


def _points_back(tree: Phrase) -> bool:
    """Whether a text speaks of what was handled before: it names nothing that may be meant, and states nothing."""
    leaves = tree.leaves
    first = next((i for i, leaf in enumerate(leaves) if leaf.text in _REFERRING), None)
    if first is None or sum(leaf.text in ("that", "which") for leaf in leaves) > 1:
        return False
    named = any(leaf.text in _THINGS and i > 0 and leaves[i - 1].text not in _REFERRING
                for i, leaf in enumerate(leaves[:first]))  # fmt: skip
    stated = any(leaf.text in _STATING for leaf in leaves[first + 1 : first + 3])
    return not named and (not stated or leaves[first].tag.startswith("VB"))


def _actions(symbols: frozenset[Symbol]) -> int:
    return sum(isinstance(symbol, Action) and bool(symbol.objects) for symbol in symbols)


def _unsaid(world: LaidWorld) -> frozenset[str]:
    """What is not spoken of in a world that has nothing of the kind."""
    kinds = {kind for kind, _ in world.arrangements}
    unsaid = set()
    if "tower" not in kinds:
        unsaid.add("stacked")
    if not kinds:
        unsaid.add("arrangement")
    if len(world.layout.colors) == 1:
        unsaid.add("color")
    return frozenset(unsaid)


def wording_of(tree: Phrase) -> str:
    """The words of a tree without the number, rank, colour or side that they name."""
    return " ".join(alike(leaf.text) for leaf in tree.leaves)


def is_held_out(tree: Phrase) -> bool:
    """Whether the wording of a tree is kept for measuring: decided by a hash, for all corpora alike."""
    return zlib.crc32(wording_of(tree).encode()) % 1000 < 1000 * HELD_OUT_SHARE


@lru_cache(maxsize=1)
def _trees() -> tuple[Phrase, ...]:
    return read_trees(models.TREEBANK)
