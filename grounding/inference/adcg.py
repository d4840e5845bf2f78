"""The Adaptive Distributed Correspondence Graph (Equations 11 to 14).

Phrases are grounded bottom-up. For each, the concrete symbols that its words express are inferred first; those that are
likely enough make up what abstract symbols are proposed; objects and actions are judged beside those. A beam of
hypotheses is kept for every phrase.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Sequence

from grounding.factors.first_pass import FirstPass
from grounding.factors.model import FactorModel
from grounding.features import STAGES, Scope
from grounding.features.context import context_facts
from grounding.geometry.layout import Layout
from grounding.inference.engine import Children, Kept, Memory, Tally, context_key, families, ground, sigmoid
from grounding.inference.first_pass import Restriction
from grounding.inference.hypotheses import Hypothesis, Inference, best_sets
from grounding.language.tree import Phrase
from grounding.symbols import Symbol

KEPT = 20_000  # phrases whose concrete symbols are remembered
_REPORTED_ODDS = math.log(0.02 / 0.98)  # symbols less likely than this are not worth a place in a report

Judged = tuple[frozenset[Symbol], float, dict[Symbol, float]]  # symbols, log probability, probabilities of each


class Adcg:
    """Inference with learned factors.

    Args:
        model: the factors.
        threshold: p_T; concrete symbols less likely than this take no part in what is proposed.
        beam: how many hypotheses a phrase keeps.
        least: hypotheses less likely than the best by this factor are dropped.
        first_pass: if given, only symbols of those kinds are proposed that it says a phrase needs.
    """

    def __init__(
        self,
        model: FactorModel,
        threshold: float = 0.05,
        beam: int = 4,
        least: float = 0.02,
        first_pass: FirstPass | None = None,
    ) -> None:
        self.model = model
        self.first_pass = first_pass
        self.restriction = None if first_pass is None else Restriction(first_pass)
        self.threshold = threshold
        self.beam = beam
        self.least = math.log(least)
        self.scorers = tuple(model.scorer(family.name for family in families) for families in STAGES)
        self.cutoff = max(self.least, _log_odds(threshold))
        self._concrete: OrderedDict[object, list[Judged]] = OrderedDict()

    def remembered(self, key: object) -> list[Judged] | None:
        """Concrete symbols inferred before for the same words and children, if they are still known."""
        return self._concrete.get(key)

    def remember(self, key: object, judged: list[Judged]) -> list[Judged]:
        """Keep what was inferred; the oldest is forgotten."""
        self._concrete[key] = judged
        if len(self._concrete) > KEPT:
            self._concrete.popitem(last=False)
        return judged

    def infer(self, tree: Phrase, layout: Layout, memory: Memory | None = None) -> Inference:
        """Ground every phrase of a tree.

        Args:
            tree: the parse.
            layout: the world, measured.
            memory: phrases grounded before in this world, shared between the parses of one sentence.
        """
        tally = Tally()
        kept = None if self.restriction is None else self.restriction.kept(tree, layout, tally)
        run = _Run(self, layout, {} if memory is None else memory, kept, tally)
        return run.tally.inference(tree, ground(tree, run.local, self.beam, self.least))


class _Run:
    """One tree in one world."""

    def __init__(self, settings: Adcg, layout: Layout, memory: Memory, kept: Kept | None, tally: Tally) -> None:
        self.settings = settings
        self.layout = layout
        self.memory = memory
        self.kept = kept
        self.tally = tally

    def local(self, phrase: Phrase, children: Children) -> list[Hypothesis]:
        """The likeliest groundings of one phrase, given those of its children."""
        key = context_key(phrase, children)
        known = self.memory.get(key)
        if known is not None:
            return known
        scope = Scope(phrase, children, self.layout)
        found: list[Hypothesis] = []
        for concrete, concrete_log, seen in self.concrete(scope):
            settled = scope.with_concrete(concrete)
            for abstract, abstract_log, also in self.judge(settled):
                last = settled.with_abstract(abstract)
                found += [
                    Hypothesis(
                        concrete | abstract | rest, concrete_log + abstract_log + log, (), {**seen, **also, **more}
                    )
                    for rest, log, more in self.judge(last)
                ]
        found.sort(key=lambda h: -h.log_probability)
        found = found[: self.settings.beam]
        self.memory[key] = found
        return found

    def concrete(self, scope: Scope) -> list[Judged]:
        """The likeliest concrete symbols; they depend on words and on what kinds of things the children say only."""
        facts = tuple(context_facts(scope))
        said = tuple(sorted((role, source.concrete) for role, source in scope.child_sources.items()))
        key = (facts, tuple(word.text for word in scope.phrase.words), said, scope.layout.types,
               scope.layout.has_stacks, scope.layout.size, families(scope, self.kept))  # fmt: skip
        known = self.settings.remembered(key)
        if known is None:
            known = self.settings.remember(key, self.judge(scope, facts))
        return known

    def judge(self, scope: Scope, facts: Sequence[str] | None = None) -> list[Judged]:
        """The likeliest sets of symbols of the stage that a scope is in."""
        scorer = self.settings.scorers[scope.stage]
        values = scorer.values(context_facts(scope) if facts is None else facts)
        symbols: list[Symbol] = []
        odds: list[float] = []
        for family in families(scope, self.kept):
            if family.name in scorer.role_ids:
                proposals = family.propose(scope)
                self.tally.add(family.name, len(proposals))
                symbols += [symbol for symbol, _ in proposals]
                odds += scorer.log_odds(family.name, values, [roles for _, roles in proposals])
        sets = best_sets(odds, self.settings.beam, self.settings.cutoff)
        likely = {s: sigmoid(o) for s, o in zip(symbols, odds, strict=True) if o > _REPORTED_ODDS}
        return [(frozenset([symbols[i] for i in chosen]), log, likely) for chosen, log in sets]


def _log_odds(probability: float) -> float:
    return math.log(probability / (1 - probability))
