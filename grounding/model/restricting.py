"""How well conditions that restrict hold of every object, each as truth and preference."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.lexicon import alone, colour, kind, nearness, rank
from grounding.lexicon.parameters import value
from grounding.meaning.referents import Condition
from grounding.model.holding import SETS, Evaluates, Held, Restricting, plain
from grounding.model.relating import RELATING
from grounding.model.standing import STANDING
from grounding.world import Array
from grounding.world.scene import Scene


def restricted(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """How well a condition holds of every object.

    Args:
        evaluator: of a scene.
        condition: that restricts.
        base: how well every object is of the kind that is spoken of, shape (n,).
    """
    found = _RESTRICTING[condition.concept](evaluator, condition, base)
    if condition.negated:
        return plain(1.0 - found.truth * found.preference)
    return found


def base_of(scene: Scene, conditions: Sequence[Condition]) -> Array:
    """How well every object is of the kind and the colour that are said, shape (n,)."""
    said = {name: tuple(word for c in conditions if c.concept == name and not c.negated for word in c.words)
            for name in ("kind", "colour")}  # fmt: skip
    return kind.fitting(scene, said["kind"], said["colour"])


def _colour(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return plain(colour.truth(evaluator.scene, condition.words))


def _strange(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return plain(kind.called(evaluator.scene, condition.said))


def _kind(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return plain(kind.truth(evaluator.scene, condition.words))


def _same(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    return plain(evaluator.denote(condition.of[0], base).weights)


def _other(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    scene = evaluator.scene
    if condition.of:
        return plain(1.0 - evaluator.denote(condition.of[0], base).weights)
    if not evaluator.history:
        return plain(np.ones(scene.n))
    handled = evaluator.history[-1]
    colours = [item.color for item in scene.layout.things]
    alike = np.array([shade == colours[handled] for shade in colours])
    found = np.where(alike | bool(condition.words), 1.0, value("handled.other_kind"))
    if alike.sum() < 2:
        found[:] = 1.0
    found[handled] = 0.0
    return plain(found)


def _recalled(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """The object that was handled last among those of a colour that was said."""
    scene, found = evaluator.scene, np.zeros(evaluator.scene.n)
    fits = colour.truth(scene, condition.words)
    if evaluator.history:
        found[next((i for i in reversed(evaluator.history) if fits[i] > 0), evaluator.history[-1])] = 1.0
    return plain(found)


def _outside(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    reference, scene = evaluator.denote(condition.of[0], base), evaluator.scene
    inside = np.zeros(scene.n)
    for mask, chance in reference.sets[:SETS] or ((reference.likely, 1.0),):
        held = mask
        if "circle" in condition.of[0].kinds and mask.any():
            radii = np.linalg.norm(scene.xy - scene.xy[mask].mean(axis=0), axis=1)
            held = mask | (radii < radii[mask].mean())
        inside = np.maximum(inside, chance * held)
    return plain(1.0 - inside)


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
    return plain(nearness.truth(gaps, evaluator.scene.edge, nearness.AMONG))


def _member(evaluator: Evaluates, condition: Condition, base: Array) -> Held:
    """Membership as a restriction, where it is denied."""
    return plain(evaluator.denote(condition.of[0], base).weights)


_RESTRICTING: dict[str, Restricting] = {
    **RELATING, **STANDING,
    "colour": _colour, "strange": _strange, "kind": _kind, "same": _same, "other": _other, "recalled": _recalled,
    "outside": _outside, "apart_others": _apart_others, "with_others": _with_others, "member": _member,
    "among": _member, "those": _member,
}  # fmt: skip
