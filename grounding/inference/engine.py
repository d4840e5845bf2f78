"""What all engines share: their interface, and the walk that grounds a tree from its leaves up with a beam."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping
from typing import Protocol

from grounding.factors.model import FactorModel
from grounding.features import STAGES, Family, Scope
from grounding.geometry.layout import Layout
from grounding.inference.hypotheses import Hypothesis, Inference, best_combinations
from grounding.language.tree import Phrase
from grounding.symbols import Symbol

Memory = dict[object, list[Hypothesis]]
Children = tuple[frozenset[Symbol], ...]
Kept = Mapping[int, frozenset[str]]  # the families that are looked at, by the identity of a phrase


class Engine(Protocol):
    """Inference of one kind, over one set of factors."""

    @property
    def model(self) -> FactorModel:
        """The factors."""

    def infer(self, tree: Phrase, layout: Layout, memory: Memory | None = None) -> Inference:
        """Ground every phrase of a tree.

        Args:
            tree: the parse.
            layout: the world, measured.
            memory: phrases grounded before by this engine in this world.

        Raises:
            SearchError: the space to be searched is too large; says how large it is.
        """


class Tally:
    """Counts while a tree is grounded."""

    def __init__(self) -> None:
        self.evaluations = 0
        self.sizes: Counter[str] = Counter()

    def add(self, family: str, size: int, evaluations: int | None = None) -> None:
        """So many symbols of a family were judged, by so many factors: one each if nothing else is said."""
        self.evaluations += size if evaluations is None else evaluations
        self.sizes[family] += size

    def inference(self, tree: Phrase, hypotheses: list[Hypothesis]) -> Inference:
        """The result of inference."""
        return Inference(tree, tuple(hypotheses), self.evaluations, sum(self.sizes.values()), dict(self.sizes))


def families(scope: Scope, kept: Kept | None) -> tuple[Family, ...]:
    """The families that are judged at the stage of a scope: those that are kept, all of them if nothing is said."""
    stage = STAGES[scope.stage]
    if kept is None:
        return stage
    names = kept[id(scope.phrase)]
    return tuple([family for family in stage if family.name in names])


def context_key(phrase: Phrase, children: Children) -> object:
    """Two phrases in one world with the same key have the same groundings: all words below them count."""
    return _brackets(phrase), children


def _brackets(phrase: Phrase) -> tuple[object, ...]:
    """A phrase as nested tuples of tags and words, wherever it stands in its sentence."""
    words = tuple((word.text, word.tag) for word in phrase.words)
    return (phrase.tag, words, *map(_brackets, phrase.phrases))


def ground(
    phrase: Phrase, local: Callable[[Phrase, Children], list[Hypothesis]], beam: int, least: float
) -> list[Hypothesis]:
    """The likeliest hypotheses of a phrase and all below it.

    Args:
        phrase: λ.
        local: gives the likeliest groundings of one phrase, given those of its children.
        beam: so many are kept for every phrase.
        least: those less likely than the best by more than this (in log) are dropped.
    """
    lists = [ground(child, local, beam, least) for child in phrase.phrases]
    found = [
        Hypothesis(own.symbols, sum(h.log_probability for h in children) + own.log_probability, children,
                   own.probabilities)
        for children in best_combinations(lists, beam)
        for own in local(phrase, tuple(child.symbols for child in children))
    ]  # fmt: skip
    found.sort(key=lambda h: -h.log_probability)
    kept: dict[frozenset[Symbol], Hypothesis] = {}
    for hypothesis in found:
        if hypothesis.log_probability >= found[0].log_probability + least:
            kept.setdefault(hypothesis.symbols, hypothesis)
    return list(kept.values())[:beam]


def sigmoid(x: float) -> float:
    """1 / (1 + exp(-x))."""
    return 1 / (1 + math.exp(-x)) if x > -700 else 0.0
