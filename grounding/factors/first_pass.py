"""The factors of a first pass: p(a phrase needs symbols of a kind | its words, what its children need, the world).

They are log-linear as all factors are, with kinds of symbols as roles. The second pass, which infers groundings, looks
at the symbols of those kinds only that are likely enough to be needed.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from grounding.factors.factor import Factor
from grounding.world import Array


class Needs(NamedTuple):
    """What the first pass says of one phrase.

    Attributes:
        log_odds: that symbols of each kind are needed, in the order of `FirstPass.kinds`.
        likely: kinds more likely needed than not: what the phrases above are told.
        kept: kinds that are likely enough to be looked at.
    """

    log_odds: Array
    likely: tuple[str, ...]
    kept: frozenset[str]


@dataclass(frozen=True, eq=False)
class FirstPass:
    """What tells the kinds of symbols that a phrase needs.

    Attributes:
        factor: the weights; its roles are the kinds.
        threshold: kinds of at least this probability are kept; 0 keeps all.
    """

    factor: Factor
    threshold: float

    def __post_init__(self) -> None:
        if not 0 <= self.threshold < 1:
            raise ValueError(f"a threshold of {self.threshold}; it is a probability from 0 and below 1")

    @property
    def kinds(self) -> tuple[str, ...]:
        """The kinds that are judged."""
        return self.factor.roles

    @cached_property
    def cutoff(self) -> float:
        """The log odds of the threshold."""
        return math.log(self.threshold / (1 - self.threshold)) if self.threshold else -math.inf

    def needs(self, facts: Iterable[str]) -> Needs:
        """Judge all kinds for a phrase.

        Args:
            facts: of its context, see `grounding.features.needs`.
        """
        rows = [row for row in map(self.factor.fact_ids.get, facts) if row is not None]
        odds = self.factor.weights.take(rows, axis=0).sum(axis=0)
        pairs = list(zip(self.factor.roles, odds.tolist(), strict=True))
        likely = tuple([kind for kind, value in pairs if value > 0])
        return Needs(np.asarray(odds), likely, frozenset([kind for kind, value in pairs if value >= self.cutoff]))
