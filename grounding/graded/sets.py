"""Which sets of objects several or an arrangement may mean: stacks, lines, bands, clusters, all of a kind."""

from __future__ import annotations

import math

import numpy as np

from grounding.lexicon import arrangement
from grounding.world.scene import Scene

Sets = list[tuple[np.ndarray, float]]

_MOST = 12
_STRETCHED = 0.12  # who counts more than stand out means the next ones too, however little they fit


def arranged(scene: Scene, kinds: tuple[str, ...], wanted: np.ndarray, number: int | None) -> Sets:
    """Arrangements of some kinds among wanted objects, the weight telling how much each looks like one.

    Args:
        scene: the world.
        kinds: rows, columns, diagonals, groups, circles, towers; any of them.
        wanted: of what they are made, boolean (n,).
        number: of members, or None.
    """
    found: dict[bytes, tuple[np.ndarray, float]] = {}

    def add(mask: np.ndarray, weight: float) -> None:
        if number is not None:
            weight *= math.exp(-1.8 * abs(int(mask.sum()) - number))
        key = mask.tobytes()
        if weight > 0.002 and (key not in found or found[key][1] < weight):
            found[key] = (mask, weight)

    if "tower" in kinds:
        for tower in scene.towers:
            mask = np.zeros(scene.n, dtype=bool)
            mask[list(tower)] = True
            if (mask & wanted).any():
                add(mask, 1.0)
        if not scene.towers:
            kinds = (*kinds, "group")
    flat = wanted & (scene.clear if "tower" not in kinds else wanted)
    if {"row", "column", "diagonal", "circle"} & set(kinds):
        for a in scene.arrangements(flat):
            lying = a.kind in ("row", "column")
            slanted = lying and a.angle > 0.3
            if a.kind in kinds or ("diagonal" in kinds and slanted):
                weight = 1.0 - math.exp(-max(a.prominence, 0.05))
                if a.kind not in kinds and not slanted:
                    continue
                if a.kind in kinds and slanted and "diagonal" not in kinds:
                    weight *= 0.5
                add(scene.members(a.mask), weight * (0.35 if a.count == 2 else 1.0))
        for kind in ("row", "column"):
            if kind in kinds and "diagonal" not in kinds:
                for mask, weight in bands(scene, flat, kind):
                    add(mask, weight)
    if "group" in kinds:
        for mask, weight in clusters(scene, wanted):
            add(mask, weight)
    ordered = sorted(found.values(), key=lambda item: -item[1])
    return ordered[:_MOST]


def existence(found: Sets, number: int | None, kinds: tuple[str, ...]) -> float:
    """How well what is there agrees with the number that was said: people miscount heaps, but not rows of five."""
    if number is None or not found:
        return 1.0
    missing = min(abs(int(mask.sum()) - number) for mask, _ in found)
    return math.exp(-(0.7 if "group" in kinds else 2.6) * missing)


def bands(scene: Scene, wanted: np.ndarray, kind: str) -> Sets:
    """Rows or columns as people see them: bands across the whole table, set apart by gaps."""
    found: Sets = []
    axis = 0 if kind == "row" else 1
    for gap in arrangement.GAPS:
        for mask in arrangement.partition(scene, wanted, kind, gap):
            spread = float(np.ptp(scene.xy[mask, axis])) / scene.edge
            found.append((mask, (0.35 if mask.sum() > 1 else 0.15) * math.exp(-0.5 * (spread / 1.5) ** 2)))
    return found


def clusters(scene: Scene, wanted: np.ndarray) -> Sets:
    """Clusters of single linkage among wanted objects: near each other, apart from the others of their kind."""
    members = np.flatnonzero(wanted)
    if len(members) < 2:
        return []
    apart = scene.apart[np.ix_(members, members)]
    parent = list(range(len(members)))
    group = {i: [i] for i in range(len(members))}
    born = dict.fromkeys(group, 0.0)

    def find(i: int) -> int:
        while parent[i] != i:
            i = parent[i]
        return i

    pairs = sorted((float(apart[i, j]), i, j) for i in range(len(members)) for j in range(i))
    found: Sets = []

    def record(root: int, grown: float) -> None:
        if len(group[root]) > 1:
            inner = born[root]
            contrast = grown / max(inner, 0.5 * scene.edge)
            compact = math.exp(-0.5 * (max(inner / scene.edge - 1.2, 0.0) / 1.5) ** 2)
            weight = compact * (1.0 - math.exp(-max(contrast - 1.0, 0.0) * 1.5))
            mask = np.zeros(scene.n, dtype=bool)
            mask[members[group[root]]] = True
            found.append((mask, weight))

    for length, i, j in pairs:
        a, b = find(i), find(j)
        if a != b:
            record(a, length)
            record(b, length)
            parent[b] = a
            group[a] = group[a] + group.pop(b)
            born[a] = length
            if len(group) == 1:
                record(a, 2.0 * length)
                break
    return found


def collected(scene: Scene, weights: np.ndarray, number: int | None, universal: bool) -> Sets:
    """What a plural may mean: all that match, of a number those that lie together."""
    likely = weights > 0.4 * max(float(weights.max(initial=0.0)), 1e-6)
    count = int(likely.sum())
    found: Sets = []
    if not count:
        return found
    if number is None or (universal and count == number):
        found.append((likely, 1.0))
        if not universal:
            found += [(mask, 0.5 * weight) for mask, weight in clusters(scene, likely)]
        return found
    order = np.argsort(-weights, kind="stable")[:number]
    first = np.zeros(scene.n, dtype=bool)
    first[order] = True
    if count == number:
        found.append((likely, 1.0))
    elif count > number:
        found += [(m, s) for m, s in clusters(scene, likely) if int(m.sum()) == number]
        for a in scene.arrangements(likely):
            if a.count == number and a.kind in ("row", "column", "circle"):
                found.append((scene.members(a.mask), 0.4 * (1.0 - math.exp(-max(a.prominence, 0.05)))))
        chosen, following = float(weights[order].mean()), float(np.sort(weights)[::-1][number])
        found.append((first, max(0.15 * chosen, chosen - following)))
    else:
        share = float(weights[order].min()) / float(weights.max())
        if len(order) == number and share > 0:
            found.append((first, max(math.sqrt(share), _STRETCHED)))
        found.append((likely, 0.1 * math.exp(count - number)))
    return sorted(found, key=lambda item: -item[1])[:_MOST]
