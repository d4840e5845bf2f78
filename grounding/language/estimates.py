"""Conditional probabilities from counts, with back-off from specific to general contexts."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping, Sequence


class BackOff:
    """P(outcome | context), where a context is a chain of ever more general ones.

    Each level is interpolated with the next more general one after I. Witten and T. Bell, "The zero-frequency problem"
    (IEEE Transactions on Information Theory 37(4), 1991): the general level weighs as much as `novelty` times the
    number of different outcomes seen in the specific context.
    """

    def __init__(self, events: Iterable[tuple[Sequence[Hashable], Hashable, float]], novelty: float) -> None:
        """Count.

        Args:
            events: (contexts from the most general to the most specific, outcome, count).
            novelty: weight of the general level, positive.
        """
        self._novelty = novelty
        self._rows: dict[Hashable, dict[Hashable, float]] = {}
        for contexts, outcome, count in events:
            for context in contexts:
                row = self._rows.setdefault(context, {})
                row[outcome] = row.get(outcome, 0.0) + count
        self._totals = {context: sum(row.values()) for context, row in self._rows.items()}

    def outcomes(self, context: Hashable) -> Mapping[Hashable, float]:
        """What was seen in one context, with counts."""
        return self._rows.get(context, {})

    def probability(self, contexts: Sequence[Hashable], outcome: Hashable, base: float = 0.0) -> float:
        """P(outcome | the last of the contexts).

        Args:
            contexts: from the most general to the most specific, as when counted.
            outcome: the outcome.
            base: its probability before anything was seen; 0 leaves the most general context unsmoothed.
        """
        value = base
        for level, context in enumerate(contexts):
            row = self._rows.get(context)
            if row is None:
                continue
            weight = self._novelty * len(row) if level or base else 0.0
            value = (row.get(outcome, 0.0) + weight * value) / (self._totals[context] + weight)
        return value
