"""One factor: the weights of the facts of a context, each with the roles of a symbol."""

from __future__ import annotations

from collections.abc import Iterable
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
