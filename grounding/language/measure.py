"""How well a parser does on trees: labelled brackets, exact trees, gold trees among the k best.

Brackets are compared as in PARSEVAL (E. Black et al., "A procedure for quantitatively comparing the syntactic coverage
of English grammars", 1991): tag, first and last word of every phrase.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import astuple, dataclass

import numpy as np

from grounding.language.parser import Parser
from grounding.language.possessives import unfold
from grounding.language.tree import Phrase, Word


@dataclass(frozen=True)
class Score:
    """Sums over sentences.

    Attributes:
        sentences: how many.
        exact: how often the best parse is the gold tree, tags of words included.
        among: how often one of the k best is.
        structure: how often the best parse has the phrases of the gold tree, whatever the tags of words.
        structure_among: how often one of the k best has.
        covered: how often the grammar covered the sentence.
        matched: brackets that the best parses share with the gold trees.
        found: brackets of the best parses.
        wanted: brackets of the gold trees.
    """

    sentences: int
    exact: int
    among: int
    structure: int
    structure_among: int
    covered: int
    matched: int
    found: int
    wanted: int

    def __add__(self, other: Score) -> Score:
        return Score(*(mine + theirs for mine, theirs in zip(astuple(self), astuple(other), strict=True)))

    @property
    def f1(self) -> float:
        """Harmonic mean of precision and recall of the best parses' brackets; 1 where there are none."""
        return 2 * self.matched / (self.found + self.wanted) if self.found + self.wanted else 1.0


def held_out(
    trees: Iterable[Phrase], parts: int, rng: np.random.Generator
) -> Iterator[tuple[tuple[Phrase, ...], tuple[Phrase, ...]]]:
    """Split a treebank by wording: each part is to be parsed by a grammar learned from the others.

    Args:
        trees: the treebank; trees with the same words stay together, and only the first of them is parsed.
        parts: how many, at least 2.
        rng: decides which wording is in which part.

    Yields:
        (trees to learn from, trees to parse).
    """
    wordings: dict[str, list[Phrase]] = {}
    for tree in trees:
        wordings.setdefault(tree.text, []).append(tree)
    texts = [str(text) for text in rng.permutation(sorted(wordings))]
    for part in range(parts):
        parsed = set(texts[part::parts])
        learned = tuple(tree for text in texts if text not in parsed for tree in wordings[text])
        yield learned, tuple(wordings[text][0] for text in texts[part::parts])


def brackets(tree: Phrase) -> Counter[tuple[str, int, int]]:
    """(tag, index of the first word, index after the last) of every phrase."""
    spans: Counter[tuple[str, int, int]] = Counter()

    def walk(node: Phrase | Word, start: int) -> int:
        if isinstance(node, Word):
            return start + 1
        end = start
        for child in node.children:
            end = walk(child, end)
        spans[node.tag, start, end] += 1
        return end

    walk(tree, 0)
    return spans


def written(tree: Phrase) -> str:
    """The text of a tree as one would write it: full stops between sentences, clitics joined to their words."""
    parts = tree.phrases if tree.tag == "FRAG" and not tree.words else (tree,)
    return ". ".join(part.text for part in parts).replace(" '", "'").replace(" n't", "n't")


def score(parser: Parser, trees: Iterable[Phrase], k: int = 4) -> Score:
    """Parse the words of trees and compare.

    Args:
        parser: learned from other trees.
        trees: the gold trees.
        k: how many readings count as "among".
    """
    totals: Counter[str] = Counter()
    for tree in trees:
        parses, gold = parser.parse(written(tree), k), unfold(tree)
        spans = brackets(gold)
        guesses = [brackets(parse.tree) for parse in parses]
        same = [parse.tree == gold for parse in parses]
        alike = [guess == spans for guess in guesses]
        totals.update(
            sentences=1,
            exact=same[0],
            among=any(same),
            structure=alike[0],
            structure_among=any(alike),
            covered=parses[0].complete,
            matched=sum((guesses[0] & spans).values()),
            found=sum(guesses[0].values()),
            wanted=sum(spans.values()),
        )
    return Score(**{name: totals[name] for name in Score.__dataclass_fields__})
