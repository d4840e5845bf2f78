"""How well inference does on annotated trees: roots, whole trees and single phrases (Section V)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from grounding.inference import Adcg, aligned
from grounding.learning.examples import Annotated
from grounding.symbols import Symbol


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


def evaluate(examples: Iterable[Annotated], inference: Adcg, sample: float | None = None) -> Evaluation:
    """Compare the likeliest hypothesis with the annotation.

    Args:
        examples: annotated trees.
        inference: with the factors to evaluate.
        sample: if given, a symbol counts as found when its probability exceeds this (the paper: 0.75), instead of being
            part of the likeliest set.
    """
    count = roots = wholes = right = phrases = 0
    errors = []
    for tree, groundings, layout in examples:
        best = inference.infer(tree, layout).hypotheses[0]
        wrong = []
        for phrase, hypothesis in aligned(tree, best):
            found = hypothesis.symbols
            if sample is not None:
                found = frozenset(s for s, p in hypothesis.probabilities.items() if p > sample)
            phrases += 1
            if found == groundings[id(phrase)]:
                right += 1
                roots += phrase is tree
            else:
                wrong.append((phrase.text, groundings[id(phrase)], found))
        count += 1
        wholes += not wrong
        errors += wrong[-1:]
    share = max(count, 1)
    return Evaluation(count, roots / share, wholes / share, right / max(phrases, 1), tuple(errors))
