"""Which of several things is meant: by rank, by region, as one that stands alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from grounding.geometry.layout import UPRIGHT, Layout
from grounding.geometry.masks import indices_of, mask_of, single
from grounding.lexicon import person
from grounding.literal.values import Order, Unread
from grounding.symbols import LAST, Region
from grounding.world import Array
from grounding.world.scene import Scene

CONTACT = 0.16  # things touch whose sides are at most so many edges apart
NO_CONTACT = 0.5  # and do not where they are so many apart; in between it is not clear
ALONE = 1.35  # something is alone where all others are so many edges away
COMPANY = 1.0  # and is not where one is at most so many away
CLOSER = 0.75  # of several in a direction the first is meant where it is so much closer than the next
ASIDE = 0.8  # "directly" allows so many edges to the side
_LYING = UPRIGHT | {"near": "front", "far": "back"}
_FLAT = ("left", "right", "front", "back")


def nth(scene: Scene, pool: int, order: Order, index: int | None = None) -> int:
    """The one of a set that is so far along an order; 0 where there are fewer.

    Raises:
        Unread: the next one is too close to call.
    """
    members = np.array(list(indices_of(pool)), dtype=int)
    rank = order.index or index or 1
    place = len(members) - 1 if rank == LAST else len(members) + rank if rank < 0 else rank - 1
    if not 0 <= place < len(members):
        return 0
    key = order.key(pool)
    sequence = np.lexsort((members, -np.round(scene.z[members], 4), -np.round(key, 4)))
    for a, b in ((place - 1, place), (place, place + 1)):
        if a >= 0 and b < len(members) and key[sequence[a]] - key[sequence[b]] < order.margin:
            raise Unread("too close to call")
    return 1 << int(members[sequence[place]])


def first(scene: Scene, pool: int, order: Order, count: int) -> int:
    """The first so many of a set; 0 where there are fewer.

    Raises:
        Unread: the next one is too close to call.
    """
    members = np.array(list(indices_of(pool)), dtype=int)
    if len(members) < count:
        return 0
    key = order.key(pool)
    sequence = np.argsort(-key, kind="stable")
    if len(members) > count and key[sequence[count - 1]] - key[sequence[count]] < order.margin:
        raise Unread("too close to call")
    return mask_of(members[sequence[:count]])


def along(layout: Layout, name: str, upright: bool = False) -> Callable[[int], Array]:
    """How far things lie in a direction; top and bottom are up and down where things lie at different heights."""

    def key(pool: int) -> Array:
        flat = name if upright or layout.stacked(pool) else UPRIGHT.get(name, name)
        return layout.extent(pool, flat)

    return key


def toward(scene: Scene, names: Sequence[str]) -> Callable[[int], Array]:
    """How near things lie to a point of the table that directions name."""
    centre, half = _table(scene)
    steps = {"left": (0, 1), "right": (0, -1), "back": (1, 0), "front": (-1, 0), "top": (1, 0), "bottom": (-1, 0),
             "far": (1, 0), "near": (-1, 0)}  # fmt: skip
    point = centre + half * np.sum([(0, 0), *(steps.get(name, (0, 0)) for name in names)], axis=0)

    def key(pool: int) -> Array:
        return np.asarray(-np.linalg.norm(scene.xy[list(indices_of(pool))] - point, axis=1))

    return key


def from_reference(layout: Layout, names: tuple[str, ...], away: bool) -> Callable[[int], Array]:
    """How near things lie to a reference, or how far."""

    def key(pool: int) -> Array:
        distance = layout.distance_to(pool, names)
        return distance if away else -distance

    return key


def from_person(scene: Scene, owner: str, away: bool) -> Callable[[int], Array]:
    """How near things lie to somebody, or how far."""
    distance = person.distance_from(scene, owner)
    return lambda pool: (1.0 if away else -1.0) * distance[list(indices_of(pool))]


def to_center(layout: Layout) -> Callable[[int], Array]:
    """How near things lie to the middle of all."""
    middle = layout.positions[:, :2].mean(axis=0) if layout.size else np.zeros(2)

    def key(pool: int) -> Array:
        return np.asarray(-np.linalg.norm(layout.positions[list(indices_of(pool)), :2] - middle, axis=1))

    return key


def _table(scene: Scene) -> tuple[Array, Array]:
    for item in scene.layout.world.objects:
        if item.type == "table":
            return item.position[:2], item.half_extents[:2]
    return scene.box


def half(scene: Scene, pool: int, name: str, *, clear: bool = True) -> int:
    """What lies on one half of the table.

    Args:
        scene: the world.
        pool: of these.
        name: of the direction.
        clear: whether nothing may lie across the middle.

    Raises:
        Unread: no half is named so, or something lies across the middle.
    """
    name = _LYING.get(name, name)
    if name not in _FLAT:
        raise Unread(f"no half {name}")
    centre, _ = _table(scene)
    axis, sign = {"left": (1, 1), "right": (1, -1), "back": (0, 1), "front": (0, -1)}[name]
    over = sign * (scene.xy[:, axis] - centre[axis])
    if clear and any(abs(over[i]) < 0.02 for i in indices_of(pool)):
        raise Unread("across the middle")
    return pool & mask_of(np.flatnonzero(over > 0))


def side_of_all(scene: Scene, mask: int, name: str) -> float:
    """How far the mean of a set lies on a side of the table's middle in [m]."""
    name = UPRIGHT.get(name, name)
    if name not in _FLAT or not mask:
        return 1.0
    centre, _ = _table(scene)
    axis, sign = {"left": (1, 1), "right": (1, -1), "back": (0, 1), "front": (0, -1)}[name]
    return float((sign * (scene.xy[list(indices_of(mask)), axis] - centre[axis])).mean())


def alone(scene: Scene, pool: int) -> int:
    """The members of a set that stand alone, or its only one.

    Raises:
        Unread: it is not clear which do.
    """
    if single(pool):
        return pool
    gaps = _gaps(scene)
    nearest = {i: float(gaps[i].min(initial=np.inf)) for i in indices_of(pool)}
    if any(COMPANY < gap < ALONE for gap in nearest.values()):
        raise Unread("which ones are alone?")
    return mask_of(i for i, gap in nearest.items() if gap >= ALONE)


def touching(scene: Scene, index: int) -> int:
    """What touches a thing.

    Raises:
        Unread: it is not clear what does.
    """
    gaps = _gaps(scene)[index]
    if any(CONTACT < gap < NO_CONTACT for gap in gaps):
        raise Unread("touching or not?")
    return mask_of(np.flatnonzero(gaps <= CONTACT))


def _gaps(scene: Scene) -> Array:
    """Free space between things in edges, also from one level to the next; infinite to themselves."""
    edges = (scene.layout.edges[:, None] + scene.layout.edges[None]) / 2
    rise = np.abs(scene.z[:, None] - scene.z[None]) / edges - 1.0
    gaps = scene.gaps / edges
    gaps = np.where(rise > -0.5, np.maximum(gaps, rise), gaps)
    return np.asarray(gaps + np.where(np.eye(scene.n, dtype=bool), np.inf, 0.0))


def first_met(scene: Scene, pool: int, region: Region) -> int:
    """Of several in a region the one that comes first, where it clearly does; else 0."""
    if region.relation not in (*_FLAT, "near") or not region.objects or region.objects == ("table",):
        return 0
    members = list(indices_of(pool))
    away = scene.layout.distance_to(pool, region.objects)
    order = np.argsort(away, kind="stable")
    return 1 << members[int(order[0])] if away[order[0]] < CLOSER * away[order[1]] else 0


def straight(scene: Scene, index: int, region: Region) -> bool:
    """Whether a thing lies straight in the direction of a region from its reference."""
    references = [scene.layout.index[name] for name in region.objects if name in scene.layout.index]
    if region.relation not in _FLAT or not references:
        return True
    axis = 1 if region.relation in ("front", "back") else 0
    aside = np.abs(scene.xy[references, axis] - scene.xy[index, axis]).min()
    return bool(aside <= ASIDE * scene.layout.edges[index])
