"""Conditional probabilities from counts, with back-off from specific to general contexts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

Row = Mapping[str, float]
"""Outcome -> how often it was seen in one context."""


class Level(NamedTuple):
    """What was seen in one context, as an estimate needs it."""

    row: Row
    total: float
    """How much was seen."""
    weight: float
    """Of the next more general context."""


class Chain(NamedTuple):
    """The levels of a chain of contexts, without contexts in which nothing was seen."""

    first: Level | None
    """Of the most general context."""
    rest: tuple[Level, ...]
    """Of the others, the most specific last."""

    def probability(self, outcome: str, base: float = 0.0) -> float:
        """P(outcome | the most specific context); see `BackOff.probability`."""
        value = base
        if self.first is not None:
            row, total, weight = self.first
            if not base:
                weight = 0.0
            value = (row.get(outcome, 0.0) + weight * value) / (total + weight)
        for row, total, weight in self.rest:
            value = (row.get(outcome, 0.0) + weight * value) / (total + weight)
        return value


class BackOff:
    """P(outcome | context), where a context is a chain of ever more general ones.

    Each level is interpolated with the next more general one after I. Witten and T. Bell, "The zero-frequency problem"
    (IEEE Transactions on Information Theory 37(4), 1991): the general level weighs as much as `novelty` times the
    number of different outcomes seen in the specific context.

    Attributes:
        rows: what was seen in every context.
        novelty: weight of the general level, positive.
    """

    def __init__(self, rows: Mapping[str, Row], novelty: float) -> None:
        self.rows = rows
        self.novelty = novelty
        self._levels: dict[str, Level | None] = {}

    @classmethod
    def count(cls, events: Iterable[tuple[Sequence[str], str, float]], novelty: float) -> BackOff:
        """Count.

        Args:
            events: (contexts from the most general to the most specific, outcome, count).
            novelty: weight of the general level, positive.
        """
        rows: dict[str, dict[str, float]] = {}
        for contexts, outcome, count in events:
            for context in contexts:
                row = rows.setdefault(context, {})
                row[outcome] = row.get(outcome, 0.0) + count
        return cls(rows, novelty)

    def probability(self, contexts: Sequence[str], outcome: str, base: float = 0.0) -> float:
        """P(outcome | the last of the contexts).

        Args:
            contexts: from the most general to the most specific, as when counted.
            outcome: the outcome.
            base: its probability before anything was seen; 0 leaves the most general context unsmoothed.
        """
        return self.chain(contexts).probability(outcome, base)

    def chain(self, contexts: Sequence[str]) -> Chain:
        """The levels of some contexts, for estimates of several outcomes."""
        first, *rest = map(self._level, contexts)
        return Chain(first, tuple(level for level in rest if level is not None))

    def _level(self, context: str) -> Level | None:
        if context not in self._levels:
            row = self.rows.get(context)
            level = None if row is None else Level(row, sum(row.values()), self.novelty * len(row))
            self._levels[context] = level
        return self._levels[context]
