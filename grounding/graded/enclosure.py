"""How well objects lie between or amid others, each part of which may be counted: "three green and a blue one".

A part holds of an object where enough of its members are near it; the object is enclosed where those near it do not all
lie on one side.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grounding.graded import scores
from grounding.lexicon import between, degrees
from grounding.world import Array
from grounding.world.scene import Scene

REACH = 1.3  # gap at which a neighbour counts one half [edges]
MISCOUNTED = 0.25  # so often one fewer is near than people say
AROUND = 3  # "surrounded by" without a number
LIKELY = 0.4  # of the best weight; what is less likely is not tried as one of a pair
MOST = 14  # references that are tried in pairs
SPAN = 8.0  # the two that something is between are near each other: their distance fades over so many edges


@dataclass(frozen=True, eq=False)
class Part:
    """Some of what encloses.

    Attributes:
        weights: how well each object is one of them, shape (n,), in [0, 1].
        number: how many, or None where only several are spoken of.
    """

    weights: Array
    number: int | None


def enclosed(scene: Scene, parts: Sequence[Part]) -> Array:
    """How well every object has what the parts ask for around it, shape (n,)."""
    near = scores.beside(scene.gaps, scene.edge, REACH)
    np.fill_diagonal(near, 0.0)
    held = np.ones(scene.n)
    members = np.zeros((scene.n, scene.n))
    for part in parts:
        likely = near * part.weights[None, :]
        members = np.maximum(members, likely)
        wanted = part.number or (AROUND if len(parts) == 1 else 2)
        held = held * ((1 - MISCOUNTED) * _at_least(likely, wanted) + MISCOUNTED * _at_least(likely, wanted - 1))
    offset = scene.xy[None] - scene.xy[:, None]
    toward = offset / np.maximum(np.linalg.norm(offset, axis=2, keepdims=True), 1e-9)
    pull = np.linalg.norm((members[:, :, None] * toward).sum(axis=1), axis=1)
    onesided = pull / np.maximum(members.sum(axis=1), 1e-9)
    return np.asarray(held * np.exp(-0.5 * (onesided / 0.5) ** 2))


def _at_least(chances: Array, count: int) -> Array:
    """How likely at least so many of independent coins fall right, by rows of an array (n, m)."""
    if count <= 0:
        return np.ones(len(chances))
    fewer = np.zeros((len(chances), count))
    fewer[:, 0] = 1.0
    for p in chances.T[:, :, None]:
        fewer[:, 1:] = fewer[:, 1:] * (1 - p) + fewer[:, :-1] * p
        fewer[:, :1] *= 1 - p
    return np.asarray(1.0 - fewer.sum(axis=1))


def between_two(scene: Scene, first: Array, second: Array) -> Array:
    """How well every object lies between some pair of references with weights (n,) each, shape (n,)."""
    pairs = [(i, j) for i in _likeliest(first) for j in _likeliest(second) if i != j]
    worth = np.array([
        first[i] * second[j] * np.exp(-max(float(scene.apart[i, j]) / scene.edge - 2.5, 0.0) / SPAN) for i, j in pairs
    ])  # fmt: skip
    total = np.zeros(scene.n)
    for (i, j), chance in zip(pairs, worth / degrees.peak(worth), strict=True):
        held = between.truth(scene.xy, scene.xy[i], scene.xy[j], scene.edge)
        held[[i, j]] = 0.0
        total = np.maximum(total, chance * held)
    return total


def _likeliest(weights: Array) -> np.ndarray:
    likely = np.flatnonzero(weights > LIKELY * max(float(weights.max(initial=0.0)), 1e-9))
    return likely[np.argsort(-weights[likely], kind="stable")][:MOST]


def amid(scene: Scene, parts: Sequence[Part], *, surrounding: bool) -> Array:
    """How well every object lies between or among the parts, shape (n,).

    Args:
        scene: the world.
        parts: of what it is said to be between.
        surrounding: whether it is said to be surrounded, rather than between or in the middle.
    """
    counts = [part.number for part in parts]
    if not surrounding and counts in ([2], [1, 1]):
        return between_two(scene, parts[0].weights, parts[-1].weights)
    found = enclosed(scene, parts)
    if not surrounding and counts == [None]:
        return np.maximum(found, between_two(scene, parts[0].weights, parts[0].weights))
    return found
