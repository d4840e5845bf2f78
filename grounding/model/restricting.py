"""How well conditions that restrict hold of every object, each as truth and preference."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

import numpy as np

from grounding.lexicon import alone, amount, between, colour, direction, nearness, person, place, rank
from grounding.lexicon.degrees import peak
from grounding.lexicon.parameters import value
from grounding.lexicon.relations import relation
from grounding.lexicon.where import Where
from grounding.lexicon.words import flat
from grounding.meaning.referents import Condition, Referent, Region
from grounding.model.cases import Denotation, Weights
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

SETS = 5
"""Of the sets that a referent may mean, so many are tried."""
_FAR = 10.0  # [m], so that nothing is near to itself


class Held(NamedTuple):
    """How well a condition holds of every object.

    Attributes:
        truth: how true it is, shape (n,), in [0, 1].
        preference: which of those that it is true of would be meant, shape (n,), in [0, 1].
    """

    truth: Array
    preference: Array


class Evaluates(Protocol):
    """What evaluating a condition needs: the scene, whose directions are meant, and what referents mean."""

    scene: Scene
    where: Where
    view: str
    weights: Weights
    history: tuple[int, ...]

    def denote(self, referent: Referent, base: Array | None = None, *, carrying: bool = False) -> Denotation:
        """What a referent means."""

    def spot(self, region: Region) -> place.Spot:
        """A place as whoever is meant sees it."""


Restricting = Callable[[Evaluates, Condition, Array], Held]


def restricted(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """How well a condition holds of every object.

    Args:
        evaluator: of a scene.
        condition: that restricts.
        base: how well every object is of the kind that is spoken of, shape (n,).
    """
    found = _RESTRICTING[condition.concept](evaluator, condition, base)
    if condition.negated:
        return _plain(1.0 - found.truth * found.preference)
    return found


def _plain(truth: Array) -> Held:
    return Held(np.clip(truth, 0.0, 1.0), np.ones(len(truth)))


def related(denotation: Denotation, truth: Array, preference: Array, number: int | None = None) -> Held:
    """A relation of objects to objects, made one of objects to what a referent means.

    Args:
        denotation: what the referent means.
        truth: of every object (row) to every other one, shape (n, n).
        preference: the same for which is meant.
        number: how many the referent says it is.
    """
    truth = np.where(np.eye(len(truth), dtype=bool), 0.0, truth)
    if denotation.sets:
        return _related_to_sets(denotation, truth, truth * preference, number)
    likely = denotation.weights[None, :]
    return _fraction(_some(truth * likely), _some(truth * preference * likely))


def _some(chances: Array) -> Array:
    """How likely one at least holds, by rows."""
    return np.asarray(1.0 - np.exp(np.log1p(-np.minimum(chances, 1 - 1e-9)).sum(axis=1)))


def _fraction(truth: Array, held: Array) -> Held:
    return Held(truth, np.divide(held, truth, out=np.ones_like(held), where=truth > 1e-9))


def _related_to_sets(denotation: Denotation, truth: Array, held: Array, number: int | None) -> Held:
    best_truth, best = np.zeros(len(truth)), np.zeros(len(truth))
    for mask, chance in denotation.sets[:SETS]:
        count = int(mask.sum())
        if not count:
            continue
        several = 1 < count <= 3 and number is not None
        inside = held[:, mask].mean(axis=1) if several else held[:, mask].max(axis=1)
        true = truth[:, mask].mean(axis=1) if several else truth[:, mask].max(axis=1)
        best = np.maximum(best, chance * inside * ~mask)
        best_truth = np.maximum(best_truth, chance * true * ~mask)
    return _fraction(best_truth, best)


def _colour(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return _plain(colour.truth(evaluator.scene, condition.words))


def _strange(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return _plain(np.full(evaluator.scene.n, value("colour.strange")))


def _toward(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    reference = evaluator.denote(condition.of[0], base)
    if {"up", "down"} & set(condition.words) and scene.towers:
        height = direction.vertical(evaluator.where, scene, 1.0 if "up" in condition.words else -1.0)
        found = related(reference, height, np.ones_like(height))
        if found.truth.max(initial=0.0) > 0.3:
            return found
    vector = direction.unit(scene, condition.words, condition.owner or evaluator.view)
    if vector is None:
        return _plain(np.ones(scene.n))
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
    return _fraction(best_truth, best)


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
        return _plain(np.ones(scene.n))
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
    found = starts(evaluator, reference)
    return _plain(amount.measured(scene.xy, scene.edge, found, way, steps, counting=condition.counting))


def _stepped(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene, view = evaluator.scene, condition.owner or evaluator.view
    ways = [(scene.direction(name, view), count) for names, count in condition.ways for name in flat(names)]
    found = starts(evaluator, evaluator.denote(condition.of[0], base))
    return _plain(amount.stepped(scene.xy, scene.edge, found, ways))


def _near(evaluator: Evaluates, condition: Condition, base: Array, reach: str) -> Held:
    held = nearness.truth(evaluator.where.gaps, evaluator.scene.edge, reach)
    reference = condition.of[0]
    return related(evaluator.denote(reference, base), held, np.ones_like(held), reference.number)


def _beside(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return _near(evaluator, condition, base, nearness.HAVING if condition.said == "has" else nearness.BESIDE)


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
    return _plain(between.amid(evaluator.where, evaluator.scene, parts, surrounding=False))


def _surrounded(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    parts = _parts(evaluator, condition.of, base)
    if not any(part.weights.any() for part in parts):
        parts = [between.Part(np.ones(evaluator.scene.n), condition.of[0].number)]
    return _plain(between.amid(evaluator.where, evaluator.scene, parts, surrounding=True))


def _at(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    if condition.region is None or not scene.n:
        return _plain(np.ones(scene.n))
    spot = evaluator.spot(condition.region)
    if condition.said == "clear":
        along = [place.within(scene, spot) @ vector > 0 for vector in spot.directions]
        return _plain(np.all(along, axis=0).astype(float) if along else np.ones(scene.n))
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
    return _fraction(members, total)


def _within(evaluator: Evaluates, mask: np.ndarray, spot: place.Spot) -> Array:
    """How well every member of a set is the part of it that is meant."""
    scene, pool, blur = evaluator.scene, mask.astype(float), rank.blur(evaluator.scene)
    if scene.stacked[mask].all() and spot.upright:
        return pool * rank.truth(pool, spot.upright * scene.z, 1, blur)
    if spot.outer:
        return pool * rank.truth(pool, np.abs(rank.along(scene, pool)), 1, blur)
    if spot.middle and not spot.directions:
        return pool * rank.middle(scene, pool, chosen=True)
    return pool * rank.truth(pool, place.closeness(scene, spot), 1, blur)


def _centre(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """In the middle of several: the middle one of them, or what lies between them."""
    whole = evaluator.denote(condition.of[0], base)
    member = whole.weights * whole.truth
    amid = between.amid(evaluator.where, evaluator.scene, _parts(evaluator, condition.of[1:], base), surrounding=False)
    return _plain(np.maximum(member, amid))


def _on(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    reference = evaluator.denote(condition.of[0], base, carrying=True)
    over = direction.vertical(evaluator.where, scene, 1.0)
    return related(reference, over, np.ones_like(over))


def _on_table(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return Held(np.ones(evaluator.scene.n), np.where(evaluator.scene.raised, 0.3, 1.0))


def _alone(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return _plain(alone.truth(evaluator.scene, base, counted=condition.counting))


def _before(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    owner = condition.of[0].person or ROBOT
    if {"front", "back"} & set(condition.words):
        return Held(np.ones(scene.n), person.before(scene, owner))
    spot = place.make_spot(scene, condition.words, owner)
    return Held(place.truth(scene, spot), place.preference(scene, spot, np.ones(scene.n, bool)))


def _same(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return _plain(evaluator.denote(condition.of[0], base).weights)


def _other(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    if condition.of:
        return _plain(1.0 - evaluator.denote(condition.of[0], base).weights)
    if not evaluator.history:
        return _plain(np.ones(scene.n))
    handled = evaluator.history[-1]
    colours = [item.color for item in scene.layout.things]
    alike = np.array([shade == colours[handled] for shade in colours])
    found = np.where(alike | bool(condition.words), 1.0, value("handled.other_kind"))
    if alike.sum() < 2:
        found[:] = 1.0
    found[handled] = 0.0
    return _plain(found)


def _recalled(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """The object that was handled last among those of a colour that was said."""
    scene, found = evaluator.scene, np.zeros(evaluator.scene.n)
    fits = colour.truth(scene, condition.words)
    if evaluator.history:
        found[next((i for i in reversed(evaluator.history) if fits[i] > 0), evaluator.history[-1])] = 1.0
    return _plain(found)


def _outside(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    reference, scene = evaluator.denote(condition.of[0], base), evaluator.scene
    inside = np.zeros(scene.n)
    for mask, chance in reference.sets[:SETS] or ((reference.likely, 1.0),):
        held = mask
        if "circle" in condition.of[0].kinds and mask.any():
            radii = np.linalg.norm(scene.xy - scene.xy[mask].mean(axis=0), axis=1)
            held = mask | (radii < radii[mask].mean())
        inside = np.maximum(inside, chance * held)
    return _plain(1.0 - inside)


def _others(evaluator: Evaluates, condition: Condition, base: Array) -> Array:
    scene = evaluator.scene
    others = colour.truth(scene, condition.words) if condition.words else base
    return alone.gaps_to_others(scene, others > 0.5)


def _apart_others(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene, gaps = evaluator.scene, _others(evaluator, condition, base)
    farthest = rank.truth(np.ones(scene.n), gaps, 1, scene.edge)
    return Held(1.0 - nearness.truth(gaps, scene.edge, nearness.APART), farthest)


def _with_others(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    gaps = _others(evaluator, condition, base)
    return _plain(nearness.truth(gaps, evaluator.scene.edge, nearness.AMONG))


def _member(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """Membership as a restriction, where it is denied."""
    return _plain(evaluator.denote(condition.of[0], base).weights)


_RESTRICTING: dict[str, Restricting] = {
    "colour": _colour, "strange": _strange, "toward": _toward, "off_middle": _off_middle, "measured": _measured,
    "stepped": _stepped, "beside": _beside, "touching": _touching, "apart": _apart, "between": _between,
    "surrounded": _surrounded, "at": _at, "part": _part, "centre": _centre, "on": _on, "on_table": _on_table,
    "alone": _alone, "before": _before, "same": _same, "other": _other, "recalled": _recalled, "outside": _outside,
    "apart_others": _apart_others,
    "with_others": _with_others, "relation": _relation,
    "member": _member, "among": _member, "those": _member,
}  # fmt: skip


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

