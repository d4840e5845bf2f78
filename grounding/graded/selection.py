"""The objects that a noun means: restrictors make a pool before selectors choose within it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from grounding.graded import sets
from grounding.graded.selectors import adjectives, choose
from grounding.graded.surroundings import lone, single
from grounding.graded.values import SETS, Effect, Membership, Rank, Restriction, Value
from grounding.lexicon import degrees, parameters
from grounding.meaning.nouns import Noun
from grounding.world import Array
from grounding.world.scene import Scene

FAINT = parameters.value("answer.floor") * parameters.value("answer.floor")
"""What lies outside a set from which is chosen."""

_LONELY = 0.3  # a first or last one needs others behind or before it
_UNIQUE = 1.0  # "the block at the back" is the one of which that holds best: how much that speaks against the next
_ALIKE = 0.4  # who names one of a set without telling which mostly means a set of one


@dataclass(frozen=True, eq=False)
class _Sorted:
    """Effects by what they do.

    Attributes:
        weights: of the base as restricted, shape (n,).
        preference: by which objects are preferred once they were selected, shape (n,).
        memberships: sets from which is chosen.
        ranks: what selects.
        in_stack: whether one of the sets is a stack.
    """

    weights: Array
    preference: Array
    memberships: list[Membership]
    ranks: list[Rank]
    in_stack: bool


def select(
    scene: Scene, view: str, noun: Noun, base: Array, effects: list[Effect], unspoken: Array | None = None
) -> Value:
    """What a noun means, by its own words and what its modifiers do.

    Args:
        scene: the world.
        view: whose left is meant where nobody is named.
        noun: its modifiers count by their effects only.
        base: how well every object agrees with the noun's words, shape (n,).
        effects: of its modifiers.
        unspoken: how well every object is another one than was spoken of, shape (n,), where the noun asks for it.
    """
    said = _sort(scene, noun, base, effects)
    weights = said.weights
    if noun.lone:
        ranked = noun.unstacked and bool(said.ranks or noun.ordinals or noun.directions or noun.distance)
        weights = weights * degrees.softened(single(scene, base) if ranked else lone(scene, base))
    if unspoken is not None:
        weights = weights * unspoken
    plain = not said.in_stack and not noun.plural and "up" not in noun.directions and "down" not in noun.directions
    salience = scene.salience if plain else np.ones(scene.n)
    weights = weights * salience
    choices = _choices(scene, said.memberships)
    chosen = bool(said.memberships)
    pools = []
    for member, chance in choices:
        pool = weights * np.where(member > 0, 1.0, FAINT)
        if chosen:
            chance *= _presupposed(noun, int((pool > 0.3).sum()), ranked=bool(said.ranks))
        pools.append((pool, chance))
    if noun.plural:
        return _plural(scene, view, noun, pools, said.ranks)
    kinds = said.memberships[0].kinds if chosen else ()
    total = np.zeros(scene.n)
    for pool, chance in pools:
        total += chance * choose(scene, view, noun, pool, said.ranks, kinds, chosen=chosen, in_stack=said.in_stack)
    total = total / max(1.0, sum(chance for _, chance in choices))
    ranking = bool(said.ranks or noun.ordinals or noun.distance or noun.directions)
    if noun.definite and not ranking:
        held = total / salience  # to be easily seen is no description
        total = total * (held / degrees.peak(held)) ** _UNIQUE
    return Value("objects", total * said.preference ** (0.15 if ranking else 1.0), definite=noun.definite)


def _presupposed(noun: Noun, count: int, *, ranked: bool) -> float:
    """How well a set of so many members fits a noun that chooses among them: "the block in the row" is its only one."""
    if noun.only:
        return float(np.exp(-1.2 * abs(count - 1)))
    if noun.ordinals and count < 2:
        return _LONELY
    telling = ranked or noun.ordinals or noun.distance or noun.directions or noun.middle or noun.size or noun.plural
    return 1.0 if telling or not noun.definite else float(np.exp(-_ALIKE * min(max(count - 1, 0), 4)))


def _sort(scene: Scene, noun: Noun, base: Array, effects: list[Effect]) -> _Sorted:
    weights = base.copy()
    preference = np.ones(scene.n)
    memberships: list[Membership] = []
    ranks: list[Rank] = []
    for effect in effects:
        if isinstance(effect, Restriction) and effect.preferred:
            preference = preference * degrees.softened(effect.weights)
        elif isinstance(effect, Restriction):
            weights = weights * degrees.softened(_counted(effect, noun))
            if effect.order is not None and noun.ordinals:
                ranks.append(Rank(effect.order, None, 0.3 * scene.edge))
        elif isinstance(effect, Membership):
            memberships.append(effect)
        else:
            ranks.append(effect)
    in_stack = any(mask.any() and scene.stacked[mask].all() for m in memberships for mask, _ in m.sets)
    return _Sorted(weights, preference, memberships, ranks, in_stack)


def _counted(effect: Restriction, noun: Noun) -> Array:
    """How well a restriction holds; where an ordinal counts along it, distance does not speak against."""
    return effect.weights if effect.lane is None or not noun.ordinals else effect.lane


def _choices(scene: Scene, memberships: list[Membership]) -> list[tuple[np.ndarray, float]]:
    """What lies in one set of every membership, with how likely those sets are meant together."""
    choices: list[tuple[np.ndarray, float]] = [(np.ones(scene.n), 1.0)]
    for membership in memberships:
        tops = membership.sets[:SETS]
        choices = [(mask * member, weight * chance) for mask, weight in choices for member, chance in tops] or choices
    return choices


def _plural(scene: Scene, view: str, noun: Noun, pools: list[tuple[Array, float]], ranks: list[Rank]) -> Value:
    found = [
        (mask, weight * chance) for pool, chance in pools for mask, weight in _several(scene, view, noun, pool, ranks)
    ]
    found = sorted(found, key=lambda item: -item[1])[:SETS]
    weights = np.zeros(scene.n)
    for mask, weight in found:
        weights = np.maximum(weights, mask * weight)
    return Value("sets", weights, tuple(found), definite=noun.definite, number=noun.number)


def _several(scene: Scene, view: str, noun: Noun, pool: Array, ranks: list[Rank]) -> list[tuple[np.ndarray, float]]:
    """What a plural may mean in a pool: the first so many where they are ranked, else what lies together."""
    ranks = ranks + adjectives(scene, view, noun, pool)
    if ranks and noun.number:
        likely = np.flatnonzero(pool > 0.3 * degrees.peak(pool))
        if len(likely) >= noun.number:
            key = np.asarray(sum(r.key / r.noise for r in ranks))
            order = likely[np.argsort(-key[likely], kind="stable")][: noun.number]
            mask = np.zeros(scene.n, dtype=bool)
            mask[order] = True
            return [(mask, float(pool[order].mean()))]
    return sets.collected(scene, pool, noun.number, noun.universal)
