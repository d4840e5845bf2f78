"""How well every object stands in a relation to what a phrase means: near it, in a direction of it, so far from it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from grounding.graded import scores
from grounding.graded.values import SETS, Restriction, Value
from grounding.lexicon import degrees
from grounding.lexicon import words as w
from grounding.world import Array
from grounding.world.scene import Scene

_PITCH = 1.08  # edges from one block to the next where people count by blocks
_COUNTED = 0.7  # how often "two blocks behind" is the second block there, rather than so many lengths away
_FAR = 10.0  # [m], so that nothing is near to itself


def pairwise(scene: Scene, value: Value, relation: Array) -> Array:
    """A relation of objects to references, made one of objects to what a phrase means.

    Args:
        scene: the world.
        value: what the phrase is worth.
        relation: of every object (row) to every other one, shape (n, n); its diagonal is cleared.

    Returns:
        shape (n,).
    """
    np.fill_diagonal(relation, 0.0)
    if value.kind == "sets" and value.sets:
        total = np.zeros(scene.n)
        for mask, chance in value.sets[:SETS]:
            inside = relation[:, mask]
            if not mask.any():
                continue
            count = int(mask.sum())
            held = inside.mean(axis=1) if 1 < count <= 3 and value.number else inside.max(axis=1)
            total = np.maximum(total, chance * held * ~mask)
        return total
    likely = value.weights / degrees.peak(value.weights)
    return np.asarray(1.0 - np.exp(np.log1p(-np.minimum(relation * likely[None, :], 1 - 1e-9)).sum(axis=1)))


def near(scene: Scene, value: Value, reach: float) -> Array:
    """How well objects lie beside a reference, one half at a gap of `reach` edges."""
    return pairwise(scene, value, scores.beside(scene.gaps, scene.edge, reach))


def directed(
    scene: Scene, value: Value, names: tuple[str, ...], owner: str, strict: bool, *, fading: bool = True
) -> Array:
    """How well objects lie in a direction of a reference, as somebody sees it; by height where things are stacked."""
    if ("up" in names or "down" in names) and scene.towers:
        height = vertical(scene, value, 1.0 if "up" in names else -1.0)
        if height.max(initial=0.0) > 0.3:
            return height
    vectors = [scene.direction(name, owner) for name in w.flat(names)]
    if not vectors:
        return np.ones(scene.n)
    direction = np.sum(vectors, axis=0)
    length = float(np.linalg.norm(direction))
    if length < 1e-6:
        return np.ones(scene.n)
    offset = scene.xy[:, None] - scene.xy[None]
    held = scores.directed(offset, scene.gaps, direction / length, scene.edge, strict=strict, fading=fading)
    return pairwise(scene, value, held)


def along(scene: Scene, value: Value, names: tuple[str, ...], owner: str, strict: bool) -> Restriction:
    """A direction from a reference; ordinals count away from it, and little to the side."""
    lane = directed(scene, value, names, owner, True, fading=False)
    return Restriction(directed(scene, value, names, owner, strict), -distance_to(scene, value), lane=lane)


def measured(
    scene: Scene, value: Value, names: tuple[str, ...], owner: str, steps: float, *, counting: bool = False
) -> Array:
    """So many blocks away in a direction, by blocks that lie there or by their lengths."""
    vector = np.sum([scene.direction(name, owner) for name in w.flat(names)], axis=0)
    total, counted = np.zeros(scene.n), np.zeros(scene.n)
    share = _COUNTED if counting and steps >= 1 and steps == int(steps) else 0.0
    for start, chance in _starts(scene, value):
        for count, likely in ((steps, 0.8), (steps + 1, 1.0)):
            target = start + vector * count * _PITCH * scene.edge
            away = np.linalg.norm(scene.xy - target, axis=1) / scene.edge
            held = np.exp(-0.5 * (away / (0.6 + 0.2 * steps)) ** 2)
            total = np.maximum(total, chance * likely * held)
        if share:
            counted = counted + chance * (1 - counted) * _counted_off(scene, start, vector, int(steps))
    return np.asarray((1 - share) * total + share * counted)


def stepped(scene: Scene, value: Value, steps: Sequence[tuple[tuple[str, ...], float]], owner: str) -> Array:
    """So many blocks away along every one of several directions, by their lengths, shape (n,).

    Args:
        scene: the world.
        value: from which is measured.
        steps: names of directions, and how many blocks in them.
        owner: whose directions are meant.
    """
    total = np.zeros(scene.n)
    for start, chance in _starts(scene, value):
        for further, likely in ((0, 0.8), (1, 1.0)):  # counted to its middle, or what lies in between
            target = start + _PITCH * scene.edge * np.sum(
                [(count + further) * scene.direction(name, owner) for names, count in steps for name in w.flat(names)],
                axis=0,
            )
            away = np.linalg.norm(scene.xy - target, axis=1) / scene.edge
            spread = 0.6 + 0.2 * max(count for _, count in steps)
            total = np.maximum(total, chance * likely * np.exp(-0.5 * (away / spread) ** 2))
    return total


def _counted_off(scene: Scene, start: Array, vector: Array, index: int) -> Array:
    """How well every object is the index-th of those that lie in a direction, shape (n,)."""
    length = float(np.linalg.norm(vector))
    if length < 1e-6:
        return np.zeros(scene.n)
    ahead = (scene.xy - start) @ vector / length
    side = np.abs((scene.xy - start) @ np.array([-vector[1], vector[0]]) / length)
    lane = degrees.logistic((ahead / scene.edge - 0.4) / 0.12) * np.exp(-0.5 * (side / (0.9 * scene.edge)) ** 2)
    return degrees.ranked(lane, -ahead, index, 0.3 * scene.edge)


def _starts(scene: Scene, value: Value) -> list[tuple[Array, float]]:
    """Points from which is measured, with how likely they are meant."""
    if value.kind == "place" and value.place is not None:
        centre, half = scene.box
        return [(centre + (np.sum(value.place.directions, axis=0) * half if value.place.directions else 0.0), 1.0)]
    if value.kind == "sets":
        return [(scene.xy[mask].mean(axis=0), chance) for mask, chance in value.sets[:SETS] if mask.any()]
    best = degrees.peak(value.weights)
    return [(scene.xy[i], float(value.weights[i]) / best) for i in np.argsort(-value.weights)[:4]]


def vertical(scene: Scene, value: Value, sign: float) -> Array:
    """On top of a reference, or under it where the sign is negative.

    Who says "on the red block" speaks of one that carries something, so that `Scene.salience` is undone.
    """
    if value.kind == "objects":
        value = replace(value, weights=value.weights / scene.salience)
    over = scene.apart < 0.5 * scene.edge
    step = sign * (scene.z[:, None] - scene.z[None]) / scene.edge
    return pairwise(scene, value, np.where(over & (step > 0.5), np.exp(-0.3 * np.maximum(step - 1, 0)), 0.0))


def distance_to(scene: Scene, value: Value) -> Array:
    """How far every object is from a reference [m], shape (n,); from the nearest member of sets and of "a block"."""
    if value.kind == "sets" and value.sets:
        total = np.zeros(scene.n)
        share = sum(chance for _, chance in value.sets[:SETS]) or 1.0
        for mask, chance in value.sets[:SETS]:
            nearest = scene.apart[:, mask].min(axis=1) if mask.any() else np.zeros(scene.n)
            total += chance / share * np.where(mask, _FAR, nearest)
        return total
    likely = value.weights / max(float(value.weights.sum()), 1e-9)
    if not value.definite:
        close = np.where(value.weights[None, :] > 0.5, scene.apart + _FAR * np.eye(scene.n), np.inf).min(axis=1)
        return np.asarray(np.where(np.isfinite(close), close, _FAR))
    return np.asarray(scene.apart @ likely + _FAR * likely)
