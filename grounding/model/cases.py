"""What a referent may mean: cases with candidates, their features, and what is believed of them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from grounding.lexicon.place import Spot
from grounding.world import Array

MISHEARD = "misheard"
"""The name under which weights keep the log-odds that a text means something else than what was read of it."""
LONG, UNKNOWN = DOUBTS = ("misheard.long", "misheard.unknown")
"""What raises these odds: doublings of a text's length beyond `SHORT` words, and words that nobody knows."""
SHORT = 10


class Weights(dict[str, float]):
    """Weights by the names of features; what has none counts as where all concepts count the same.

    Then the truth, the preference and the rank of every family count once; bins, words, comparisons and preferences
    beside ranks count nothing.
    """

    def get(self, name: str, default: float = 0.0) -> float:  # type: ignore[override]
        """The weight of a feature."""
        found = dict.get(self, name)
        return equal(name) if found is None else found

    @property
    def misheard(self) -> float:
        """How often a short text means something else than what was read of it, so that any option is as likely."""
        return self.mishearing({})

    def mishearing(self, doubts: Mapping[str, float]) -> float:
        """How often a text means something else than what was read of it.

        Args:
            doubts: what makes that likelier, by the names in `DOUBTS`.
        """
        if MISHEARD not in self:
            return 0.0
        odds = self[MISHEARD] + sum(dict.get(self, name, 0.0) * amount for name, amount in doubts.items())
        return 1.0 / (1.0 + math.exp(-odds))


def doubts_of(words: int, unknown: int) -> Mapping[str, float]:
    """What makes it likelier that a text is misheard.

    Args:
        words: of the text.
        unknown: how many of them nobody knows.
    """
    return {LONG: max(math.log2(max(words, 1) / SHORT), 0.0), UNKNOWN: float(unknown)}


def equal(name: str) -> float:
    """The weight of a feature where all concepts count the same."""
    plain = not ("<" in name or ":" in name or name.endswith(".ranked"))
    return 1.0 if name[:2] in ("T.", "P.", "R.") and plain else 0.0



class Learned(NamedTuple):
    """What was learned.

    Attributes:
        deciding: weights by which it is decided what a text means, from all that was read of it.
        referring: weights by which it is judged what is spoken of on the way, by its conditions alone.
    """

    deciding: Weights
    referring: Weights


@dataclass(eq=False)
class Case:
    """One way to take a referent, such as one of the rows that "the row" may be, with the candidates that it leaves.

    Attributes:
        size: how many candidates there are.
        masks: of each candidate, shape (m, n); None where the candidates are the n objects one by one.
        scalars: features of the case as a whole.
        columns: features of every candidate, each of shape (m,).
        truth: how well all that is said holds of every candidate, shape (m,), in [0, 1].
    """

    size: int
    truth: Array
    masks: np.ndarray | None = None
    scalars: dict[str, float] = field(default_factory=dict)
    columns: dict[str, Array] = field(default_factory=dict)

    def add(self, name: str, column: Array) -> None:
        """Add to a feature of the candidates."""
        before = self.columns.get(name)
        self.columns[name] = column if before is None else before + column

    def note(self, name: str, value: float = 1.0) -> None:
        """Add to a feature of the case."""
        self.scalars[name] = self.scalars.get(name, 0.0) + value

    def scores(self, weights: Weights) -> Array:
        """The log-linear score of every candidate, shape (m,)."""
        total = np.full(self.size, sum(weights.get(name, 0.0) * value for name, value in self.scalars.items()))
        for name, column in self.columns.items():
            weight = weights.get(name, 0.0)
            if weight:
                total = total + weight * column
        return total


    def features(self, row: int) -> dict[str, float]:
        """All features of one candidate."""
        return {**self.scalars, **{name: float(column[row]) for name, column in self.columns.items()}}


@dataclass(frozen=True, eq=False)
class Denotation:
    """What a referent means in a scene.

    Attributes:
        weights: how likely each object is what is meant or belongs to it, shape (n,), at most 1 and 1 for the best.
        sets: candidates for what several mean, each a boolean mask (n,) with a weight in [0, 1], the likeliest first.
        truth: how well what is said holds of what it fits best, in [0, 1]; of all referents within as well.
        cases: from which it was found.
        spot: of a place.
        person: "robot" or "speaker".
    """

    weights: Array
    sets: tuple[tuple[np.ndarray, float], ...] = ()
    truth: float = 1.0
    cases: tuple[Case, ...] = ()
    spot: Spot | None = None
    person: str | None = None

    @property
    def likely(self) -> np.ndarray:
        """The objects that are not unlikely, boolean (n,)."""
        return np.asarray(self.weights > 0.3)


def combined(cases: list[Case], weights: Weights, n: int, truths: float, *, several: bool) -> Denotation:
    """What cases leave, by the scores of their candidates.

    Args:
        cases: of one referent.
        weights: of features.
        n: number of objects.
        truths: the truth of the referents to which it relates.
        several: whether candidates are sets.
    """
    kept = [case for case in cases if case.size]
    if not kept:
        return Denotation(np.zeros(n), truth=0.0)
    scores = [case.scores(weights) for case in kept]
    best = max(float(score.max()) for score in scores)
    truth = truths * max(float(case.truth[int(np.argmax(score))]) for case, score in zip(kept, scores, strict=True))
    total = np.zeros(n)
    if not several:
        for score in scores:
            total += np.exp(score - best)
        return Denotation(total / max(float(total.max()), 1e-12), (), truth, tuple(kept))
    found: dict[bytes, tuple[np.ndarray, float]] = {}
    for case, score in zip(kept, scores, strict=True):
        assert case.masks is not None
        for mask, chance in zip(case.masks, np.exp(score - best), strict=True):
            key = mask.tobytes()
            found[key] = (mask, found[key][1] + float(chance) if key in found else float(chance))
    most = max(chance for _, chance in found.values())
    sets = sorted(((mask, chance / most) for mask, chance in found.values()), key=lambda item: -item[1])
    for mask, chance in sets:
        total = np.maximum(total, mask * chance)
    return Denotation(total, tuple(sets), truth, tuple(kept))
