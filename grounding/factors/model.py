"""The factors: p(φ = true | γ, λ, Φ, Υ) = σ(Σ_c Σ_r W[c, r]), with facts c of the context and roles r of the symbol.

Every pair (c, r) is one binary feature; a factor is the logistic form of Equation 10 for a binary correspondence.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from grounding.factors.factor import Factor
from grounding.factors.first_pass import FirstPass


class Scorer:
    """Several factors that look at the same context, side by side in one matrix: the quick way to score."""

    def __init__(self, factors: Mapping[str, Factor]) -> None:
        facts = list(dict.fromkeys(fact for factor in factors.values() for fact in factor.facts))
        self.fact_ids = {fact: i for i, fact in enumerate(facts)}
        self.weights = np.zeros((len(facts), sum(len(factor.roles) for factor in factors.values()) + 1))
        self.role_ids: dict[str, dict[str, int]] = {}
        self.unseen = self.weights.shape[1] - 1  # a column of zeros, for roles that training has not seen
        offset = 0
        for name, factor in factors.items():
            rows = [self.fact_ids[fact] for fact in factor.facts]
            self.weights[rows, offset : offset + len(factor.roles)] = factor.weights
            self.role_ids[name] = {role: offset + i for i, role in enumerate(factor.roles)}
            offset += len(factor.roles)

    def values(self, facts: Iterable[str]) -> list[float]:
        """The weight of every role in a context, by column."""
        known = self.fact_ids
        rows = [known[fact] for fact in facts if fact in known]
        summed: list[float] = np.add.reduce(self.weights.take(rows, axis=0)).tolist()
        return summed

    def log_odds(self, family: str, values: Sequence[float], candidates: Iterable[Sequence[str]]) -> list[float]:
        """The log odds of φ = true for candidates of one family, each given by its roles."""
        column, unseen = self.role_ids[family].get, self.unseen
        return [sum([values[column(role, unseen)] for role in roles]) for roles in candidates]


@dataclass(frozen=True, eq=False)
class FactorModel:
    """The factors of all families.

    Attributes:
        factors: by the families' names.
        notes: plain values on how it came about.
        first_pass: what tells the kinds of symbols that a phrase needs, for hierarchical inference; None where it was
            not trained.
    """

    factors: Mapping[str, Factor]
    notes: Mapping[str, object]
    first_pass: FirstPass | None = None

    @property
    def feature_count(self) -> int:
        """How many binary features have a weight, over all families."""
        return sum(factor.feature_count for factor in self.factors.values())

    def scorer(self, families: Iterable[str]) -> Scorer:
        """The factors of some families, side by side; those that were not trained are left out."""
        return Scorer({name: self.factors[name] for name in families if name in self.factors})
