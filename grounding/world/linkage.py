"""Single linkage: the nested clusters of points that lie near each other."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from grounding.world.objects import Array


class Cluster(NamedTuple):
    """Points that are linked.

    Attributes:
        members: their indices, in order.
        within: the longest link among them [m].
        beyond: the link by which they join others; twice the last link where they are all.
    """

    members: np.ndarray
    within: float
    beyond: float


def single_linkage(distances: Array) -> tuple[Cluster, ...]:
    """All clusters of two and more, those first that are complete first.

    Args:
        distances: of all pairs, shape (n, n) in [m].
    """
    n = len(distances)
    label = np.arange(n)
    born: dict[int, tuple[np.ndarray, float]] = {}
    found: list[Cluster] = []
    last = 0.0
    for number, (length, i, j) in enumerate(spanning_tree(distances), start=n):
        joined = (int(label[i]), int(label[j]))
        found += [Cluster(*born.pop(part), length) for part in joined if part in born]
        members = np.flatnonzero((label == joined[0]) | (label == joined[1]))
        label[members] = number
        born[number] = (members, length)
        last = length
    return (*found, *(Cluster(members, within, 2.0 * last) for members, within in born.values()))


def spanning_tree(distances: Array) -> list[tuple[float, int, int]]:
    """Edges of the minimum spanning tree (Prim's algorithm), shortest first."""
    n = len(distances)
    if n < 2:
        return []
    best = distances[0].copy()
    source = np.zeros(n, dtype=int)
    outside = np.ones(n, dtype=bool)
    outside[0] = False
    edges: list[tuple[float, int, int]] = []
    for _ in range(n - 1):
        candidate = int(np.argmin(np.where(outside, best, np.inf)))
        edges.append((float(best[candidate]), int(source[candidate]), candidate))
        outside[candidate] = False
        closer = distances[candidate] < best
        best = np.where(closer, distances[candidate], best)
        source[closer] = candidate
    return sorted(edges)
