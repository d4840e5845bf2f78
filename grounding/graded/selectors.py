"""What selects within a pool: ranks, superlatives, ordinals, the middle one."""

from __future__ import annotations

import numpy as np

from grounding.graded.people import distance_from
from grounding.graded.places import closeness, make_place, middle_one
from grounding.graded.values import Rank
from grounding.lexicon import degrees
from grounding.meaning.nouns import Noun
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

_JOINT = 2.5  # where several ranks select together, each is seen so much less finely
_HIGHEST = 0.15  # how often "the top block" is the highest where some lie on others, and not the farthest
_ABOVE = 40.0  # [1] then height counts so many times more than distance


def choose(
    scene: Scene, view: str, noun: Noun, pool: Array, ranks: list[Rank], kinds: tuple[str, ...], *,
    chosen: bool, in_stack: bool,
) -> Array:  # fmt: skip
    """The one of a pool that a noun and the ranks of its modifiers select.

    Args:
        scene: the world.
        view: whose left is meant where nobody is named.
        noun: in the singular.
        pool: weights (n,) of those among which it is.
        ranks: from modifiers.
        kinds: of arrangement from which is chosen.
        chosen: whether a modifier chose the pool.
        in_stack: whether it is a stack.
    """
    ranks = ranks + adjectives(scene, view, noun, pool, chosen=chosen, in_stack=in_stack)
    ordinals = list(noun.ordinals)
    if ordinals and not any(r.ordinal is None for r in ranks):
        if not ranks:
            return _counted_off(scene, view, pool, ordinals[0], kinds)
        ordinals = []
    weights = pool
    scale = 1.0 if len(ranks) < 2 else _JOINT
    for rank in ranks:
        index = rank.ordinal or (ordinals.pop(0) if ordinals else 1)
        noise = rank.noise * (scale if index == 1 else 1.0)
        key = rank.height * scene.z if in_stack and rank.height else rank.key
        part = degrees.ranked(pool, key, index, noise)
        if rank.height > 0 and index == 1 and not in_stack and _uneven(scene, pool):
            part = (1 - _HIGHEST) * part + _HIGHEST * degrees.ranked(pool, key + _ABOVE * scene.z, index, noise)
        weights = weights * part if len(ranks) > 1 else part
    if noun.middle and not noun.directions:
        weights = middle_one(scene, weights, chosen=chosen)
    return weights


def adjectives(
    scene: Scene, view: str, noun: Noun, pool: Array, *, chosen: bool = False, in_stack: bool = False
) -> list[Rank]:
    """Ranks from words before the head: "nearest", "leftmost", "top left"."""
    ranks = []
    noise = 0.3 * scene.edge
    names = list(noun.directions)
    if in_stack or (not chosen and _upright(scene, pool)):
        for name, sign in (("up", 1.0), ("down", -1.0)):
            if name in names and (in_stack or len(names) == 1):
                ranks.append(Rank(sign * scene.z, None, noise))
                names.remove(name)
    if names or (noun.middle and noun.directions):
        place = make_place(scene, names, noun.agent or view, middle=noun.middle, corner=len(names) > 1, bare=True)
        highest = 1 if names == ["up"] and not noun.middle and not chosen else 0
        ranks.append(Rank(closeness(scene, place), None, noise, height=highest))
    if noun.distance and not (noun.distance == "far" and noun.directions):  # "the farthest left" is the leftmost
        sign = 1.0 if noun.distance == "near" else -1.0
        ranks.append(Rank(-sign * distance_from(scene, noun.agent or ROBOT), None, noise))
    return ranks


def _upright(scene: Scene, pool: Array) -> bool:
    """Whether all that is likely belongs to stacks."""
    likely = pool > 0.5 * degrees.peak(pool)
    return bool(likely.any()) and bool(scene.stacked[likely].all())


def _uneven(scene: Scene, pool: Array) -> bool:
    """Whether something likely lies on something, and colours tell things apart; else people speak of places."""
    lying = scene.stacked & scene.clear & (pool > 0.3 * degrees.peak(pool))
    return len(scene.layout.colors) > 1 and bool(lying.any())


def _counted_off(scene: Scene, view: str, pool: Array, ordinal: int, kinds: tuple[str, ...]) -> Array:
    """An ordinal without a direction: from the left, from the nearest, or from the right."""
    noise = 0.3 * scene.edge
    if "row" in kinds or "column" in kinds:
        key = scene.xy @ scene.direction("left" if "row" in kinds else "back", view)
        return np.asarray(
            0.85 * degrees.ranked(pool, key, ordinal, noise) + 0.15 * degrees.ranked(pool, -key, ordinal, noise)
        )
    spread = scene.xy[pool > 0.3 * pool.max(initial=1e-9)]
    along = np.ptp(spread, axis=0) if len(spread) else np.ones(2)
    sideways = float(along[1] / max(along.sum(), 1e-9))
    left = scene.xy @ scene.direction("left", view)
    near = -np.linalg.norm(scene.xy - scene.viewpoint(ROBOT).position[:2], axis=1)
    return np.asarray(
        0.65 * sideways * degrees.ranked(pool, left, ordinal, noise)
        + 0.15 * sideways * degrees.ranked(pool, -left, ordinal, noise)
        + (1 - 0.8 * sideways) * degrees.ranked(pool, near, ordinal, noise)
    )
