"""What phrases are worth in a graded reading: objects with weights, sets, places, people."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from grounding.world import Array

SETS = 5
"""Of the sets that a phrase may mean, so many are tried."""


@dataclass(frozen=True, eq=False)
class Place:
    """A part of the table or of a set.

    Attributes:
        directions: unit vectors (2,) that lead to it; none for the middle.
        names: of the directions.
        middle: whether it is the middle, along what the directions leave free.
        corner: whether a corner is meant.
        bare: whether only directions were named ("the left"), without a noun of place.
        owner: whose side it is, or None.
        outer: whether it is any corner, edge or end, as no direction was named.
    """

    directions: tuple[Array, ...] = ()
    names: tuple[str, ...] = ()
    middle: bool = False
    corner: bool = False
    bare: bool = False
    owner: str | None = None
    outer: bool = False

    @property
    def upright(self) -> int:
        """Where it is in a stack: 1 for its top, -1 for its bottom, 0 for neither."""
        return 1 if "up" in self.names else -1 if "down" in self.names else 0


@dataclass(frozen=True, eq=False)
class Value:
    """The denotation of a noun phrase.

    Attributes:
        kind: objects, sets, place, table, agent, or nothing.
        weights: of each object in [0, 1], shape (n,): how well it is what is meant (objects), or how likely it belongs
            to what is meant (sets).
        sets: candidates for what several mean, each a boolean mask (n,) with a weight in [0, 1].
        place: of a place.
        agent: "robot" or "speaker".
        definite: False for "a block".
        number: how many are meant, or None.
        kinds: of arrangement, for sets.
    """

    kind: str
    weights: Array
    sets: tuple[tuple[np.ndarray, float], ...] = ()
    place: Place | None = None
    agent: str | None = None
    definite: bool = True
    number: int | None = None
    kinds: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Restriction:
    """A modifier that holds of objects to a degree, shape (n,).

    Attributes:
        weights: the degree.
        preferred: whether it only prefers: who is ranked or counted does not depend on it ("in front of you").
        order: how an ordinal of the noun counts along it ("the second block below the tower"), larger first, or None.
        lane: the degree by direction alone, which holds of those that are counted, or None.
    """

    weights: Array
    order: Array | None = None
    lane: Array | None = None
    preferred: bool = False


@dataclass(frozen=True, eq=False)
class Membership:
    """A modifier that names the set from which is chosen, and what kind of arrangement that is."""

    sets: tuple[tuple[np.ndarray, float], ...]
    kinds: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Rank:
    """A modifier that orders: larger keys first.

    Attributes:
        key: shape (n,).
        ordinal: the rank asked for, or None where the noun may have one.
        noise: differences of the key that are hard to see.
        height: what orders within a stack instead: 1 from its top, -1 from its bottom, 0 for the key.
    """

    key: Array
    ordinal: int | None
    noise: float
    height: int = 0


Effect = Restriction | Membership | Rank
