"""What other readers hold of the same text: features of the options that learned weights set off against each other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from grounding.meaning.discourse.told import Told
from grounding.model.belief import NOTHING, Objects, Reading, rows_of
from grounding.model.cases import Case
from grounding.model.evaluator import Evaluator

_LEAST = 1e-3  # shares of belief below this are alike


@dataclass(frozen=True)
class Opinion:
    """What one reader holds of a text.

    Attributes:
        name: of the reader, for features.
        shares: of belief, of every option that it knows.
        notes: indicators for all its options, by name.
        nothing: its share of belief that nothing is meant.
    """

    name: str
    shares: Mapping[Objects, float]
    notes: tuple[str, ...] = ()
    nothing: float = 0.0

    def features(self, option: Objects) -> dict[str, float]:
        """What it adds to an option."""
        if not self.shares and not self.nothing:
            return {}
        if option == NOTHING:
            return {f"nothing.{self.name}": float(np.log(self.nothing + _LEAST) - np.log(_LEAST))}
        share = self.shares.get(option, 0.0)
        found = {self.name: float(np.log(share + _LEAST) - np.log(_LEAST))}
        if share:
            found[f"{self.name}.held"] = 1.0
            found |= {f"{self.name}.{note}": 1.0 for note in self.notes}
        return found


@dataclass(eq=False)
class _Columns:
    rows: int
    found: dict[str, np.ndarray] = field(default_factory=dict)

    def put(self, row: int, features: Mapping[str, float]) -> None:
        for name, value in features.items():
            self.found.setdefault(name, np.zeros(self.rows))[row] = value


def with_opinions(
    readings: Sequence[Reading], opinions: Sequence[Opinion], evaluator: Evaluator, told: Told
) -> tuple[Reading, ...]:
    """Readings whose candidates know what others hold of them, and one more for what only others propose.

    Args:
        readings: of a text.
        opinions: of other readers.
        evaluator: of the scene.
        told: what the text tells, for the kind of action of what only others propose.
    """
    memory: dict[Objects, dict[str, float]] = {}

    def features(option: Objects) -> dict[str, float]:
        if option not in memory:
            memory[option] = {k: v for opinion in opinions for k, v in opinion.features(option).items()}
        return memory[option]

    known: set[Objects] = set()
    found = []
    for reading in readings:
        columns = {id(case): _Columns(case.size) for case in (*reading.cases, reading.nothing)}
        for option, case, row in rows_of(reading):
            known.add(option)
            columns[id(case)].put(row, features(option))
        cases = tuple(_extended(case, columns[id(case)]) for case in reading.cases)
        found.append(replace(reading, cases=cases, nothing=_extended(reading.nothing, columns[id(reading.nothing)])))
    rest = sorted({option for opinion in opinions for option in opinion.shares} - known - {NOTHING})
    if rest or not found:
        found.append(_unread(rest, features, evaluator, told))
    return tuple(found)


def _extended(case: Case, columns: _Columns) -> Case:
    return Case(case.size, case.truth, case.masks, dict(case.scalars), {**case.columns, **columns.found})


def _unread(rest: Sequence[Objects], features: object, evaluator: Evaluator, told: Told) -> Reading:
    """A reading of what only others propose."""
    index, n = evaluator.scene.layout.index, evaluator.scene.n
    masks = np.zeros((len(rest), n), dtype=bool)
    columns = _Columns(len(rest))
    for row, option in enumerate(rest):
        masks[row, [index[name] for name in option]] = True
        columns.put(row, features(option))  # type: ignore[operator]
    case = Case(len(rest), np.ones(len(rest)), masks, {"unread": 1.0}, columns.found)
    nothing = Case(1, np.ones(1), None, {"nothing": 1.0, "nothing.unread": 1.0})
    nothing.columns.update({name: np.array([value]) for name, value in features(NOTHING).items()})  # type: ignore[operator]
    return Reading(-1, evaluator, told, (case,) if rest else (), nothing)
