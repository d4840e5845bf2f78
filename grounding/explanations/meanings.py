"""The meaning of a reading, line by line, with how well each holds of the answer and of the runner-up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from grounding.explanations.candidates import Candidate, likeliest, of_cases
from grounding.explanations.conditions import degrees_of, peaks, reasons
from grounding.explanations.values import Contribution, Degrees, LineExplained, Objects
from grounding.explanations.wording import condition_text, referent_text
from grounding.meaning.discourse.told import Told
from grounding.meaning.notation import Line, lines, meaning_of, write
from grounding.meaning.referents import OBJECTS, SETS, Condition, Referent
from grounding.model.belief import Reading
from grounding.model.cases import Case, Denotation
from grounding.model.restricting import base_of
from grounding.world import Array

LIKELY = 4  # of the objects or sets that a referent may mean, so many are told
LEAST = 0.005
_MISSING = 0.5  # truth below which a condition holds of nothing


class Meanings:
    """The meaning of a reading with what its referents mean.

    Args:
        reading: of a text.
        answer: ids of what was taken, empty where nothing was.
        rival: ids of the runner-up, empty where there is none.
    """

    def __init__(self, reading: Reading, answer: Objects, rival: Objects) -> None:
        self.reading = reading
        self.evaluator = reading.evaluator
        self.answer, self.rival = answer, rival
        told = meaning_of(reading.told)
        self.referents = tuple(r for r in (told.target, told.mentioned) if r is not None)
        self.lines = lines(*self.referents)
        self.bases: dict[Referent, Array] = {}
        for line in self.lines:
            if line.condition is not None and line.referent.conditions:
                for inner in line.condition.of:
                    self.bases.setdefault(inner, base_of(self.evaluator.scene, line.referent.conditions))
        self.same = set(self._same(told.target)) if told.target is not None else set()

    def _same(self, referent: Referent) -> Iterator[Referent]:
        """A referent and those that are said to be the same."""
        yield referent
        for condition in referent.conditions:
            if condition.concept == "same" and not condition.negated:
                yield from self._same(condition.of[0])

    def denotation(self, referent: Referent) -> Denotation:
        """What a referent means."""
        return self.evaluator.denote(referent, self.bases.get(referent))

    def cases(self, referent: Referent) -> Sequence[Case]:
        """The cases of a referent; those of the target as they were weighed."""
        return self.reading.cases if referent is self.reading.told.target else self.denotation(referent).cases

    def candidate(self, referent: Referent, objects: Objects) -> Candidate | None:
        """The candidate of a referent that stands for some objects."""
        scene = self.evaluator.scene
        mask = np.zeros(scene.n, dtype=bool)
        mask[[scene.layout.index[name] for name in objects if name in scene.layout.index]] = True
        return of_cases(self.cases(referent), mask, self.evaluator.weights) if mask.any() else None

    def names(self, candidate: Candidate) -> Objects:
        """The ids that a candidate stands for."""
        return self._ids(candidate.case, candidate.row)

    def _ids(self, case: Case, row: int) -> Objects:
        ids = self.evaluator.scene.layout.ids
        return (ids[row],) if case.masks is None else tuple(sorted(ids[i] for i in np.flatnonzero(case.masks[row])))

    def explained(self) -> tuple[LineExplained, ...]:
        """The lines, those of the goal first."""
        told: Told = self.reading.told
        head = len(self.lines)
        goal = write(told).splitlines()
        return (
            *(LineExplained(text) for text in goal[: len(goal) - head]),
            *(self._line(line) for line in self.lines),
        )

    def _line(self, line: Line) -> LineExplained:
        if line.condition is None:
            denoted = self.denotation(line.referent)
            truth = denoted.truth if line.referent.sort in (OBJECTS, SETS) else None
            return LineExplained(line.text, line.name, likely=self.likely(denoted), truth=truth)
        found: list[tuple[Objects, Degrees]] = []
        for candidate in self._shown(line.referent):
            degrees = self.degrees(line.condition, candidate)
            if any(degree is not None for degree in degrees):
                found.append((self.names(candidate), degrees))
        return LineExplained(line.text, line.name, tuple(found))

    def degrees(self, condition: Condition, candidate: Candidate) -> Degrees:
        """How well a condition holds of a candidate; of a membership how likely a set is that has it as a member."""
        found = degrees_of(condition, candidate)
        if not condition.chooses:
            return found
        denoted = self.denotation(condition.of[0])
        members = [self.evaluator.scene.layout.index[name] for name in self.names(candidate)]
        chances = [float(chance) for mask, chance in denoted.sets if mask[members].all()]
        if not denoted.sets:
            chances = [float(denoted.weights[members].min())] if members else []
        return found._replace(truth=max(chances, default=0.0))

    def _shown(self, referent: Referent) -> list[Candidate]:
        """The answer and the runner-up where they are meant, else the likeliest."""
        found: list[Candidate | None] = []
        if referent in self.same:
            found = [self.candidate(referent, objects) for objects in (self.answer, self.rival)]
        found = found if any(found) else [likeliest(self.cases(referent), self.evaluator.weights)]
        return [candidate for candidate in found if candidate is not None]

    def likely(self, denotation: Denotation) -> tuple[tuple[Objects, float], ...]:
        """The objects or sets that are likeliest meant, with their weights."""
        ids = self.evaluator.scene.layout.ids
        if denotation.sets:
            found = [(tuple(sorted(ids[i] for i in np.flatnonzero(mask))), chance) for mask, chance in denotation.sets]
        else:
            found = [((name,), float(weight)) for name, weight in zip(ids, denotation.weights, strict=True)]
        kept = [(names, float(weight)) for names, weight in found if names and weight > LEAST]
        return tuple(sorted(kept, key=lambda item: (-item[1], item[0]))[:LIKELY])

    def reasons(self, rival: Objects) -> tuple[Contribution, ...]:
        """Why a rival fits less, the weightiest first."""
        found: dict[str, Contribution] = {}
        for line in self.lines:
            if line.condition is not None or line.referent not in self.same:
                continue
            own, other = self.candidate(line.referent, self.answer), self.candidate(line.referent, rival)
            if own is not None and other is not None:
                for reason in reasons(line.referent, own, other, self.degrees, " ".join(rival)):
                    found.setdefault(reason.text, reason)
        return tuple(sorted(found.values(), key=lambda reason: (reason.weight, reason.text)))

    def missing(self) -> tuple[str, ...]:
        """What is said to be there and is not, in words."""
        found: list[str] = []
        for line in self.lines:
            if line.condition is None and line.referent.sort in (OBJECTS, SETS):
                found += self._missing(line.referent)
        return tuple(dict.fromkeys(found))

    def _missing(self, referent: Referent) -> list[str]:
        cases = self.cases(referent)
        candidates = [Candidate(case, row, 0.0) for case in cases for row in range(case.size)]
        held = list(peaks(referent, candidates))
        untrue = [condition for condition, truth in held if truth < _MISSING and condition.concept != "same"]
        if untrue:
            return [f"nothing here is {condition_text(condition)}" for condition in untrue]
        best = max((float(case.truth.max(initial=0.0)) for case in cases), default=0.0)
        if best >= _MISSING or any(condition.concept == "same" for condition in referent.conditions):
            return []
        said = [condition_text(condition) for condition, _ in held]
        if len(said) > 1:
            return [f"nothing here is {' and '.join(said)}"]
        return [f'there is no "{referent_text(referent)}"']
