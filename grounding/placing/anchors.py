"""The references of a clue, as boxes on the floor plan with shares of belief."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grounding.meaning.nouns import Noun
from grounding.meaning.referents import OBJECTS, PLACE, SETS
from grounding.model.cases import Denotation
from grounding.model.phrases import PhraseReader
from grounding.world import Array

_MOST = 5  # hypotheses that are kept
_LEAST = 0.03  # of the likeliest one's share
_ITSELF = 0.02  # where all else is less likely than this, another of the kind of what is moved is meant


@dataclass(frozen=True, eq=False)
class Anchors:
    """Hypotheses about what is referred to.

    Attributes:
        members: indices of the objects of each.
        share: of belief, shape (h,), sum at most 1.
        low: corner of the box around the centres, in edges along "right" and "back", shape (h, 2).
        high: the other corner.
    """

    members: tuple[tuple[int, ...], ...]
    share: Array
    low: Array
    high: Array

    @property
    def centre(self) -> Array:
        """Middles of the boxes, shape (h, 2)."""
        return np.asarray((self.low + self.high) / 2)


def find_anchors(nouns: Sequence[Noun], source: int, points: Array, reader: PhraseReader) -> Anchors | None:
    """Look up what nouns may refer to.

    Args:
        nouns: one, or the two between which something lies.
        source: index of what is moved.
        points: centres of all objects in edges, shape (n, 2).
        reader: of the scene.

    Returns:
        None where they name nothing that is there.
    """
    found = _objects(nouns[0], source, reader)
    for noun in nouns[1:]:
        further = _objects(noun, source, reader)
        found = [
            (tuple(dict.fromkeys(a + b)), s * t) for a, s in found for b, t in further if set(a) != set(b)
        ] or found or further  # fmt: skip
    return _boxes(found, points)


def carrying(anchors: Anchors, bare: np.ndarray) -> Anchors:
    """Of what something may go on top of, what carries nothing yet; all of it where everything carries something.

    Args:
        anchors: hypotheses.
        bare: which objects carry nothing, shape (n,).
    """
    free = np.array([any(bare[i] for i in members) for members in anchors.members])
    if free.all() or not free.any():
        return anchors
    kept = np.flatnonzero(free)
    share = anchors.share[kept] / anchors.share[kept].sum() * anchors.share.sum()
    return Anchors(tuple(anchors.members[i] for i in kept), share, anchors.low[kept], anchors.high[kept])


def around(source: int, points: Array) -> Anchors:
    """The place where something stands itself."""
    return Anchors(((source,),), np.ones(1), points[[source]], points[[source]])


def _boxes(found: list[tuple[tuple[int, ...], float]], points: Array) -> Anchors | None:
    places: dict[tuple[float, ...], int] = {}
    members: list[tuple[int, ...]] = []
    shares: list[float] = []
    for group, chance in sorted(found, key=lambda item: -item[1])[: 2 * _MOST]:
        key = _corners(group, points)
        if key in places:
            shares[places[key]] += chance  # members of one stack stand at one place
            continue
        places[key] = len(members)
        members.append(group)
        shares.append(chance)
    if not members or sum(shares) <= 0:
        return None
    share = np.array(shares[:_MOST]) / sum(shares)
    kept = np.flatnonzero(share >= _LEAST * share.max())
    boxes = [points[list(members[i])] if len(members[i]) > 1 else points[members[i][0]][None] for i in kept]
    return Anchors(tuple(members[i] for i in kept), share[kept], np.array([b.min(axis=0) for b in boxes]),
                   np.array([b.max(axis=0) for b in boxes]))  # fmt: skip


def _corners(group: tuple[int, ...], points: Array) -> tuple[float, ...]:
    """Corners of the box around objects, coarsely: what is alike stands at one place."""
    if len(group) == 1:
        x, y = points[group[0]].tolist()
        return round(x, 1), round(y, 1)
    inside = points[list(group)]
    corners = [round(value, 1) for value in (*inside.min(axis=0).tolist(), *inside.max(axis=0).tolist())]
    return tuple(corners[:2]) if corners[:2] == corners[2:] else tuple(corners)


def _objects(noun: Noun, source: int, reader: PhraseReader) -> list[tuple[tuple[int, ...], float]]:
    referent, denotation = reader.noun(noun)
    if referent.sort == SETS and denotation.sets:
        return _sets(denotation, source)
    if referent.sort not in (OBJECTS, SETS, PLACE):
        return []
    weights = denotation.weights.copy()
    weights[source] = 0.0
    if weights.max(initial=0.0) <= _ITSELF < denotation.weights[source]:  # nothing is put beside itself
        weights = reader.among(referent, np.arange(len(weights)) != source).weights.copy()
        weights[source] = 0.0
    if not weights.any():
        return []
    return [((int(i),), float(weights[i])) for i in np.argsort(-weights, kind="stable")[: 2 * _MOST] if weights[i] > 0]


def _sets(denotation: Denotation, source: int) -> list[tuple[tuple[int, ...], float]]:
    found = []
    for mask, weight in denotation.sets:
        group = tuple(int(i) for i in np.flatnonzero(mask) if i != source)
        if group:
            found.append((group, weight * (1.0 if len(group) == int(mask.sum()) else 0.7)))
    return found
