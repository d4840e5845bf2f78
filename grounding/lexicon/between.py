"""Between two things, and amid several, each part of which may be counted: "three green ones and a blue one"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grounding.lexicon import nearness
from grounding.lexicon.degrees import at_least, gaussian, logistic, peak
from grounding.lexicon.parameters import value
from grounding.lexicon.where import Where
from grounding.world import Array
from grounding.world.scene import Scene

_LIKELY = 0.4  # of the best weight; what is less likely is not tried as one of a pair
_MOST = 14  # references that are tried in pairs


@dataclass(frozen=True, eq=False)
class Part:
    """Some of what encloses.

    Attributes:
        weights: how well each object is one of them, shape (n,), in [0, 1].
        number: how many, or None where only several are spoken of.
        point: where they stand as one thing, shape (2,) in [m], where what encloses is a set.
    """

    weights: Array
    number: int | None
    point: Array | None = None


def truth(points: Array, first: Array, second: Array, edge: float) -> Array:
    """How well points (m, 2) lie between two others (2,), shape (m,)."""
    span = second - first
    length = float(np.linalg.norm(span))
    if length < 1e-6:
        return np.zeros(len(points))
    offset = points - first
    along = offset @ span / length**2
    across = np.abs(offset[:, 0] * span[1] - offset[:, 1] * span[0]) / length
    margin, blur = value("between.margin"), value("between.blur")
    inside = logistic((along - margin) / blur) * logistic((1 - margin - along) / blur)
    tolerance = value("between.spread") * length + value("between.width") * edge
    return np.asarray(inside * gaussian(across, tolerance))


def between_two(where: Where, scene: Scene, first: Array, second: Array) -> Array:
    """How well places lie between some pair of references with weights (n,) each, shape (m,)."""
    pairs = [(i, j) for i in _likeliest(first) for j in _likeliest(second) if i != j]
    near, fading = value("between.pairing"), value("between.pairing_fading")
    worth = np.array([
        first[i] * second[j] * np.exp(-max(float(scene.apart[i, j]) / scene.edge - near, 0.0) / fading)
        for i, j in pairs
    ])  # fmt: skip
    total = np.zeros(len(where))
    for (i, j), chance in zip(pairs, worth / peak(worth), strict=True):
        held = truth(where.xy, scene.xy[i], scene.xy[j], scene.edge)
        held[where.itself[:, i] | where.itself[:, j]] = 0.0
        total = np.maximum(total, chance * held)
    return total


def _likeliest(weights: Array) -> np.ndarray:
    likely = np.flatnonzero(weights > _LIKELY * peak(weights))
    return likely[np.argsort(-weights[likely], kind="stable")][:_MOST]


def enclosed(where: Where, scene: Scene, parts: Sequence[Part]) -> Array:
    """How well places have what the parts ask for around them, shape (m,)."""
    near = np.where(where.itself, 0.0, nearness.truth(where.gaps, scene.edge, nearness.REACH))
    held = np.ones(len(where))
    members = np.zeros_like(near)
    miscounted = value("enclosure.miscounted")
    for part in parts:
        likely = near * part.weights[None, :]
        members = np.maximum(members, likely)
        wanted = part.number or (int(value("enclosure.around")) if len(parts) == 1 else 2)
        held = held * ((1 - miscounted) * at_least(likely, wanted) + miscounted * at_least(likely, wanted - 1))
    held = held ** (1.0 / max(len(parts), 1))  # what several parts ask for holds as well as they do in the mean
    offset = scene.xy[None] - where.xy[:, None]
    toward = offset / np.maximum(np.linalg.norm(offset, axis=2, keepdims=True), 1e-9)
    pull = np.linalg.norm((members[:, :, None] * toward).sum(axis=1), axis=1)
    onesided = pull / np.maximum(members.sum(axis=1), 1e-9)
    return np.asarray(held * gaussian(onesided, value("enclosure.onesided")))


def amid(where: Where, scene: Scene, parts: Sequence[Part], *, surrounding: bool) -> Array:
    """How well places lie between or among the parts, shape (m,).

    Args:
        where: the places.
        scene: the world.
        parts: of what they are said to be between.
        surrounding: whether they are said to be surrounded, rather than between or in the middle.
    """
    if not surrounding and len(parts) == 2 and any(part.point is not None for part in parts):
        return _between_sets(where, scene, parts)
    counts = [part.number for part in parts]
    if not surrounding and counts in ([2], [1, 1]):
        return between_two(where, scene, parts[0].weights, parts[-1].weights)
    found = enclosed(where, scene, parts)
    if not surrounding and counts == [None]:
        return np.maximum(found, between_two(where, scene, parts[0].weights, parts[0].weights))
    return found


def _between_sets(where: Where, scene: Scene, parts: Sequence[Part]) -> Array:
    """How well places lie between two sets, or a set and a thing: from the nearest member of one to that of the other.

    A member of a set is not between it and anything.
    """
    if not all(part.weights.any() for part in parts):
        return np.zeros(len(where))
    nearest, inside = [], np.zeros(len(where), dtype=bool)
    for part in parts:
        members = np.flatnonzero(part.weights > 0.5 * peak(part.weights))
        away = np.linalg.norm(where.xy[:, None] - scene.xy[None, members], axis=2)
        nearest.append(scene.xy[members[away.argmin(axis=1)]])
        inside |= where.itself[:, members].any(axis=1)
    held = np.array([
        float(truth(point[None], first, second, scene.edge)[0])
        for point, first, second in zip(where.xy, *nearest, strict=True)
    ])  # fmt: skip
    return np.where(inside, 0.0, held)
