"""The factors: p(φ = true | γ, λ, Φ, Υ) = σ(Σ_c Σ_r W[c, r]), with facts c of the context and roles r of the symbol.

Every pair (c, r) is one binary feature; a factor is the logistic form of Equation 10 for a binary correspondence.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from grounding.world import Array


@dataclass(frozen=True, eq=False)
class Factor:
    """One family's weights.

    Attributes:
        facts: the facts of the context, in the order of the rows.
        roles: the roles of symbols, in the order of the columns.
        weights: W, shape (len(facts), len(roles)).
    """

    facts: tuple[str, ...]
    roles: tuple[str, ...]
    weights: Array

    @cached_property
    def fact_ids(self) -> dict[str, int]:
        """Row of every fact."""
        return {name: i for i, name in enumerate(self.facts)}

    @cached_property
    def role_ids(self) -> dict[str, int]:
        """Column of every role."""
        return {name: i for i, name in enumerate(self.roles)}

    @property
    def feature_count(self) -> int:
        """How many binary features have a weight."""
        return int(np.count_nonzero(self.weights))

    def role_weights(self, facts: Iterable[str]) -> dict[str, float]:
        """The weight of every role in a context; roles that training has not seen have none."""
        rows = [self.fact_ids[fact] for fact in facts if fact in self.fact_ids]
        return dict(zip(self.roles, self.weights[rows].sum(axis=0).tolist(), strict=True))

    def log_odds(self, facts: Iterable[str], candidates: Sequence[Sequence[str]]) -> list[float]:
        """The log odds of φ = true for candidates, each given by its roles, in one context."""
        rows = [row for row in map(self.fact_ids.get, facts) if row is not None]
        values = self.weights[rows].sum(axis=0).tolist()
        ids = self.role_ids
        return [sum(values[ids[role]] for role in roles if role in ids) for roles in candidates]


@dataclass(frozen=True, eq=False)
class FactorModel:
    """The factors of all families.

    Attributes:
        factors: by the families' names.
        notes: plain values on how it came about.
    """

    factors: Mapping[str, Factor]
    notes: Mapping[str, object]

    @property
    def feature_count(self) -> int:
        """How many binary features have a weight, over all families."""
        return sum(factor.feature_count for factor in self.factors.values())
