"""Places: sides, corners, edges and middles, of the table or of what lies on it."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from grounding.graded import scores
from grounding.graded.values import SETS, Effect, Place, Restriction, Value
from grounding.lexicon import degrees
from grounding.lexicon import words as w
from grounding.world import Array
from grounding.world.scene import Scene

_WIDE = 0.5  # distances from the middle of a table count so much as those between blocks


def make_place(
    scene: Scene, names: Iterable[str], owner: str, *, middle: bool = False, corner: bool = False, bare: bool = False,
    rim: bool = False,
) -> Place:  # fmt: skip
    """A place from the names of directions as somebody sees them; `rim` for edges, ends and corners."""
    names = tuple(names)
    vectors = tuple(scene.direction(name, owner) for name in w.flat(names))
    return Place(vectors, names, middle, corner or len(vectors) > 1, bare, owner=owner,
                 outer=rim and not (vectors or middle))  # fmt: skip


def closeness(scene: Scene, place: Place) -> Array:
    """How near every object is to a place, in [m], negative distances; larger is nearer."""
    if not place.directions:
        return np.asarray(-np.linalg.norm(scene.seen, axis=1))
    if len(place.directions) == 1 and not place.middle:
        return np.asarray(scene.xy @ place.directions[0])
    centre, half = scene.box
    target = np.sum(place.directions, axis=0) * half
    if place.middle:
        return np.asarray(-np.linalg.norm(scene.seen - target, axis=1))
    return np.asarray(-np.linalg.norm(scene.xy - centre - target, axis=1))


def in_place(scene: Scene, place: Place, base: Array) -> Array:
    """How well every object lies in a place, shape (n,), as it compares with those of `base` (n,)."""
    if not scene.n:
        return np.zeros(0)
    compared = base > 0.5
    if place.outer:
        away = _from_outside(scene, corner=place.corner)
        best = float(away[compared].min(initial=9.0))
        return np.asarray(np.exp(-0.5 * (away / 0.5) ** 2) * np.exp(-2.5 * (away - best).clip(0)))
    if not place.directions:
        away = np.linalg.norm(scene.scaled, axis=1)
        best = float(away[compared].min(initial=9.0))
        return np.asarray(np.exp(-0.5 * (np.maximum(away - 0.1, 0) / 0.45) ** 2) * np.exp(-1.5 * (away - best).clip(0)))
    if len(place.directions) > 1 or place.middle or place.corner:
        vectors = np.array(place.directions)
        offset = scene.scaled - vectors.sum(axis=0)
        if len(place.directions) == 1 and place.corner:  # one of the two corners of a side
            along = offset @ vectors[0]
            across = np.abs(np.abs(scene.scaled @ np.array([-vectors[0][1], vectors[0][0]])) - 1.0)
            away = np.hypot(along, across)
        else:
            away = np.linalg.norm(offset, axis=1)
        best = float(away[compared].min(initial=9.0))
        return np.asarray(np.exp(-0.5 * (away / 0.7) ** 2) * np.exp(-2.5 * (away - best).clip(0)))
    along = scene.scaled @ place.directions[0]
    return scores.side(along, along[compared])


def _from_outside(scene: Scene, *, corner: bool) -> Array:
    """How far every object is from the nearest corner or edge, whichever, shape (n,) in half extents."""
    inside = np.maximum(1.0 - np.abs(scene.scaled), 0.0)
    return np.asarray(np.linalg.norm(inside, axis=1) if corner else inside.min(axis=1))


def off_middle(scene: Scene, names: tuple[str, ...], owner: str, strict: bool) -> Array:
    """How well every object lies in a direction from the middle, shape (n,): "just southwest of the center"."""
    direction = np.sum([scene.direction(name, owner) for name in w.flat(names)], axis=0)
    length = max(float(np.linalg.norm(direction)), 1e-9)
    gap = _WIDE * np.linalg.norm(scene.seen, axis=1)
    return scores.directed(scene.seen, gap, direction / length, scene.edge, strict=strict)


def located(scene: Scene, value: Value, base: Array) -> list[Effect]:
    """The restriction to the place of a value; nothing where it has none."""
    return [] if value.place is None else [Restriction(in_place(scene, value.place, base))]


def part_of(scene: Scene, place: Place, whole: Value) -> Value:
    """The members of a set that lie at its end, its middle or its top."""
    total = np.zeros(scene.n)
    for mask, chance in (whole.sets or ((whole.weights > 0.5 * whole.weights.max(), 1.0),))[:SETS]:
        pool = mask.astype(float)
        upright = bool(scene.stacked[mask].all()) if mask.any() else False
        if upright and place.upright:
            total += chance * degrees.ranked(pool, place.upright * scene.z, 1, 0.3 * scene.edge)
        elif place.outer and mask.any():
            total += chance * degrees.ranked(pool, np.abs(_along(scene, pool)), 1, 0.3 * scene.edge)
        elif place.middle and not place.directions:
            total += chance * middle_one(scene, pool, chosen=True)
        else:
            total += chance * degrees.ranked(pool, closeness(scene, place), 1, 0.3 * scene.edge)
    return Value("objects", total / max(1.0, float(total.max(initial=0.0))), place=place)


def _along(scene: Scene, pool: Array) -> Array:
    """How far every object is from the middle of a pool along its longer side, shape (n,) in [m]."""
    points = scene.xy[pool > 0.3 * pool.max()]
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    axis = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][0]
    return np.asarray((scene.xy - centre) @ axis)


def middle_one(scene: Scene, pool: Array, *, chosen: bool) -> Array:
    """The middle one of a pool: nearest to the centre, and by rank along the longer side.

    Args:
        scene: the world.
        pool: weights (n,) of those among which it is.
        chosen: whether the words chose the pool; else the middle of all may be meant as well.
    """
    total = float(pool.sum())
    if total < 1e-9:
        return pool
    noise = 0.35 * scene.edge
    centre = pool @ scene.xy / total
    by_centre = degrees.ranked(pool, -np.linalg.norm(scene.xy - centre, axis=1), 1, noise)
    likely = np.flatnonzero(pool > 0.3 * pool.max())
    by_rank = np.zeros(scene.n)
    if len(likely) > 2:
        points = scene.xy[likely]
        axis = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][0]
        order = likely[np.argsort(points @ axis, kind="stable")]
        middle = order[(len(order) - 1) // 2 : len(order) // 2 + 1]
        by_rank[middle] = pool[middle] / len(middle)
    if chosen:
        return np.asarray(0.5 * by_centre + 0.5 * by_rank)
    of_all = degrees.ranked(pool, -np.linalg.norm(scene.seen, axis=1), 1, noise)
    return np.asarray(0.4 * by_centre + 0.3 * by_rank + 0.3 * of_all)
