"""Conditions that relate objects to objects: directions, distances, nearness and contact."""

from __future__ import annotations

import numpy as np

from grounding.lexicon import amount, direction, nearness, rank, words
from grounding.lexicon.parameters import value
from grounding.lexicon.relations import relation
from grounding.lexicon.where import Where
from grounding.lexicon.words import flat
from grounding.meaning.referents import Condition
from grounding.model.cases import Denotation
from grounding.model.holding import SETS, Evaluates, Held, Restricting, fraction, plain, related
from grounding.world import Array

_FAR = 10.0  # [m], so that nothing is near to itself


def _toward(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    reference = evaluator.denote(condition.of[0], base)
    if {"up", "down"} & set(condition.words) and scene.towers:
        upward = "up" in condition.words
        height = direction.vertical(evaluator.where, scene, 1.0 if upward else -1.0)
        below = evaluator.denote(condition.of[0], base, carrying=True) if upward else reference
        found = related(below, height, np.ones_like(height))
        if found.truth.max(initial=0.0) > 0.3:
            return found
    vector = direction.unit(scene, condition.words, condition.owner or evaluator.view)
    if vector is None:
        return plain(np.ones(scene.n))
    near = direction.preference(evaluator.where.gaps, scene.edge, strict=condition.strict)
    if not reference.sets:
        held = direction.truth(evaluator.where, scene.xy, scene.edge, vector, strict=condition.strict)
        return related(reference, held, near)
    best_truth, best = np.zeros(scene.n), np.zeros(scene.n)
    for mask, chance in reference.sets[:SETS]:
        if mask.any():
            true = direction.truth_of_set(evaluator.where, scene.xy[mask], scene.edge, vector, strict=condition.strict)
            true = chance * true * ~mask
            best_truth = np.maximum(best_truth, true)
            best = np.maximum(best, true * near[:, mask].max(axis=1))
    return fraction(best_truth, best)


def _relation(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """A relation that is a module of the lexicon."""
    module = relation(condition.words[0])
    held = module.truth(evaluator.where, evaluator.scene)
    near = module.preference(evaluator.where, evaluator.scene)
    return related(evaluator.denote(condition.of[0], base), held, near, condition.of[0].number)


def _off_middle(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    vector = direction.unit(scene, condition.words, condition.owner or evaluator.view)
    if vector is None:
        return plain(np.ones(scene.n))
    seen = Where(scene.seen, scene.z, scene.gaps, np.eye(scene.n, dtype=bool))
    held = direction.truth(seen, np.zeros((1, 2)), scene.edge, vector, strict=condition.strict)[:, 0]
    gaps = value("place.wide") * np.linalg.norm(scene.seen, axis=1)
    return Held(held, direction.preference(gaps, scene.edge, strict=condition.strict))


def starts(evaluator: Evaluates, reference: Denotation) -> list[amount.Start]:
    """Points from which is measured, with how likely they are meant."""
    scene = evaluator.scene
    if reference.spot is not None and not reference.weights.any():
        centre, half = scene.box
        leading = np.sum(reference.spot.directions, axis=0) if reference.spot.directions else np.zeros(2)
        return [(centre + leading * half, 1.0)]
    if reference.sets:
        return [(scene.xy[mask].mean(axis=0), chance) for mask, chance in reference.sets[:SETS] if mask.any()]
    return [(scene.xy[i], float(reference.weights[i])) for i in np.argsort(-reference.weights)[:4]]


def _measured(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    reference = evaluator.denote(condition.of[0], base)
    names = flat(condition.words)
    way = np.sum([scene.direction(name, condition.owner or evaluator.view) for name in names] or [np.zeros(2)], axis=0)
    steps = condition.number or 1.0
    if condition.metric:
        steps = amount.in_blocks(steps, scene.edge)
    found = starts(evaluator, reference)
    return plain(amount.measured(scene.xy, scene.edge, found, way, steps, counting=condition.counting))


def _stepped(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene, view = evaluator.scene, condition.owner or evaluator.view
    ways = [(scene.direction(name, view), count) for names, count in condition.ways for name in flat(names)]
    found = starts(evaluator, evaluator.denote(condition.of[0], base))
    return plain(amount.stepped(scene.xy, scene.edge, found, ways))


def _near(evaluator: Evaluates, condition: Condition, base: Array, reach: str) -> Held:
    held = nearness.truth(evaluator.where.gaps, evaluator.scene.edge, reach)
    reference = condition.of[0]
    found = evaluator.denote(reference, base)
    return related(found, held, np.ones_like(held), reference.number, together=bool(reference.parts))


def _beside(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    reach = nearness.NEAR if words.nearness(condition.said) == "near" else nearness.BESIDE
    return _near(evaluator, condition, base, nearness.HAVING if condition.said == "has" else reach)


def _touching(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return _near(evaluator, condition, base, nearness.BESIDE if condition.nearly else nearness.TOUCHING)


def distance_to(evaluator: Evaluates, reference: Denotation, *, definite: bool = True) -> Array:
    """How far every object is from a reference [m], shape (n,); from the nearest member of sets and of "a block"."""
    scene = evaluator.scene
    if reference.sets:
        total = np.zeros(scene.n)
        share = sum(chance for _, chance in reference.sets[:SETS]) or 1.0
        for mask, chance in reference.sets[:SETS]:
            nearest = scene.apart[:, mask].min(axis=1) if mask.any() else np.zeros(scene.n)
            total += chance / share * np.where(mask, _FAR, nearest)
        return total
    if not definite:
        some = reference.weights > 0.5
        close = np.where(some[None, :], scene.apart + _FAR * np.eye(scene.n), np.inf).min(axis=1)
        return np.where(np.isfinite(close), close, _FAR)
    likely = reference.weights / max(float(reference.weights.sum()), 1e-9)
    return np.asarray(scene.apart @ likely + _FAR * likely)


def _apart(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    reference = evaluator.denote(condition.of[0], base)
    inside = reference.weights if reference.sets else np.zeros(scene.n)
    held = nearness.truth(evaluator.where.gaps, scene.edge, nearness.APART)
    near = related(reference, held, np.ones_like(held)).truth
    away = np.where(inside > 0.5, 0.0, distance_to(evaluator, reference))
    return Held(1.0 - np.maximum(near, inside), rank.truth(np.ones(scene.n), away, 1, scene.edge))


def lane(evaluator: Evaluates, condition: Condition, base: Array) -> tuple[Array, Array]:
    """Those that are counted along a direction, and the order in which: "the second block behind X".

    Returns:
        how well every object lies in the lane, and a key that is larger for what comes first, shape (n,) each.
    """
    scene = evaluator.scene
    reference = evaluator.denote(condition.of[0], base)
    vector = direction.unit(scene, condition.words, condition.owner or evaluator.view)
    if vector is None:
        return np.ones(scene.n), np.zeros(scene.n)
    held = direction.truth(evaluator.where, scene.xy, scene.edge, vector, strict=True)
    return related(reference, held, np.ones_like(held)).truth, -distance_to(evaluator, reference)


RELATING: dict[str, Restricting] = {
    "toward": _toward, "off_middle": _off_middle, "measured": _measured, "stepped": _stepped, "beside": _beside,
    "touching": _touching, "apart": _apart, "relation": _relation,
}  # fmt: skip
"""The conditions of this module by concept."""
