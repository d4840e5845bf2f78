"""Training by maximum conditional likelihood with L-BFGS (Equation 10), L2 regularised.

Rows that are alike within a phrase are merged with counts. A weight belongs to a pair (fact of the context, role of the
symbol), so that the score of all rows is a product of two sparse matrices with W between them: the pairs themselves,
tens of millions of them, are never written out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from grounding.factors.factor import Factor
from grounding.world import Array

if TYPE_CHECKING:
    from scipy import sparse


@dataclass
class TrainingSet:
    """The rows of one family, phrase by phrase."""

    facts: dict[str, int] = field(default_factory=dict)
    roles: dict[str, int] = field(default_factory=dict)
    contexts: dict[tuple[int, ...], int] = field(default_factory=dict)
    rows: dict[tuple[int, tuple[int, ...], bool], float] = field(default_factory=dict)

    def add(self, facts: Iterable[str], candidates: Iterable[tuple[Sequence[str], bool]]) -> None:
        """Add a phrase.

        Args:
            facts: of its context.
            candidates: the roles of every symbol that was judged, with whether it is true of the phrase.
        """
        self.add_counted(facts, [(roles, label, 1) for roles, label in candidates])

    def add_counted(self, facts: Iterable[str], candidates: Iterable[tuple[Sequence[str], bool, float]]) -> None:
        """Add a phrase whose symbols are merged already.

        Args:
            facts: of its context.
            candidates: roles, whether symbols with those are true of the phrase, and how many such symbols there are.
        """
        role, known = self._role, self.rows
        rows = [(tuple(sorted({role(name) for name in roles})), label, count) for roles, label, count in candidates]
        if not rows:
            return
        context = tuple(self.facts.setdefault(fact, len(self.facts)) for fact in facts)
        place = self.contexts.setdefault(context, len(self.contexts))
        for chosen, label, count in rows:
            key = place, chosen, label
            known[key] = known.get(key, 0) + count

    def _role(self, name: str) -> int:
        return self.roles.setdefault(name, len(self.roles))


class Objective:
    """The regularised negative log likelihood of one family, and its gradient."""

    def __init__(self, data: TrainingSet, penalty: float, strictness: Callable[[str], float] = lambda _: 1.0) -> None:
        self.shape = (len(data.facts), len(data.roles))
        self.penalty = penalty * np.array([[strictness(role) for role in data.roles]])
        rows = list(data.rows)
        self.contexts = _indicator(list(data.contexts), self.shape[0])
        self.transposed = self.contexts.T.tocsr()
        self.row_of = np.repeat(np.arange(len(rows)), [len(row[1]) for row in rows])
        role_of = np.fromiter((role for row in rows for role in row[1]), dtype=np.int64)
        context_of = np.array([row[0] for row in rows], dtype=np.int64)
        self.cell_of = context_of[self.row_of] * self.shape[1] + role_of
        self.sign: Array = np.where([row[2] for row in rows], 1.0, -1.0)
        self.count = np.fromiter(data.rows.values(), dtype=np.float64)

    def __call__(self, flat: Array) -> tuple[float, Array]:
        """Value and gradient at the weights, flattened."""
        weights = flat.reshape(self.shape)
        by_context = np.asarray(self.contexts @ weights)
        cells = by_context.ravel()[self.cell_of]
        score = np.bincount(self.row_of, weights=cells, minlength=len(self.sign)).astype(np.float64)
        margin: Array = self.sign * score
        value = float(self.count @ np.logaddexp(0.0, -margin)) + 0.5 * float((self.penalty * weights**2).sum())
        residual = -self.sign * self.count * _sigmoid(-margin)
        scattered = np.bincount(self.cell_of, weights=residual[self.row_of], minlength=by_context.size)
        gradient = np.asarray(self.transposed @ scattered.reshape(by_context.shape))
        return value, (gradient + self.penalty * weights).ravel()


def train(
    data: TrainingSet,
    penalty: float = 1.0,
    iterations: int = 300,
    tolerance: float = 1e-5,
    on_step: Callable[[], None] | None = None,
    strictness: Callable[[str], float] = lambda _: 1.0,
) -> Factor:
    """Fit the weights of one family.

    Args:
        data: its rows.
        penalty: strength of the L2 regularisation.
        iterations: at most so many steps of L-BFGS.
        tolerance: it stops when the value falls by a smaller share than this.
        on_step: called after every step.
        strictness: how much more than `penalty` the weights of a role are held near zero.
    """
    facts, roles = tuple(data.facts), tuple(data.roles)
    if not data.rows:
        return Factor(facts, roles, np.zeros((len(facts), len(roles))))
    from scipy import optimize  # loaded late: grounding does not need it, and it takes most of a second

    objective = Objective(data, penalty, strictness)
    result = optimize.minimize(
        objective,
        np.zeros(len(facts) * len(roles)),
        jac=True,
        method="L-BFGS-B",
        callback=None if on_step is None else lambda _: on_step(),
        options={
            "maxiter": iterations,
            "ftol": tolerance * 1e-2,
            "gtol": 1e-4 * len(data.contexts) ** 0.5,
            "maxcor": 20,
        },
    )
    weights = result.x.reshape(objective.shape)
    weights[np.abs(weights) < 1e-6] = 0.0
    return Factor(facts, roles, weights)


def _indicator(rows: Sequence[Sequence[int]], width: int) -> sparse.csr_matrix:
    from scipy import sparse  # loaded late, see `train`

    pointers = np.concatenate([[0], np.cumsum([len(row) for row in rows])])
    indices = np.fromiter((i for row in rows for i in row), dtype=np.int64, count=int(pointers[-1]))
    return sparse.csr_matrix((np.ones(len(indices)), indices, pointers), shape=(len(rows), width))


def _sigmoid(x: Array) -> Array:
    return np.asarray(np.exp(-np.logaddexp(0.0, -x)))
