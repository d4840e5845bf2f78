"""The Distributed Correspondence Graph (Equation 3) over all of Γ: every symbol is judged for every phrase.

The search is that of Section V-B: containers are the power set of the objects times the kinds, regions all relations
to each of those, attributes all combinations of their parts. The factors and the order of the stages are the adaptive
engine's, so that the two differ in what they judge and in nothing else.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from grounding.errors import SearchError
from grounding.factors.first_pass import FirstPass
from grounding.factors.model import FactorModel, Scorer
from grounding.features import STAGES, Family, Scope
from grounding.features.context import context_facts
from grounding.features.exhaustive import every
from grounding.geometry.layout import Layout
from grounding.inference.engine import Children, Kept, Memory, Tally, context_key, families, ground, sigmoid
from grounding.inference.first_pass import Restriction
from grounding.inference.hypotheses import Hypothesis, Inference, best_sets
from grounding.language.tree import Phrase
from grounding.symbols import Symbol
from grounding.world import Array

MOST_LIKELY = 20_000  # symbols of one family
REPORTED_ODDS = math.log(0.02 / 0.98)  # symbols less likely than this are not worth a place in a report

Judged = tuple[frozenset[Symbol], float, dict[Symbol, float]]  # symbols, log probability, probabilities of each


class Dcg:
    """Exhaustive inference with learned factors.

    Args:
        model: the factors; trained with all incorrect combinations as negatives, see `grounding.learning`.
        beam: how many hypotheses a phrase keeps.
        least: hypotheses less likely than the best by this factor are dropped.
        first_pass: if given, only symbols of those kinds are judged that it says a phrase needs.
    """

    def __init__(
        self, model: FactorModel, beam: int = 4, least: float = 0.02, first_pass: FirstPass | None = None
    ) -> None:
        self.model = model
        self.first_pass = first_pass
        self.restriction = None if first_pass is None else Restriction(first_pass)
        self.beam = beam
        self.least = math.log(least)
        self.scorers = tuple(model.scorer(family.name for family in families) for families in STAGES)

    def infer(self, tree: Phrase, layout: Layout, memory: Memory | None = None) -> Inference:
        """Ground every phrase of a tree.

        Args:
            tree: the parse.
            layout: the world, measured.
            memory: phrases grounded before by this engine in this world.

        Raises:
            SearchError: the world has so many things that their subsets cannot be listed, or the factors take
                thousands of symbols for likely.
        """
        tally = Tally()
        kept = None if self.restriction is None else self.restriction.kept(tree, layout, tally)
        known: Memory = {} if memory is None else memory

        def local(phrase: Phrase, children: Children) -> list[Hypothesis]:
            key = context_key(phrase, children)
            if key not in known:
                known[key] = self.local(Scope(phrase, children, layout), tally, kept)
            return known[key]

        return tally.inference(tree, ground(tree, local, self.beam, self.least))

    def local(self, scope: Scope, tally: Tally, kept: Kept | None = None) -> list[Hypothesis]:
        """The likeliest groundings of one phrase, given those of its children."""
        found: list[Hypothesis] = []
        for concrete, concrete_log, seen in self.judge(scope, tally, kept):
            settled = scope.with_concrete(concrete)
            for abstract, abstract_log, also in self.judge(settled, tally, kept):
                for rest, log, more in self.judge(settled.with_abstract(abstract), tally, kept):
                    total = concrete_log + abstract_log + log
                    found.append(Hypothesis(concrete | abstract | rest, total, (), {**seen, **also, **more}))
        found.sort(key=lambda h: -h.log_probability)
        return found[: self.beam]

    def judge(self, scope: Scope, tally: Tally, kept: Kept | None = None) -> list[Judged]:
        """The likeliest sets among all symbols of the stage that a scope is in."""
        least = min(self.least, REPORTED_ODDS)
        likely = likely_symbols(self.scorers[scope.stage], scope, least, tally, families(scope, kept))
        sets = best_sets(likely.log_odds, self.beam, self.least)
        pairs = zip(likely.symbols, likely.log_odds, strict=True)
        told = {symbol: sigmoid(odds) for symbol, odds in pairs if odds > REPORTED_ODDS}
        return [(frozenset(likely.symbols[i] for i in chosen), log + likely.rest, told) for chosen, log in sets]


class Likely:
    """What is left after all symbols of a stage were judged.

    Attributes:
        symbols: those that may be true.
        log_odds: theirs.
        rest: log probability that all others are false.
    """

    def __init__(self) -> None:
        self.symbols: list[Symbol] = []
        self.log_odds: list[float] = []
        self.rest = 0.0


def likely_symbols(
    scorer: Scorer, scope: Scope, least: float, tally: Tally, kept: Sequence[Family] | None = None
) -> Likely:
    """Judge every symbol of a stage.

    Args:
        scorer: the factors of the stage.
        scope: the phrase.
        least: symbols with log odds below this are summed up.
        tally: told how many symbols were judged.
        kept: the families that are judged; None: all of the stage.
    """
    found = Likely()
    values = scorer.values(context_facts(scope))
    weights = np.array(values)
    for family in STAGES[scope.stage] if kept is None else kept:
        column = scorer.role_ids.get(family.name)
        if column is None:
            continue
        space = every(scope, family.name)
        tally.add(family.name, space.size, space.judged)
        found.symbols += [symbol for symbol, _ in space.listed]
        found.log_odds += scorer.log_odds(family.name, values, [roles for _, roles in space.listed])
        count = 0
        for block, dropped in zip(space.blocks, space.dropped, strict=True):

            def lookup(names: Sequence[str], column: dict[str, int] = column) -> Array:
                return weights[[column.get(name, scorer.unseen) for name in names]]

            odds = block.log_odds(lookup)
            odds[list(dropped)] = -np.inf
            places = np.flatnonzero(odds > least)
            count += len(places)
            _bounded(family.name, count, space.size)
            found.symbols += [block.symbol(int(place)) for place in places]
            found.log_odds += odds[places].tolist()
            odds[places] = -np.inf
            found.rest -= float(np.logaddexp(0.0, odds).sum())
        alike = scorer.log_odds(family.name, values, [roles for roles, _ in space.alike])
        for (_, number), one in zip(space.alike, alike, strict=True):
            _bounded(family.name, number if one > 0 else 0, space.size)
            found.rest -= number * float(np.logaddexp(0.0, one))
    return found


def _bounded(family: str, likely: int, size: int) -> None:
    """Refuse to go on with factors that take thousands of symbols for likely."""
    if likely > MOST_LIKELY:
        raise SearchError(
            f"{likely:,} of {size:,} symbols of the family {family!r} are likely, at most {MOST_LIKELY:,} can be; are "
            "these factors trained with all incorrect combinations as negatives?"
        )
