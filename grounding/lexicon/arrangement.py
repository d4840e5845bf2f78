"""Arrangements: rows, columns, diagonals, groups, circles, towers; what a plural may mean."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from grounding.geometry.arrangements import Arrangement
from grounding.lexicon.degrees import peak
from grounding.lexicon.parameters import value
from grounding.world import Array
from grounding.world.linkage import single_linkage
from grounding.world.scene import Scene

GAPS = (0.45, 0.6, 0.7, 0.8, 0.9, 1.1)
"""Gaps between two bands across a table [edges]: people part them by wider and by narrower ones."""
_MOST = 12


class Candidate(NamedTuple):
    """A set of objects that a noun may mean.

    Attributes:
        mask: its members, boolean (n,).
        looks: how much it looks like what is said, in [0, 1].
        form: how it came about: "tower", "line", "slanted", "pair", "ring", "band", "cluster", "all", "first".
        strength: how much it catches the eye, without bound; as much as it looks where nothing is said.
    """

    mask: np.ndarray
    looks: float
    form: str
    strength: float | None = None


def candidates(
    scene: Scene, kinds: tuple[str, ...], wanted: np.ndarray, number: int | None = None, parts: Sequence[Array] = ()
) -> list[Candidate]:
    """Arrangements of some kinds among wanted objects, those that look most like one first.

    Args:
        scene: the world.
        kinds: rows, columns, diagonals, groups, circles, towers; any of them.
        wanted: of what they are made, boolean (n,).
        number: of members, or None.
        parts: for each of several colours that were said, whether objects have it, shape (n,): all have to be there.
    """
    found: dict[bytes, Candidate] = {}
    if "tower" in kinds:
        for candidate in _towers(scene, wanted):
            _add(found, candidate, number)
        if not scene.towers:
            kinds = (*kinds, "group")
    flat = wanted & (scene.clear if "tower" not in kinds else wanted)
    if {"row", "column", "diagonal", "circle"} & set(kinds):
        for candidate in _shapes(scene, kinds, flat):
            _add(found, candidate, number)
        for kind in ("row", "column"):
            if kind in kinds and "diagonal" not in kinds:
                for candidate in bands(scene, flat, kind):
                    _add(found, candidate, number)
    if "group" in kinds:
        for candidate in clusters(scene, wanted):
            _add(found, candidate, number)
    made = [c._replace(looks=c.looks * _composed(c.mask, parts)) for c in found.values()]
    return sorted(made, key=lambda c: -c.looks * numbered(c.mask, number))[:_MOST]


def _towers(scene: Scene, wanted: np.ndarray) -> list[Candidate]:
    """Towers, and where colours are said what is below the top: "the red and blue tower" carries a yellow block."""
    found = []
    for tower in scene.towers:
        for height in range(len(tower) if wanted.all() else 2, len(tower) + 1):
            mask = _mask(scene, np.array(tower[:height]))
            looks_so = float(wanted[mask].mean()) ** 2 * height / len(tower)
            form = "tower" if height == len(tower) else "tower.lower"
            found += [Candidate(mask, looks_so, form)] if looks_so else []
    return found


def _composed(mask: np.ndarray, parts: Sequence[Array]) -> float:
    """How many of the colours that were said a set has."""
    return float(np.mean([(part[mask] > 0.5).any() for part in parts])) if len(parts) > 1 else 1.0


def overshadowed(found: Sequence[Candidate]) -> Array:
    """How much less each candidate catches the eye than the one that does most of those with which it shares members.

    Returns:
        logarithms of the shares, shape (m,), 0 for what is not overshadowed.
    """
    masks = np.array([candidate.mask for candidate in found]).astype(float)
    strengths = np.array([c.looks if c.strength is None else c.strength for c in found])
    rivals = np.where(masks @ masks.T > 0, strengths[None, :], 0.0).max(axis=1)
    return np.asarray(np.log(np.maximum(strengths, 1e-2) / np.maximum(rivals, 1e-2)))


def numbered(mask: np.ndarray, number: int | None) -> float:
    """How well a set has the number that was said: each one too many or too few speaks against it."""
    return 1.0 if number is None else math.exp(-value("arrangement.number") * abs(int(mask.sum()) - number))


def _add(found: dict[bytes, Candidate], candidate: Candidate, number: int | None) -> None:
    key = candidate.mask.tobytes()
    held = candidate.looks * numbered(candidate.mask, number)
    if held > 0.002 and (key not in found or found[key].looks < candidate.looks):
        found[key] = candidate


def _shapes(scene: Scene, kinds: tuple[str, ...], flat: np.ndarray) -> list[Candidate]:
    """Lines and circles."""
    found = []
    for a in scene.arrangements(flat):
        slanted = a.kind in ("row", "column") and a.angle > value("arrangement.slanted")
        diagonal = "diagonal" in kinds and slanted
        if not (a.kind in kinds or diagonal):
            continue
        form = "ring" if a.kind == "circle" else "slanted" if slanted else "pair" if a.count == 2 else "line"
        form += ".evident" if a.evident else ""
        name = "askew" if slanted and not diagonal else "pair" if a.count == 2 else ""
        odd = value(f"arrangement.{name}") if name else 1.0
        found.append(Candidate(scene.members(a.mask), odd * looks(a), form, odd * max(a.prominence, 0.05)))
    return found


def looks(a: Arrangement) -> float:
    """How much a shape convinces, by how much it catches the eye."""
    return 1.0 - math.exp(-max(a.prominence, 0.05) / value("arrangement.prominence"))


def bands(scene: Scene, wanted: np.ndarray, kind: str) -> list[Candidate]:
    """Rows or columns as people see them: bands across the whole table, set apart by gaps."""
    axis = 0 if kind == "row" else 1
    found = []
    for gap in GAPS:
        for mask in partition(scene, wanted, kind, gap):
            spread = float(np.ptp(scene.xy[mask, axis])) / scene.edge
            deep = math.exp(-0.5 * (spread / value("arrangement.band")) ** 2)
            held = value("arrangement.counted_band") if mask.sum() > 1 else value("arrangement.counted_one")
            found.append(Candidate(mask, held * deep, "band"))
    return found


def partition(scene: Scene, wanted: np.ndarray, kind: str, gap: float) -> list[np.ndarray]:
    """The rows from the back to the front, or the columns from left to right, that gaps of so many edges part."""
    members = np.flatnonzero(wanted)
    if not len(members):
        return []
    axis = 0 if kind == "row" else 1
    order = members[np.argsort(-scene.xy[members, axis], kind="stable")]
    steps = -np.diff(scene.xy[order, axis]) / scene.edge
    parts = np.split(order, np.flatnonzero(steps > gap) + 1)
    return [_mask(scene, part) for part in parts]


def clusters(scene: Scene, wanted: np.ndarray) -> list[Candidate]:
    """Clusters of single linkage among wanted objects: near each other, apart from the others of their kind."""
    members = np.flatnonzero(wanted)
    if len(members) < 2:
        return []
    found = []
    for cluster in single_linkage(scene.apart[np.ix_(members, members)]):
        contrast = cluster.beyond / max(cluster.within, 0.5 * scene.edge)
        loose = max(cluster.within / scene.edge - value("arrangement.compact"), 0.0)
        compact = math.exp(-0.5 * (loose / value("arrangement.compact_blur")) ** 2)
        held = compact * (1.0 - math.exp(-max(contrast - 1.0, 0.0) * value("arrangement.contrast")))
        form = "cluster.evident" if contrast > 2.0 and 3 <= len(cluster.members) <= 8 else "cluster"
        found.append(Candidate(_mask(scene, members[cluster.members]), held, form))
    return found


def together(found: Sequence[Candidate], number: int | None) -> list[Candidate]:
    """Several arrangements as one set: all that share nothing, or so many of them.

    Args:
        found: arrangements, the best first.
        number: how many, or None.
    """
    kept: list[Candidate] = []
    for candidate in found:
        if not any((candidate.mask & other.mask).any() for other in kept) and candidate.mask.sum() > 1:
            kept.append(candidate)
    evident = [c for c in kept if c.form.endswith("evident") or c.form == "tower"]
    unions = []
    for name, chosen in (("all", kept if number is None else kept[:number]), ("evident", evident)):
        if len(chosen) > 1 and (number is None or len(chosen) == number):
            mask = np.any([candidate.mask for candidate in chosen], axis=0)
            unions.append(Candidate(mask, float(np.mean([c.looks for c in chosen])), f"several.{name}"))
    return unions


def collected(scene: Scene, weights: Array, number: int | None, universal: bool) -> list[Candidate]:
    """What a plural may mean: all that match, of a number those that lie together."""
    likely = weights > value("plural.likely") * max(float(weights.max(initial=0.0)), 1e-6)
    count = int(likely.sum())
    if not count:
        return []
    everything = Candidate(likely, 1.0, "all")
    if number is None or (universal and count == number):
        lying = () if universal else clusters(scene, likely)
        return [everything, *(c._replace(looks=value("plural.cluster") * c.looks) for c in lying)]
    if count == number:
        return [everything]
    if count > number:
        found = _of_number(scene, weights, likely, number)
    else:
        fewer = everything._replace(looks=value("plural.fewer") * math.exp(count - number))
        found = [fewer, *_stretched(scene, weights, number)]
    return sorted(found, key=lambda c: -c.looks)[:_MOST]


def _of_number(scene: Scene, weights: Array, likely: np.ndarray, number: int) -> list[Candidate]:
    """So many of more that match: those that lie together, or the best ones."""
    found = [c for c in clusters(scene, likely) if int(c.mask.sum()) == number]
    for a in scene.arrangements(likely):
        if a.count == number and a.kind in ("row", "column", "circle"):
            found.append(Candidate(scene.members(a.mask), value("plural.line") * looks(a), "line"))
    order = np.argsort(-weights, kind="stable")[: number + 1]
    chosen, following = float(weights[order[:number]].mean()), float(weights[order[number]])
    first = Candidate(_mask(scene, order[:number]), max(value("plural.first") * chosen, chosen - following), "first")
    return [*found, first]


def _stretched(scene: Scene, weights: Array, number: int) -> list[Candidate]:
    """Who counts more than stand out means the next ones too, however little they fit."""
    order = np.argsort(-weights, kind="stable")[:number]
    share = float(weights[order].min()) / peak(weights)
    if len(order) < number or share <= 0:
        return []
    return [Candidate(_mask(scene, order), max(math.sqrt(share), value("plural.stretched")), "stretched")]


def _mask(scene: Scene, members: np.ndarray) -> np.ndarray:
    mask = np.zeros(scene.n, dtype=bool)
    mask[members] = True
    return mask
