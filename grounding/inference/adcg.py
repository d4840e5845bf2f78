"""The Adaptive Distributed Correspondence Graph (Equations 11 to 14).

Phrases are grounded bottom-up. For each, the concrete symbols that its words express are inferred first; those that are
likely enough make up what abstract symbols and objects are proposed, and these are then judged. A beam of hypotheses is
kept for every phrase.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from grounding.factors.model import FactorModel
from grounding.features import STAGES, Family, Scope
from grounding.features.context import context_facts
from grounding.geometry.layout import Layout
from grounding.inference.hypotheses import Hypothesis, Inference, best_combinations, best_sets
from grounding.language.tree import Phrase
from grounding.symbols import Symbol

REPORTED = 0.02  # symbols less likely than this are not worth a place in a report


class Adcg:
    """Inference with learned factors.

    Args:
        model: the factors.
        threshold: p_T; concrete symbols less likely than this take no part in what is proposed.
        beam: how many hypotheses a phrase keeps.
        least: hypotheses less likely than the best by this factor are dropped.
    """

    def __init__(self, model: FactorModel, threshold: float = 0.05, beam: int = 4, least: float = 0.02) -> None:
        self.model = model
        self.threshold = threshold
        self.beam = beam
        self.least = math.log(least)

    def infer(self, tree: Phrase, layout: Layout, memory: dict[object, list[Hypothesis]] | None = None) -> Inference:
        """Ground every phrase of a tree.

        Args:
            tree: the parse.
            layout: the world, measured.
            memory: phrases grounded before in this world, shared between the parses of one sentence.
        """
        run = _Run(self, layout, {} if memory is None else memory)
        hypotheses = run.phrase(tree)
        return Inference(tree, tuple(hypotheses), run.evaluations, run.symbols)


class _Run:
    """One tree in one world."""

    def __init__(self, settings: Adcg, layout: Layout, memory: dict[object, list[Hypothesis]]) -> None:
        self.settings = settings
        self.layout = layout
        self.memory = memory
        self.evaluations = 0
        self.symbols = 0

    def phrase(self, phrase: Phrase) -> list[Hypothesis]:
        lists = [self.phrase(child) for child in phrase.phrases]
        found: list[Hypothesis] = []
        for children in best_combinations(lists, self.settings.beam):
            below = sum(child.log_probability for child in children)
            for own in self.local(phrase, tuple(child.symbols for child in children)):
                found.append(
                    Hypothesis(own.symbols, below + own.log_probability, children, own.probabilities)
                )  # fmt: skip
        found.sort(key=lambda h: -h.log_probability)
        best = found[0].log_probability
        kept: dict[frozenset[Symbol], Hypothesis] = {}
        for hypothesis in found:
            if hypothesis.log_probability >= best + self.settings.least:
                kept.setdefault(hypothesis.symbols, hypothesis)
        return list(kept.values())[: self.settings.beam]

    def local(self, phrase: Phrase, children: tuple[frozenset[Symbol], ...]) -> list[Hypothesis]:
        """The likeliest groundings of one phrase, given those of its children."""
        words = tuple((word.text, word.tag) for word in phrase.words)
        key = (phrase.tag, words, tuple(child.tag for child in phrase.phrases), children,
               tuple(child.words[:1] for child in phrase.phrases))  # fmt: skip
        known = self.memory.get(key)
        if known is not None:
            return known
        scope = Scope(phrase, children, self.layout)
        found: list[Hypothesis] = []
        for concrete, concrete_log, seen in self.judge(scope, STAGES[0], settled=False):
            settled = scope.with_concrete(concrete)
            for abstract, abstract_log, also in self.judge(settled, STAGES[1], settled=True):
                found.append(Hypothesis(concrete | abstract, concrete_log + abstract_log, (), {**seen, **also}))
        found.sort(key=lambda h: -h.log_probability)
        found = found[: self.settings.beam]
        self.memory[key] = found
        return found

    def judge(
        self, scope: Scope, families: Sequence[Family], settled: bool
    ) -> list[tuple[frozenset[Symbol], float, dict[Symbol, float]]]:
        """The likeliest sets of symbols of some families: (symbols, log probability, probabilities)."""
        facts = context_facts(scope, settled)
        symbols: list[Symbol] = []
        odds: list[float] = []
        for family in families:
            proposals = family.propose(scope)
            if not proposals:
                continue
            factor = self.settings.model.factors.get(family.name)
            if factor is None:
                continue
            symbols += [symbol for symbol, _ in proposals]
            odds += factor.log_odds(facts, [roles for _, roles in proposals])
        self.evaluations += len(symbols)
        self.symbols += len(symbols)
        sets = best_sets(odds, self.settings.beam, max(self.settings.least, _log_odds(self.settings.threshold)))
        likely = {s: _sigmoid(o) for s, o in zip(symbols, odds, strict=True) if o > _log_odds(REPORTED)}
        return [(frozenset(symbols[i] for i in chosen), log, likely) for chosen, log in sets]


def _sigmoid(x: float) -> float:
    return 1 / (1 + math.exp(-x)) if x > -700 else 0.0


def _log_odds(probability: float) -> float:
    return math.log(probability / (1 - probability))
