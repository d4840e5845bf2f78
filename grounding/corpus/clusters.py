"""Clusters of one colour that stand among other blocks: "the cluster of orange blocks"."""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np

from grounding.geometry.clusters import find_groups
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of, mask_of

APART = 2.0  # a cluster is so many times farther from what is alike than its members are from each other

_KNOWN: WeakKeyDictionary[Layout, dict[int, tuple[int, ...]]] = WeakKeyDictionary()


def clusters(layout: Layout, pool: int, number: int | None, known: list[tuple[str, int]]) -> list[tuple[str, int]]:
    """Clusters among the members of a set, if nothing else is regarded.

    Args:
        layout: the world, measured.
        pool: the set.
        number: of members, if it was said.
        known: clusters found otherwise; what shares members with them is left out.
    """
    cache = _KNOWN.setdefault(layout, {})
    if pool not in cache:
        cache[pool] = _find(layout, pool)
    taken = 0
    for _, mask in known:
        taken |= mask
    return [("group", m) for m in cache[pool] if not m & taken and number in (None, m.bit_count())]


def _find(layout: Layout, pool: int) -> tuple[int, ...]:
    members = np.array(list(indices_of(pool)), dtype=int)
    if not 3 <= len(members) <= 16:
        return ()
    positions = layout.positions[members]
    distances = np.linalg.norm(positions[:, None, :2] - positions[None, :, :2], axis=2)
    found = [g for g in find_groups(positions, distances) if g.separation >= APART and 2 <= g.count < len(members)]
    kept: list[int] = []
    for group in sorted(found, key=lambda g: -g.separation):
        mask = mask_of(int(members[i]) for i in indices_of(group.mask))
        if not any(mask & other for other in kept):
            kept.append(mask)
    return tuple(kept)
