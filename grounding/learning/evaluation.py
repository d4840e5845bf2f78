"""How well inference does on annotated trees: roots, whole trees and single phrases (Section V).

The tree that was grounded need not be the annotated one. Phrases are matched by their tag and by their first and last
word, as in PARSEVAL; of several with the same tag over the same words the outer ones are matched first. An annotated
phrase that the other tree lacks is wrong, and a tree with a phrase that the annotation lacks is not complete.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from grounding.inference import Engine, Hypothesis, aligned
from grounding.language.tree import Phrase
from grounding.learning.examples import Annotated
from grounding.readings import preferred
from grounding.symbols import Symbol

Place = tuple[str, int, int, int]  # tag, first word, last word, how many such phrases are around it


@dataclass(frozen=True)
class Mistake:
    """A phrase whose symbols are not those annotated.

    Attributes:
        text: the words of the phrase.
        annotated: its symbols.
        found: what inference gave; None where the tree has no such phrase.
    """

    text: str
    annotated: frozenset[Symbol]
    found: frozenset[Symbol] | None


@dataclass(frozen=True)
class TreeScore:
    """One tree compared with its annotation.

    Attributes:
        phrases: how many are annotated.
        right: how many of them were grounded exactly as annotated.
        root: whether the root is among those.
        extra: phrases of the tree that was grounded which the annotation does not have.
        mistakes: in the order of the annotated tree, parents before children.
    """

    phrases: int
    right: int
    root: bool
    extra: int
    mistakes: tuple[Mistake, ...]

    @property
    def complete(self) -> bool:
        """Whether every phrase is right and there is no other."""
        return self.right == self.phrases and not self.extra


@dataclass(frozen=True)
class Evaluation:
    """Shares of what was grounded exactly as annotated.

    Attributes:
        examples: how many trees.
        root: share of trees whose root is right.
        complete: share of trees all of whose phrases are right.
        phrases: share of phrases that are right.
        errors: (text of the phrase, annotated, found) of the deepest wrong phrase of every wrong tree.
    """

    examples: int
    root: float
    complete: float
    phrases: float
    errors: tuple[tuple[str, frozenset[Symbol], frozenset[Symbol]], ...]


def evaluate(examples: Iterable[Annotated], inference: Engine, sample: float | None = None) -> Evaluation:
    """Compare the hypothesis that is believed with the annotation, on the annotated trees.

    Args:
        examples: annotated trees.
        inference: with the factors to evaluate.
        sample: if given, a symbol counts as found when its probability exceeds this (the paper: 0.75), instead of being
            part of the likeliest set.
    """
    scores = [
        score_tree(tree, groundings, tree, preferred(inference.infer(tree, layout), layout), sample)
        for tree, groundings, layout in examples
    ]
    count = max(len(scores), 1)
    last = [score.mistakes[-1] for score in scores if score.mistakes]
    return Evaluation(
        len(scores),
        sum(score.root for score in scores) / count,
        sum(score.complete for score in scores) / count,
        sum(score.right for score in scores) / max(sum(score.phrases for score in scores), 1),
        tuple((mistake.text, mistake.annotated, mistake.found or frozenset()) for mistake in last),
    )


def score_tree(
    tree: Phrase,
    groundings: Mapping[int, frozenset[Symbol]],
    grounded: Phrase,
    hypothesis: Hypothesis,
    threshold: float | None = None,
) -> TreeScore:
    """Compare what a tree was grounded to with the annotation of the same text.

    Args:
        tree: the annotated tree.
        groundings: its symbols, by the identity of the phrase.
        grounded: the tree that was grounded: the same, or another parse of the text.
        hypothesis: for that tree.
        threshold: a symbol counts as found when its probability exceeds this; None: when it is part of the hypothesis.
    """
    parts = dict(zip(_places(grounded), (part for _, part in aligned(grounded, hypothesis)), strict=True))
    mistakes = []
    count, root = 0, False
    for place, phrase in zip(_places(tree), tree.preorder(), strict=True):
        count += 1
        part = parts.pop(place, None)
        symbols = None if part is None else found(part, threshold)
        if symbols != groundings[id(phrase)]:
            mistakes.append(Mistake(phrase.text, groundings[id(phrase)], symbols))
        elif phrase is tree:
            root = True
    return TreeScore(count, count - len(mistakes), root, len(parts), tuple(mistakes))


def found(hypothesis: Hypothesis, threshold: float | None) -> frozenset[Symbol]:
    """The symbols of a phrase: those of probability above the threshold, or those of the hypothesis if it is None."""
    if threshold is None:
        return hypothesis.symbols
    return frozenset(symbol for symbol, p in hypothesis.probabilities.items() if p > threshold)


def _places(tree: Phrase) -> Iterator[Place]:
    """What phrases are matched by, parents before children."""
    seen: Counter[tuple[str, int, int]] = Counter()
    for phrase in tree.preorder():
        place = (phrase.tag, phrase.leaves[0].index, phrase.leaves[-1].index)
        yield (*place, seen[place])
        seen[place] += 1
