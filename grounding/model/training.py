"""Learning the weights: from texts of which only what they mean is known, by marginalising over their readings."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.optimize import minimize

from grounding.lexicon.parameters import value
from grounding.model.belief import Objects, Reading, rows_of
from grounding.model.cases import DOUBTS, MISHEARD, Case, Weights
from grounding.world import Array

ROUNDS = 200
SELDOM = -3.0
"""Log-odds from which is learned how often a text is misheard."""
_DEGREES = frozenset("T P R best looks shadow shadowed number parse within fit spread".split())


class Example(NamedTuple):
    """A text that was read, with what it means.

    Attributes:
        readings: of the text.
        gold: what may be meant; the empty tuple where nothing here is.
        weight: how much it counts.
    """

    readings: tuple[Reading, ...]
    gold: tuple[Objects, ...]
    weight: float = 1.0


@dataclass(frozen=True, eq=False)
class Problem:
    """All candidates of all readings of all texts.

    Attributes:
        names: of the features, in order.
        rows: features of every candidate, shape (r, f).
        text: of every row, shape (r,).
        gold: rows that stand for what is meant: (row, group), a group for each thing that may be meant.
        shares: of the text's weight, of every group.
        groups: the text of every group.
        texts: number of texts.
        weights: of the texts.
        options: how many things each text may mean.
        doubts: one, and what makes it likelier that a text is misheard, shape (texts, 1 + number of `DOUBTS`).
        lost: how many texts were left out, as no reading finds what they mean.
    """

    names: tuple[str, ...]
    rows: sparse.csr_matrix
    text: np.ndarray
    gold: np.ndarray
    shares: Array
    groups: np.ndarray
    texts: int
    weights: Array
    options: Array
    doubts: Array
    lost: int


def collect(examples: Iterable[Example]) -> Problem:
    """The rows of all texts whose meaning is among what their readings find."""
    builder = _Builder()
    for example in examples:
        builder.add(example)
    return builder.problem()


class _Builder:
    def __init__(self) -> None:
        self.index: dict[str, int] = {}
        self.parts: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
        self.text: list[int] = []
        self.gold: list[tuple[int, int]] = []
        self.groups: list[int] = []
        self.shares: list[float] = []
        self.weights: list[float] = []
        self.options: list[int] = []
        self.doubts: list[list[float]] = []
        self.count = 0
        self.lost = 0

    def add(self, example: Example) -> None:
        rows = [row for reading in example.readings for row in rows_of(reading)]
        present = {names for names, _, _ in rows}
        found = [names for names in example.gold if names in present]
        if not found or len(found) < len(example.gold):
            self.lost += 1
            return
        number = len(self.weights)
        self.weights.append(example.weight)
        self.options.append(len(present))
        doubts = example.readings[0].doubts
        self.doubts.append([1.0, *(doubts.get(name, 0.0) for name in DOUBTS)])
        groups = {names: len(self.groups) + place for place, names in enumerate(found)}
        self.groups += [number] * len(found)
        self.shares += [1.0 / len(found)] * len(found)
        start = self.count
        for reading in example.readings:
            for case in (reading.nothing, *reading.cases):
                self._case(case)
        kept = 0
        for reading in example.readings:
            for names, *_ in self._aligned(reading):
                if names in groups:
                    self.gold.append((start + kept, groups[names]))
                kept += 1
        self.text += [number] * kept
        self.count = start + kept

    @staticmethod
    def _aligned(reading: Reading) -> list[tuple[Objects, Case, int]]:
        """The candidates of a reading, those too that stand for no objects, so that rows keep their places."""
        found = {(id(case), row): names for names, case, row in rows_of(reading)}
        return [
            (found.get((id(case), row), ("",)), case, row)
            for case in (reading.nothing, *reading.cases) for row in range(case.size)
        ]  # fmt: skip

    def _case(self, case: Case) -> None:
        size = case.size
        columns, values = [], []
        for name, amount in case.scalars.items():
            columns.append(self._column(name))
            values.append(np.full(size, amount))
        for name, column in case.columns.items():
            columns.append(self._column(name))
            values.append(column)
        dense = np.array(values).reshape(len(columns), size).T
        row, place = np.nonzero(dense)
        at = np.array(columns, dtype=np.int32)
        self.parts.append((np.bincount(row, minlength=size), at[place], dense[row, place]))

    def _column(self, name: str) -> int:
        return self.index.setdefault(name, len(self.index))

    def problem(self) -> Problem:
        counts = np.concatenate([part[0] for part in self.parts])
        indptr = np.concatenate([[0], np.cumsum(counts)])
        indices = np.concatenate([part[1] for part in self.parts])
        data = np.concatenate([part[2] for part in self.parts])
        matrix = sparse.csr_matrix((data, indices, indptr), shape=(self.count, len(self.index)))
        return Problem(tuple(self.index), matrix, np.array(self.text), np.array(self.gold), np.array(self.shares),
                       np.array(self.groups), len(self.weights), np.array(self.weights),
                       np.array(self.options, dtype=float), np.array(self.doubts), self.lost)  # fmt: skip


def train(
    problem: Problem, prior: Weights, penalty: float = 1.0,
    progress: Callable[[int, float], None] | None = None,
) -> Weights:
    """Weights under which the texts mean what they mean, by L-BFGS with an L2 penalty towards a prior.

    A text may mean something else than what was read of it, then any option is as likely; how often is learned as well
    (`Weights.misheard`), so that a few such texts do not bend the weights, and answers are not too sure.

    Args:
        problem: the candidates.
        prior: weights from which the penalty measures.
        penalty: its strength.
        progress: told the round and the loss.
    """
    start = np.array([*(prior.get(name) for name in problem.names), SELDOM, *(0.0 for _ in DOUBTS)])
    rounds = 0

    def loss(w: Array) -> tuple[float, Array]:
        value, gradient = _likelihood(problem, w)
        away = w - start
        return value + 0.5 * penalty * float(away @ away), gradient + penalty * away

    def tell(w: Array) -> None:
        nonlocal rounds
        rounds += 1
        if progress is not None:
            progress(rounds, 0.0)

    bounds = [*(bound(name) for name in problem.names), (None, 0.0), *((0.0, None) for _ in DOUBTS)]
    found = minimize(
        loss, start, jac=True, method="L-BFGS-B", bounds=bounds, callback=tell, options={"maxiter": ROUNDS}
    )
    names = (*problem.names, MISHEARD, *DOUBTS)
    return Weights({name: float(value) for name, value in zip(names, found.x, strict=True)})


def bound(name: str) -> tuple[float | None, float | None]:
    """Within what the weight of a feature lies: what is truer is never less likely to be meant."""
    if name.startswith("nothing"):
        return (0.0, None) if "<" in name else (None, None)
    if "<" in name:
        return None, 0.0
    if name == "parse":
        return value("answer.parse"), None
    return (0.0, None) if name.split(".")[0] in _DEGREES else (None, None)


def _likelihood(problem: Problem, w: Array) -> tuple[float, Array]:
    """Negative log likelihood of what the texts mean, and its gradient; the last of w are for what was misheard."""
    odds = len(problem.names)
    misheard = (1.0 / (1.0 + np.exp(-(problem.doubts @ w[odds:]))))[problem.groups]
    scores = problem.rows @ w[:odds]
    most = np.full(problem.texts, -np.inf)
    np.maximum.at(most, problem.text, scores)
    raised = np.exp(scores - most[problem.text])
    whole = np.bincount(problem.text, raised, minlength=problem.texts)
    row, group = problem.gold.T
    meant = np.bincount(group, raised[row], minlength=len(problem.groups))
    importance = problem.shares * problem.weights[problem.groups]
    heard, by_chance = meant / whole[problem.groups], 1.0 / problem.options[problem.groups]
    likely = np.maximum((1.0 - misheard) * heard + misheard * by_chance, 1e-300)
    value = -float(importance @ np.log(likely))
    told = importance * (1.0 - misheard) * heard / likely  # how much each text has to say of the weights
    pull = (np.bincount(problem.groups, told, minlength=problem.texts) / whole)[problem.text] * raised
    np.subtract.at(pull, row, told[group] * raised[row] / np.maximum(meant[group], 1e-300))
    turn = importance * ((heard - by_chance) / likely) * misheard * (1.0 - misheard)
    doubt = turn @ problem.doubts[problem.groups]
    return value, np.concatenate([np.asarray(problem.rows.T @ pull), doubt])



