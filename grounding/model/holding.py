"""How well something holds of every object, as truth and preference, and what is needed to tell."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

import numpy as np

from grounding.lexicon import arrangement, place
from grounding.lexicon.where import Where
from grounding.meaning.referents import Condition, Referent, Region
from grounding.model.cases import Denotation, Weights
from grounding.world import Array
from grounding.world.scene import Scene

SETS = 5
"""Of the sets that a referent may mean, so many are tried."""


class Held(NamedTuple):
    """How well a condition holds of every object.

    Attributes:
        truth: how true it is, shape (n,), in [0, 1].
        preference: which of those that it is true of would be meant, shape (n,), in [0, 1].
    """

    truth: Array
    preference: Array


class Evaluates(Protocol):
    """What evaluating a condition needs: the scene, whose directions are meant, and what referents mean."""

    scene: Scene
    where: Where
    view: str
    weights: Weights
    history: tuple[int, ...]

    def denote(self, referent: Referent, base: Array | None = None, *, carrying: bool = False) -> Denotation:
        """What a referent means."""

    def spot(self, region: Region) -> place.Spot:
        """A place as whoever is meant sees it."""

    def arrangements(
        self, kinds: tuple[str, ...], stuff: np.ndarray, number: int | None, colours: tuple[str, ...] = ()
    ) -> tuple[arrangement.Candidate, ...]:
        """The arrangements of some kinds among objects."""


Restricting = Callable[[Evaluates, Condition, Array], Held]


def plain(truth: Array) -> Held:
    """What holds to some degree, whatever would be meant."""
    return Held(np.clip(truth, 0.0, 1.0), np.ones(len(truth)))


def related(
    denotation: Denotation, truth: Array, preference: Array, number: int | None = None, *, together: bool = False
) -> Held:
    """A relation of objects to objects, made one of objects to what a referent means.

    Args:
        denotation: what the referent means.
        truth: of every object (row) to every other one, shape (n, n).
        preference: the same for which is meant.
        number: how many the referent says it is.
        together: whether it has to hold of all its members: "near the red and the blue block".
    """
    truth = np.where(np.eye(len(truth), dtype=bool), 0.0, truth)
    if denotation.sets:
        return _related_to_sets(denotation, truth, truth * preference, number, together=together)
    likely = denotation.weights[None, :]
    return fraction(_some(truth * likely), _some(truth * preference * likely))


def _some(chances: Array) -> Array:
    """How likely one at least holds, by rows."""
    return np.asarray(1.0 - np.exp(np.log1p(-np.minimum(chances, 1 - 1e-9)).sum(axis=1)))


def fraction(truth: Array, held: Array) -> Held:
    """Truth, and of that the part that is preferred as well."""
    return Held(truth, np.divide(held, truth, out=np.ones_like(held), where=truth > 1e-9))


def _related_to_sets(
    denotation: Denotation, truth: Array, held: Array, number: int | None, *, together: bool
) -> Held:  # fmt: skip
    best_truth, best = np.zeros(len(truth)), np.zeros(len(truth))
    for mask, chance in denotation.sets[:SETS]:
        count = int(mask.sum())
        if not count:
            continue
        several = 1 < count <= 3 and number is not None
        over = np.min if together else np.mean if several else np.max
        inside, true = over(held[:, mask], axis=1), over(truth[:, mask], axis=1)
        best = np.maximum(best, chance * inside * ~mask)
        best_truth = np.maximum(best_truth, chance * true * ~mask)
    return fraction(best_truth, best)
