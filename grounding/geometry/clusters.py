"""Clusters of objects: the nested ones of single linkage."""

from __future__ import annotations

import numpy as np

from grounding.geometry.arrangement import Arrangement
from grounding.world import Array
from grounding.world.linkage import spanning_tree

SAME = 1e-9  # distances that differ by less are the same [m]


def find_groups(positions: Array, distances: Array) -> list[Arrangement]:
    """The nested clusters of single linkage, from pairs up to everything."""
    n = len(positions)
    clusters = {i: [i] for i in range(n)}
    masks = {i: 1 << i for i in range(n)}
    label = list(range(n))
    found: list[tuple[list[int], float, int]] = []
    parent_gap: dict[int, float] = {}
    for number, (gap, i, j) in enumerate(spanning_tree(distances), start=n):
        a, b = label[i], label[j]
        members = sorted(clusters.pop(a) + clusters.pop(b))
        clusters[number] = members
        masks[number] = masks[a] | masks[b]
        parent_gap[a] = parent_gap[b] = gap
        for member in members:
            label[member] = number
        found.append((members, gap, number))
    # One of several that are merged at once is left out: which came first says nothing.
    kept = [one for one in found if parent_gap.get(one[2], np.inf) > one[1] + SAME]
    sizes = np.array([len(members) for members, _, _ in kept])
    sums = np.add.reduceat(positions[np.concatenate([one[0] for one in kept])], np.cumsum(sizes) - sizes, axis=0)
    return [
        Arrangement(
            "group", masks[number], len(members), centroid, 0.0, 1.0, parent_gap.get(number, 3 * gap) / max(gap, 1e-6)
        )
        for (members, gap, number), centroid in zip(kept, sums / sizes[:, None], strict=True)
    ]
