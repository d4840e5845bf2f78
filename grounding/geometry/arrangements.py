"""Arrangements that people see in a set of blocks: lines, circles, clusters, towers (Section IV-C).

Every detector is polynomial in the number of objects: lines grow from pairs of neighbours, circles from triples of
neighbours, clusters are the nested ones of single linkage, towers follow support. Each finding says how well it fits.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from grounding.geometry.masks import indices_of, mask_of
from grounding.world import Array

LINE_TOLERANCES = ((0.45, 1.7), (1.2, 2.6))  # distance from the line [edges], largest ratio of neighbouring gaps
ELONGATED = 0.3  # a cluster is a band, seen as a line, when its second axis is at most so long, of the first
CIRCLE_TOLERANCE = 0.35  # distance from the circle [edges]
SAME = 1e-9  # distances that differ by less are the same [m]
NEIGHBOURS = 8  # pairs and triples are formed among so many nearest neighbours


@dataclass(frozen=True)
class Arrangement:
    """Objects that form a shape.

    Attributes:
        kind: row (along y), column (along x), group, circle or tower.
        mask: the members, see `grounding.geometry.masks`.
        count: how many they are.
        centroid: mean position, shape (3,) in [m].
        deviation: root mean square distance from the shape, over the mean gap of neighbours (0 for groups and towers).
        regularity: 1 for even gaps, towards 0 for uneven ones.
        separation: distance to the nearest other object over the largest gap within; large is apart.
        angle: of a line to the axis that its kind is named after, in [rad].
    """

    kind: str
    mask: int
    count: int
    centroid: Array
    deviation: float
    regularity: float
    separation: float
    angle: float = 0.0

    @cached_property
    def prominence(self) -> float:
        """How much it catches the eye, for choosing among arrangements that share members; above 0 at all."""
        if self.kind == "tower":
            return 2.0 + self.count
        if self.kind == "group":
            return float(min(self.separation, 4.0) - 1.1) * (1.0 if 3 <= self.count <= 8 else 0.4)
        fit = np.exp(-((self.deviation / 0.35) ** 2) - (self.angle / 0.4) ** 2 - ((1 - self.regularity) / 0.6) ** 2)
        return float(fit) * float(self.count - (1.0 if self.kind != "circle" else 2.0)) * min(self.separation, 1.5)

    @property
    def noticed(self) -> bool:
        """Whether people who look for one might take it for one, evident or not."""
        return self.prominence > (0.0 if self.kind == "group" else 0.3)

    @cached_property
    def evident(self) -> bool:
        """Whether people would name it without being asked: enough members, well formed, apart from others."""
        if self.kind == "tower":
            return True
        if self.kind == "group":
            return self.separation > 2.0 and 3 <= self.count <= 8
        if self.kind == "circle":
            return self.count >= 5 and self.deviation < 0.15 and self.regularity > 0.7 and self.separation > 0.7
        if self.count < 3 or self.angle > 0.4:
            return False
        if self.count == 3:
            return self.deviation < 0.15 and self.regularity > 0.75 and self.separation > 0.9
        return self.deviation < 0.3 and self.regularity > 0.55 and self.separation > 0.7


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
    distances = np.linalg.norm(positions[:, None, :2] - positions[None, :, :2], axis=2)
    flat = np.flatnonzero(base)
    found = [*towers]
    if len(flat) >= 2:
        found += find_lines(positions, distances, flat, edge)
        found += find_circles(positions, distances, flat, edge)
    groups = find_groups(positions, distances)
    known = {a.mask for a in found}
    found += [
        band for group in groups if group.mask not in known and (band := _band(positions, distances, group, edge))
    ]
    return (*found, *groups)


def find_towers(positions: Array, edges: Array) -> tuple[list[Arrangement], np.ndarray]:
    """Stacks of two and more, and which objects stand on no other one, shape (n,)."""
    n = len(positions)
    offset = positions[None, :, :] - positions[:, None, :]  # [a, b]: from a to b
    reach = (edges[:, None] + edges[None, :]) / 2
    beside = np.abs(offset[:, :, :2]).max(axis=2) < 0.6 * reach
    above = beside & (np.abs(offset[:, :, 2] - reach) < 0.35 * reach)
    base = ~above.any(axis=0)
    towers, seen = [], np.zeros(n, dtype=bool)
    for start in np.flatnonzero(base):
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


def find_lines(positions: Array, distances: Array, flat: np.ndarray, edge: float) -> list[Arrangement]:
    """Rows and columns among the objects `flat`: runs that go on evenly from a pair of neighbours."""
    points = positions[flat, :2]
    apart = distances[np.ix_(flat, flat)]
    count = len(flat)
    near = np.argsort(apart, axis=1, kind="stable")[:, 1 : NEIGHBOURS + 1]
    pairs = sorted({(min(i, int(j)), max(i, int(j))) for i in range(count) for j in near[i]})
    runs: dict[int, tuple[int, ...]] = {}
    for tolerance, ratio in LINE_TOLERANCES:
        for i, j in pairs:
            gap = apart[i, j]
            if gap < 0.5 * edge:
                continue
            run = _grow(points, i, j, gap, min(tolerance * edge, 0.35 * gap), ratio)
            if run is not None:
                runs.setdefault(mask_of(flat[list(run)]), run)
    return [_line(positions, distances, flat[list(run)], mask, edge) for mask, run in sorted(runs.items())]


def _grow(points: Array, i: int, j: int, gap: float, tolerance: float, ratio: float) -> tuple[int, ...] | None:
    """The run of points through i and j, in order; None where another point lies between them."""
    direction = (points[j] - points[i]) / gap
    offset = points - points[i]
    along = offset @ direction
    across = np.abs(offset[:, 0] * direction[1] - offset[:, 1] * direction[0])
    inliers = np.flatnonzero(across <= tolerance)
    order = inliers[np.argsort(along[inliers], kind="stable")]
    places = {int(index): place for place, index in enumerate(order)}
    if places[j] - places[i] != 1:
        return None
    steps = np.diff(along[order])
    first, last = places[i], places[j]
    while first > 0 and gap / ratio <= steps[first - 1] <= gap * ratio:
        first -= 1
    while last < len(steps) and gap / ratio <= steps[last] <= gap * ratio:
        last += 1
    return tuple(int(index) for index in order[first : last + 1])


def _line(positions: Array, distances: Array, members: np.ndarray, mask: int, edge: float) -> Arrangement:
    points = positions[members, :2]
    centred = points - points.mean(axis=0)
    _, singular, axes = np.linalg.svd(centred, full_matrices=False)
    axis = axes[0]
    gaps = np.diff(np.sort(centred @ axis))
    spread = float(singular[1] / np.sqrt(len(members))) if len(singular) > 1 else 0.0
    deviation = spread / max(float(gaps.mean()), edge / 2)
    lateral = float(np.arctan2(abs(axis[0]), abs(axis[1])))  # 0 along y, pi/2 along x
    kind, angle = ("row", lateral) if lateral <= np.pi / 4 else ("column", np.pi / 2 - lateral)
    return Arrangement(
        kind,
        mask,
        len(members),
        positions[members].mean(axis=0),
        deviation,
        _regularity(gaps),
        _separation(distances, members, float(gaps.max())),
        float(angle),
    )


def _band(positions: Array, distances: Array, group: Arrangement, edge: float) -> Arrangement | None:
    """A cluster seen as a row or a column, if it is long and narrow."""
    if group.count < 3:
        return None
    members = np.array(list(indices_of(group.mask)))
    singular = np.linalg.svd(positions[members, :2] - positions[members, :2].mean(axis=0), compute_uv=False)
    if singular[1] > ELONGATED * singular[0]:
        return None
    return _line(positions, distances, members, group.mask, edge)


def find_circles(positions: Array, distances: Array, flat: np.ndarray, edge: float) -> list[Arrangement]:
    """Circles of four and more among the objects `flat`, all around and with nothing else on them."""
    count = len(flat)
    if count < 4:
        return []
    points = positions[flat, :2]
    apart = distances[np.ix_(flat, flat)]
    near = np.argsort(apart, axis=1, kind="stable")[:, 1 : NEIGHBOURS + 1]
    triples = np.array(
        sorted(
            {tuple(sorted((i, *pair))) for i in range(count) for pair in itertools.combinations(near[i].tolist(), 2)}
        )
    )
    centres, radii = _circumcircles(points[triples[:, 0]], points[triples[:, 1]], points[triples[:, 2]])
    keep = (radii > 0.9 * edge) & (radii < 0.35)
    centres, radii = centres[keep], radii[keep]
    off = np.abs(np.linalg.norm(points[None] - centres[:, None], axis=2) - radii[:, None])
    inliers = off <= CIRCLE_TOLERANCE * edge
    enough = inliers.sum(axis=1) >= 4
    found: dict[int, Arrangement] = {}
    for centre, radius, inside in zip(centres[enough], radii[enough], inliers[enough], strict=True):
        local = np.flatnonzero(inside)
        members = flat[local]
        mask = mask_of(members)
        angles = np.sort(np.arctan2(*(points[local] - centre).T[::-1]))
        turns = np.diff(np.append(angles, angles[0] + 2 * np.pi))
        if turns.max() > 1.9 * 2 * np.pi / len(members):
            continue
        chords = np.sort(distances[np.ix_(members, members)], axis=1)[:, 1]
        off_circle = np.linalg.norm(points[local] - centre, axis=1) - radius
        deviation = float(np.sqrt(np.mean(off_circle**2)) / max(chords.mean(), edge / 2))
        if mask in found and found[mask].deviation <= deviation:
            continue
        found[mask] = Arrangement(
            "circle",
            mask,
            len(members),
            positions[members].mean(axis=0),
            deviation,
            _regularity(turns),
            _separation(distances, members, float(chords.max())),
        )
    return [found[mask] for mask in sorted(found)]


def _circumcircles(a: Array, b: Array, c: Array) -> tuple[Array, Array]:
    ab, ac = b - a, c - a
    cross = 2 * (ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0])
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ab2, ac2 = (ab**2).sum(axis=1), (ac**2).sum(axis=1)
        x = (ac[:, 1] * ab2 - ab[:, 1] * ac2) / cross
        y = (ab[:, 0] * ac2 - ac[:, 0] * ab2) / cross
    offset = np.clip(np.nan_to_num(np.stack([x, y], axis=1), nan=1e6), -1e6, 1e6)
    return a + offset, np.linalg.norm(offset, axis=1)


def find_groups(positions: Array, distances: Array) -> list[Arrangement]:
    """The nested clusters of single linkage, from pairs up to everything."""
    n = len(positions)
    clusters = {i: [i] for i in range(n)}
    label = list(range(n))
    spread = [0.0] * (2 * n)
    found: list[tuple[list[int], float, int]] = []
    parent_gap: dict[int, float] = {}
    for number, (gap, i, j) in enumerate(_spanning_tree(distances), start=n):
        a, b = label[i], label[j]
        members = sorted(clusters.pop(a) + clusters.pop(b))
        clusters[number] = members
        spread[number] = gap
        parent_gap[a] = parent_gap[b] = gap
        for member in members:
            label[member] = number
        found.append((members, gap, number))
    result = []
    for members, gap, number in found:
        if parent_gap.get(number, np.inf) <= gap + SAME:  # one of several merged at once: which came first says nothing
            continue
        outside = parent_gap.get(number, 3 * gap)
        result.append(
            Arrangement(
                "group",
                mask_of(members),
                len(members),
                positions[members].mean(axis=0),
                0.0,
                1.0,
                outside / max(gap, 1e-6),
            )
        )
    return result


def _spanning_tree(distances: Array) -> list[tuple[float, int, int]]:
    """Edges of the minimum spanning tree (Prim), shortest first."""
    n = len(distances)
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


def _regularity(gaps: Array) -> float:
    mean = float(np.mean(gaps))
    return 1.0 if len(gaps) < 2 or mean <= 0 else float(max(0.0, 1.0 - float(np.std(gaps)) / mean))


def _separation(distances: Array, members: np.ndarray, largest_gap: float) -> float:
    outside = np.ones(len(distances), dtype=bool)
    outside[members] = False
    if not outside.any():
        return 3.0
    return float(distances[np.ix_(members, np.flatnonzero(outside))].min() / max(largest_gap, 1e-6))
