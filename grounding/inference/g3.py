"""Generalised Grounding Graphs (Equation 2), the elder baseline: correspondences are true, groundings are searched for.

There is one grounding variable a phrase, whose values are sets of symbols. With φ fixed to true, the search is for the
values that make the product of the factors largest:

    argmax over γ_1 ... γ_n of Π_i p(φ_i = true | γ_i, λ_i, γ_children, Υ)

The same factors are read so: that a set as a whole corresponds to a phrase means that each of its symbols does and that
no other one does, p(true | S) = Π_{γ in S} p(true | γ) Π_{γ not in S} p(false | γ). Where the distributed graph finds
the best set symbol by symbol, every value is written out and scored here as a whole. The power set of Γ has 2^|Γ|
values; as in the elder systems a few candidates bound it: in each stage the power set of the symbols that are the least
decided, joined with those that are surely true.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

import numpy as np

from grounding.factors.model import FactorModel
from grounding.features import STAGES, Scope
from grounding.geometry.layout import Layout
from grounding.inference.dcg import REPORTED_ODDS, Likely, likely_symbols
from grounding.inference.engine import Children, Memory, Tally, context_key, ground, sigmoid
from grounding.inference.hypotheses import Hypothesis, Inference
from grounding.language.tree import Phrase
from grounding.symbols import Symbol


class G3:
    """Search over the values of one grounding variable a phrase.

    Args:
        model: the factors.
        candidates: n; in each of the three stages 2^n values are written out, for every value of the stages before.
        beam: how many values a phrase keeps.
        least: values less likely than the best by this factor are dropped.
    """

    def __init__(self, model: FactorModel, candidates: int = 2, beam: int = 1, least: float = 0.02) -> None:
        if candidates < 0:
            raise ValueError(f"{candidates} candidates; there are 0 at least")
        self.model = model
        self.candidates = candidates
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
            SearchError: the world has so many things that their subsets cannot be listed.
        """
        tally = Tally()
        known: Memory = {} if memory is None else memory

        def local(phrase: Phrase, children: Children) -> list[Hypothesis]:
            key = context_key(phrase, children)
            if key not in known:
                found = list(self.values(Scope(phrase, children, layout), tally))
                known[key] = sorted(found, key=lambda h: -h.log_probability)[: self.beam]
            return known[key]

        return tally.inference(tree, ground(tree, local, self.beam, self.least))

    def values(self, scope: Scope, tally: Tally) -> Iterator[Hypothesis]:
        """Every value of the grounding variable of a phrase, with its score."""
        for concrete, first, seen in self.stage(scope, tally):
            settled = scope.with_concrete(concrete)
            for abstract, second, also in self.stage(settled, tally):
                last = settled.with_abstract(abstract)
                for rest, third, more in self.stage(last, tally):
                    yield Hypothesis(concrete | abstract | rest, first + second + third, (), {**seen, **also, **more})

    def stage(self, scope: Scope, tally: Tally) -> Iterator[tuple[frozenset[Symbol], float, dict[Symbol, float]]]:
        """The values of one stage: sets of symbols, the log of the factor for each as a whole, its symbols' chances."""
        likely = likely_symbols(self.scorers[scope.stage], scope, min(self.least, REPORTED_ODDS), tally)
        pairs = list(zip(likely.symbols, likely.log_odds, strict=True))
        told = {symbol: sigmoid(odds) for symbol, odds in pairs if odds > REPORTED_ODDS}
        for chosen in _values(likely, self.candidates):
            tally.evaluations += 1
            signs = np.where(np.isin(np.arange(len(pairs)), list(chosen)), -1.0, 1.0)
            log = likely.rest - float(np.logaddexp(0.0, signs * np.array(likely.log_odds)).sum())
            yield frozenset(likely.symbols[i] for i in chosen), log, told


def _values(likely: Likely, candidates: int) -> Iterator[frozenset[int]]:
    """Sets of symbols, by their places: what is surely true, with every subset of the candidates."""
    order = sorted(range(len(likely.symbols)), key=lambda i: abs(likely.log_odds[i]))
    open_ones, decided = order[:candidates], order[candidates:]
    sure = [i for i in decided if likely.log_odds[i] > 0]
    for size in range(len(open_ones) + 1):
        for some in itertools.combinations(open_ones, size):
            yield frozenset([*sure, *some])
