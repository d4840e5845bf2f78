"""Candidates of readings: the one that stands for some objects, and what features say of one beside another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np

from grounding.explanations.values import Contribution, Objects
from grounding.explanations.wording import feature_text
from grounding.language.parser import Parse
from grounding.model.belief import Belief, Reading, rows_of
from grounding.model.cases import Case, Weights
from grounding.result import Grounding
from grounding.world import World
from grounding.world.scene import Scene


class Understood(Protocol):
    """A text that was read: its parses, the world, what is believed, and the answer that follows."""

    @property
    def parses(self) -> Sequence[Parse]:
        """Of the text, the likeliest first."""

    @property
    def scene(self) -> Scene:
        """The world, measured."""

    @property
    def belief(self) -> Belief:
        """What is believed."""

    def decided(self) -> Grounding:
        """The answer."""


class Grounds(Protocol):
    """What understands texts, by weights of features."""

    @property
    def weights(self) -> Weights:
        """Of features."""

    def understand(self, text: str, world: World, history: Sequence[str] = ()) -> Understood:
        """Read an instruction."""


class Candidate(NamedTuple):
    """One thing that a referent may mean.

    Attributes:
        case: to which it belongs.
        row: its place there.
        score: by the weights.
        reading: of the text, where it is a candidate for what is handled.
    """

    case: Case
    row: int
    score: float
    reading: Reading | None = None


def of_readings(readings: Sequence[Reading], objects: Objects, weights: Weights) -> Candidate | None:
    """The likeliest candidate of some readings that stands for some objects; None where none does."""
    best: Candidate | None = None
    wanted = tuple(sorted(objects))
    for reading in readings:
        for names, case, row in rows_of(reading):
            if names == wanted and (best is None or _score(case, row, weights) > best.score):
                best = Candidate(case, row, _score(case, row, weights), reading)
    return best


def of_cases(cases: Sequence[Case], mask: np.ndarray, weights: Weights) -> Candidate | None:
    """The likeliest candidate of some cases that stands for a set of objects (n,); None where none does."""
    best: Candidate | None = None
    for case in cases:
        if case.masks is not None:
            rows = np.flatnonzero((case.masks == mask).all(axis=1))
        else:
            rows = np.flatnonzero(mask) if mask.sum() == 1 else np.zeros(0, dtype=int)
        for row in rows:
            score = _score(case, int(row), weights)
            if best is None or score > best.score:
                best = Candidate(case, int(row), score)
    return best


def likeliest(cases: Sequence[Case], weights: Weights) -> Candidate | None:
    """The likeliest candidate of some cases."""
    found = [(case, case.scores(weights)) for case in cases if case.size]
    best = max(found, key=lambda item: float(item[1].max()), default=None)
    if best is None:
        return None
    row = int(np.argmax(best[1]))
    return Candidate(best[0], row, float(best[1][row]))


def _score(case: Case, row: int, weights: Weights) -> float:
    return float(case.scores(weights)[row])


def compared(answer: Candidate, rival: Candidate, weights: Weights) -> tuple[Contribution, ...]:
    """What every feature says of a rival beside the answer, the weightiest first; their sum is that of the scores.

    Returns:
        weight times difference, of features for which that is not 0.
    """
    own, other = answer.case.features(answer.row), rival.case.features(rival.row)
    found = []
    for name in {**own, **other}:
        weight = weights.get(name, 0.0) * (other.get(name, 0.0) - own.get(name, 0.0))
        if weight:
            found.append(Contribution(feature_text(name), weight, name))
    return tuple(sorted(found, key=lambda c: (-abs(c.weight), c.feature)))
