"""Arrangements that people see in a set of blocks: lines, circles, clusters, towers (Section IV-C).

Every detector is polynomial in the number of objects: lines grow from pairs of neighbours, circles from triples of
neighbours, clusters are the nested ones of single linkage, towers follow support. Each finding says how well it fits.
"""

from __future__ import annotations

import numpy as np

from grounding.geometry.arrangement import Arrangement
from grounding.geometry.circles import find_circles
from grounding.geometry.clusters import find_groups
from grounding.geometry.lines import find_bands, find_lines
from grounding.geometry.masks import mask_of
from grounding.world import Array

__all__ = ["Arrangement", "find_arrangements"]


def find_arrangements(positions: Array, edges: Array) -> tuple[Arrangement, ...]:
    """All arrangements among objects, in a fixed order.

    Args:
        positions: centres, shape (n, 3) in [m].
        edges: mean edge of each object, shape (n,) in [m].
    """
    if len(positions) < 2:
        return ()
    edge = float(np.median(edges))
    towers, base = find_towers(positions, edges)
    dx, dy = (np.subtract.outer(positions[:, axis], positions[:, axis]) for axis in range(2))
    distances = np.sqrt(dx * dx + dy * dy)
    flat = np.flatnonzero(base)
    found = [*towers]
    if len(flat) >= 2:
        found += find_lines(positions, distances, flat, edge)
        found += find_circles(positions, distances, flat, edge)
    groups = find_groups(positions, distances)
    known = {a.mask for a in found}
    found += find_bands(positions, distances, [group for group in groups if group.mask not in known], edge)
    return (*found, *groups)


def find_towers(positions: Array, edges: Array) -> tuple[list[Arrangement], np.ndarray]:
    """Stacks of two and more, and which objects stand on no other one, shape (n,)."""
    n = len(positions)
    reach = (edges[:, None] + edges[None, :]) / 2
    above: np.ndarray = np.ones((n, n), dtype=bool)  # [a, b]: b on a
    for axis in range(2):
        above &= np.abs(np.subtract.outer(positions[:, axis], positions[:, axis])) < 0.6 * reach
    above &= np.abs(positions[None, :, 2] - positions[:, 2, None] - reach) < 0.35 * reach
    base = np.asarray(~above.any(axis=0))
    towers, seen = [], np.zeros(n, dtype=bool)
    for start in np.flatnonzero(base & above.any(axis=1)):
        members, level = [int(start)], above[start]
        while level.any():
            members += [int(i) for i in np.flatnonzero(level) if int(i) not in members]
            level = above[np.flatnonzero(level)].any(axis=0)
        if len(members) > 1 and not seen[members].all():
            seen[members] = True
            towers.append(
                Arrangement("tower", mask_of(members), len(members), positions[members].mean(axis=0), 0.0, 1.0, 1.0)
            )
    return towers, base
