"""The exact joint with abstract factors (Equation 9): no threshold, no beam, all of Γ.

    p(Φ | Λ, Γ, Υ) = Π_phrases Π_γ p(φ_γ | concrete) Π_γ p(φ_γ | abstract, given concrete) Π_γ p(φ_γ | last, given both)

Assignments of the concrete variables, of the abstract ones given those, and of the groundings of child phrases are
looked at in the order of their probability. No continuation is likelier than what it continues, so that the likeliest
whole is known when all that is left is less likely, and it is the true maximum. Marginals add up over the same order.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

from grounding.errors import SearchError
from grounding.factors.model import FactorModel
from grounding.features import STAGES, Scope
from grounding.geometry.layout import Layout
from grounding.inference.dcg import REPORTED_ODDS, Likely, likely_symbols
from grounding.inference.engine import Children, Memory, Tally, context_key, sigmoid
from grounding.inference.hypotheses import Hypothesis, Inference
from grounding.inference.streams import Stream, expand, ranked_sets
from grounding.language.tree import Phrase
from grounding.symbols import Symbol

REACH = math.log(1e-4)  # symbols with smaller odds are not taken for true in any assignment
_EXPLAINED = 0.95  # share of the probability after which marginals are added up no further
_PAIRS = 24  # at most so many assignments are added up


class Settled(NamedTuple):
    """An assignment of the variables of the stages so far, and the scope in which the next are judged."""

    symbols: frozenset[Symbol]
    scope: Scope


class Exact:
    """The maximum of the joint over all groundings of all phrases.

    Args:
        model: the factors.
        most: so many contexts are judged at most.
        beam: how many hypotheses are given for the root, the likeliest first.
        least: hypotheses less likely than the best by this factor are left out.
    """

    def __init__(self, model: FactorModel, most: int = 2000, beam: int = 1, least: float = 0.02) -> None:
        self.model = model
        self.most = most
        self.beam = beam
        self.least = math.log(least)
        self.scorers = tuple(model.scorer(family.name for family in families) for families in STAGES)

    def infer(self, tree: Phrase, layout: Layout, memory: Memory | None = None) -> Inference:
        """Ground every phrase of a tree.

        Args:
            tree: the parse.
            layout: the world, measured.
            memory: not used: nothing is kept between trees.

        Raises:
            SearchError: more contexts would have to be judged than allowed, or a world's subsets cannot be listed.
        """
        run = _Run(self, layout)
        found: list[Hypothesis] = []
        for log, hypothesis in islice(run.phrase(tree), self.beam):
            if found and log < found[0].log_probability + self.least:
                break
            found.append(hypothesis)
        return run.tally.inference(tree, [run.with_marginals(tree, hypothesis) for hypothesis in found])


class _Run:
    """One tree in one world."""

    def __init__(self, settings: Exact, layout: Layout) -> None:
        self.settings = settings
        self.layout = layout
        self.tally = Tally()
        self.contexts = 0
        self.variables = 0
        self._locals: dict[object, tuple[Scope, Stream[frozenset[Symbol]]]] = {}
        self._judged: dict[int, tuple[Scope, Likely]] = {}

    def phrase(self, phrase: Phrase) -> Stream[Hypothesis]:
        """The groundings of a phrase and all below it, the likeliest first; of those with the same symbols the best."""
        combined: Stream[tuple[Hypothesis, ...]] = Stream([(0.0, ())])
        for child in phrase.phrases:
            combined = self._joined(combined, self.phrase(child))

        def follow(children: tuple[Hypothesis, ...]) -> Iterator[tuple[float, Hypothesis]]:
            below = sum(child.log_probability for child in children)
            for log, symbols in self.local(phrase, tuple(child.symbols for child in children))[1]:
                yield log, Hypothesis(symbols, below + log, children)

        return Stream(_first_of_each(expand(combined, follow)))

    @staticmethod
    def _joined(first: Stream[tuple[Hypothesis, ...]], second: Stream[Hypothesis]) -> Stream[tuple[Hypothesis, ...]]:
        return Stream(expand(first, lambda taken: ((log, (*taken, one)) for log, one in second)))

    def local(self, phrase: Phrase, children: Children) -> tuple[Scope, Stream[frozenset[Symbol]]]:
        """The groundings of one phrase, given those of its children, the likeliest first."""
        key = context_key(phrase, children)
        if key not in self._locals:
            scope = Scope(phrase, children, self.layout)
            stream = expand(self.settled(scope), lambda s: self.assignments(s, 2))
            self._locals[key] = scope, Stream((log, found.symbols) for log, found in stream)
        return self._locals[key]

    def settled(self, scope: Scope) -> Iterator[tuple[float, Settled]]:
        """Assignments of the concrete and the abstract variables, the likeliest first."""
        concrete = self.assignments(Settled(frozenset(), scope), 0)
        return expand(concrete, lambda s: self.assignments(s, 1))

    def assignments(self, before: Settled, stage: int) -> Iterator[tuple[float, Settled]]:
        """Assignments of the variables of a stage, given those before, the likeliest first."""
        likely = self.judge(before.scope)
        for log, chosen in ranked_sets(likely.log_odds, likely.rest):
            symbols = frozenset(likely.symbols[i] for i in chosen)
            scope = before.scope
            if stage == 0:
                scope = scope.with_concrete(symbols)
            elif stage == 1:
                scope = scope.with_abstract(symbols)
            yield log, Settled(before.symbols | symbols, scope)

    def judge(self, scope: Scope) -> Likely:
        """All symbols of the stage that a scope is in; each scope is judged once."""
        if id(scope) not in self._judged:
            self.contexts += 1
            if self.contexts > self.settings.most:
                raise SearchError(
                    f"the likeliest of 2^{self.variables} assignments of the variables judged so far is not settled "
                    f"after {self.settings.most:,} contexts; allow more of them, or use adcg or dcg"
                )
            likely = likely_symbols(self.settings.scorers[scope.stage], scope, REACH, self.tally)
            self.variables += len(likely.symbols)
            self._judged[id(scope)] = scope, likely  # the scope is kept, so that its id stays its own
        return self._judged[id(scope)][1]

    def with_marginals(self, phrase: Phrase, hypothesis: Hypothesis) -> Hypothesis:
        """The same, with the probability of every symbol: summed over assignments, given the children's groundings."""
        children = tuple(map(self.with_marginals, phrase.phrases, hypothesis.children))
        scope, _ = self.local(phrase, tuple(child.symbols for child in children))
        chance: dict[Symbol, float] = {}
        first = self.judge(scope)
        for symbol, odds in zip(first.symbols, first.log_odds, strict=True):
            chance[symbol] = sigmoid(odds)
        self._add(chance, self.assignments(Settled(frozenset(), scope), 0))
        self._add(chance, self.settled(scope))
        told = {symbol: p for symbol, p in chance.items() if p > sigmoid(REPORTED_ODDS)}
        return Hypothesis(hypothesis.symbols, hypothesis.log_probability, children, told)

    def _add(self, chance: dict[Symbol, float], assignments: Iterator[tuple[float, Settled]]) -> None:
        """Add what the next stage gives to symbols, weighted by the assignments before it."""
        mass = 0.0
        sums: dict[Symbol, float] = {}
        for log, settled in islice(assignments, _PAIRS):
            mass += math.exp(log)
            likely = self.judge(settled.scope)
            for symbol, odds in zip(likely.symbols, likely.log_odds, strict=True):
                sums[symbol] = sums.get(symbol, 0.0) + math.exp(log) * sigmoid(odds)
            if mass > _EXPLAINED:
                break
        chance.update({symbol: value / mass for symbol, value in sums.items()} if mass > 0 else {})


def _first_of_each(stream: Iterator[tuple[float, Hypothesis]]) -> Iterator[tuple[float, Hypothesis]]:
    """Of alternatives with the same symbols the first, which is the likeliest."""
    seen: set[frozenset[Symbol]] = set()
    for log, hypothesis in stream:
        if hypothesis.symbols not in seen:
            seen.add(hypothesis.symbols)
            yield log, hypothesis
