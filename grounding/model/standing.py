"""Conditions that say where objects are: amid others, in a place or a part, on something, before somebody."""

from __future__ import annotations

import numpy as np

from grounding.lexicon import alone, between, direction, person, place, rank, table
from grounding.lexicon.degrees import peak
from grounding.meaning.referents import Condition, Referent, Region
from grounding.model.cases import Denotation
from grounding.model.holding import SETS, Evaluates, Held, Restricting, fraction, plain, related
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene


def _parts(evaluator: Evaluates, referents: tuple[Referent, ...], base: Array) -> list[between.Part]:
    found = []
    for referent in referents:
        denotation = evaluator.denote(referent, base)
        arranged = bool(denotation.sets) and bool(referent.kinds)
        if arranged and (referent.plural or referent.number == 2) and len(referents) == 1:
            return _two(denotation)
        number = referent.number if not arranged else None
        several = referent.plural or arranged
        point = evaluator.scene.xy[denotation.sets[0][0]].mean(axis=0) if arranged else None
        weights = denotation.sets[0][0].astype(float) if arranged else denotation.weights
        found.append(between.Part(weights, number or (None if several else 1), point))
    return found


def _two(denotation: Denotation) -> list[between.Part]:
    """The two likeliest sets that share nothing: "between the rows"."""
    first = denotation.sets[0][0]
    others = [mask for mask, _ in denotation.sets[1:] if not (mask & first).any()]
    return [between.Part(mask.astype(float), None, np.zeros(2)) for mask in (first, *others[:1])]


def _between(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    parts = _parts(evaluator, condition.of, base)
    return plain(between.amid(evaluator.where, evaluator.scene, parts, surrounding=False))


def _surrounded(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    parts = _parts(evaluator, condition.of, base)
    if not any(part.weights.any() for part in parts):
        parts = [between.Part(np.ones(evaluator.scene.n), condition.of[0].number)]
    return plain(between.amid(evaluator.where, evaluator.scene, parts, surrounding=True))


def _at(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    if condition.region is None or not scene.n:
        return plain(np.ones(scene.n))
    spot = evaluator.spot(condition.region)
    if condition.said == "clear":
        along = [place.within(scene, spot) @ vector > 0 for vector in spot.directions]
        return plain(np.all(along, axis=0).astype(float) if along else np.ones(scene.n))
    return Held(place.truth(scene, spot), place.preference(scene, spot, base > 0.5))


def _part(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """The members of a set that lie at its end, its middle or its top."""
    scene = evaluator.scene
    whole = evaluator.denote(condition.of[0], base)
    spot = evaluator.spot(condition.region or Region())
    total, members = np.zeros(scene.n), np.zeros(scene.n)
    for mask, chance in (whole.sets or ((whole.weights > 0.5 * peak(whole.weights), 1.0),))[:SETS]:
        if mask.any():
            total = np.maximum(total, chance * _within(evaluator, mask, spot))
            members = np.maximum(members, chance * mask)
    return fraction(members, total)


def _within(evaluator: Evaluates, mask: np.ndarray, spot: place.Spot) -> Array:
    """How well every member of a set is the part of it that is meant."""
    scene, pool, blur = evaluator.scene, mask.astype(float), rank.blur(evaluator.scene)
    if scene.stacked[mask].all() and spot.upright:
        return pool * rank.truth(pool, spot.upright * scene.z, 1, blur)
    if spot.middle and not spot.directions and mask.sum() > 1 and scene.in_one_tower(mask):
        return pool * rank.truth(pool, -np.abs(scene.z - scene.z[mask].mean()), 1, blur)
    if spot.outer:
        return pool * rank.truth(pool, np.abs(rank.along(scene, pool)), 1, blur)
    if spot.middle and not spot.directions:
        return pool * rank.middle(scene, pool, chosen=True)
    return pool * rank.truth(pool, place.closeness(scene, spot), 1, blur)


def _centre(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """In the middle of several: the middle one of them, or what lies between them."""
    part = next((c for c in condition.of[0].conditions if c.concept == "part"), None)
    if part is None:
        whole = evaluator.denote(condition.of[0], base)
        member = whole.weights * whole.truth
    else:
        held = _part(evaluator, part, base)
        member = held.truth * held.preference
    if condition.of[1].kinds[:1] == ("tower",) and evaluator.scene.towers:
        return plain(member)  # nothing but its own blocks is within a tower
    amid = between.amid(evaluator.where, evaluator.scene, _parts(evaluator, condition.of[1:], base), surrounding=False)
    return plain(np.maximum(member, amid))


def _on(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    reference = evaluator.denote(condition.of[0], base, carrying=True)
    over = direction.vertical(evaluator.where, scene, 1.0)
    if not condition.of[0].kinds:
        return related(reference, over, np.ones_like(over))
    above, top = np.zeros(scene.n), np.zeros(scene.n)  # what stands on a tower may be a part of it
    for mask, chance in reference.sets[:SETS]:
        above = np.maximum(above, chance * over[:, mask].max(axis=1, initial=0.0) * ~mask)
        top = np.maximum(top, chance * mask * (scene.z >= scene.z[mask].max(initial=-np.inf)))
    return plain(np.maximum(above, top))


def _on_table(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    if condition.of:
        return plain(_on_which(evaluator, condition.of[0]))
    return Held(np.ones(evaluator.scene.n), np.where(evaluator.scene.raised, 0.3, 1.0))


def _on_which(evaluator: Evaluates, referent: Referent) -> Array:
    """What stands on one of several tables: "the left table", "the yellow one"."""
    scene = evaluator.scene
    below = table.under(scene, scene.xy)
    handled = below[evaluator.history[-1]] if evaluator.history else -1
    fits = meant_tables(scene, referent, evaluator.view, int(handled))
    return np.array([0 <= index and fits[index] for index in below], dtype=float)


def meant_tables(scene: Scene, referent: Referent, view: str, here: int) -> np.ndarray:
    """Which tables a referent means, boolean (t,).

    Args:
        scene: the world.
        referent: a table.
        view: whose directions are meant where nobody is named.
        here: index of the table that "the other" is not, or -1.
    """
    said = {condition.concept: condition for condition in referent.conditions}
    region = said["extreme"].region if "extreme" in said else None
    return table.meant(scene, said["colour"].words if "colour" in said else (), region.names if region else (),
                       (region.owner if region else None) or view, here if "other" in said else -1)  # fmt: skip


def _alone(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return plain(alone.truth(evaluator.scene, base, counted=condition.counting))


def _before(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    owner = condition.of[0].person or ROBOT
    if {"front", "back"} & set(condition.words):
        return Held(np.ones(scene.n), person.before(scene, owner))
    spot = place.make_spot(scene, condition.words, owner)
    return Held(place.truth(scene, spot), place.preference(scene, spot, np.ones(scene.n, bool)))


STANDING: dict[str, Restricting] = {
    "between": _between, "surrounded": _surrounded, "at": _at, "part": _part, "centre": _centre, "on": _on,
    "on_table": _on_table, "alone": _alone, "before": _before,
}  # fmt: skip
"""The conditions of this module by concept."""
