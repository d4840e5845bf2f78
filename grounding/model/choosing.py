"""How well every object is the one that ranks ask for: the third from the left, the nearest, the middle one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from grounding.lexicon import place, rank, size
from grounding.lexicon.degrees import peak
from grounding.lexicon.parameters import value
from grounding.lexicon.person import distance_from
from grounding.meaning.referents import Condition, Referent
from grounding.model.holding import Evaluates
from grounding.model.relating import distance_to, lane
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

_ALIKE = 0.03  # sizes that are hard to tell apart [edges]
_ABOVE = 40.0  # [1] where height counts, it counts so many times more than distance


class Order(NamedTuple):
    """Something by which objects are ranked.

    Attributes:
        name: of the family, for features.
        key: larger comes first, shape (n,).
        rank: the place in the order, or None where an ordinal may tell it.
        noise: differences of the key that are hard to see.
        height: what orders within a stack instead: 1 from its top, -1 from its bottom, 0 for the key.
    """

    name: str
    key: Array
    rank: int | None
    noise: float
    height: int = 0


class Ranked(NamedTuple):
    """How well every object has the rank that was asked for.

    Attributes:
        name: of the family, for features.
        truth: shape (n,), in [0, 1].
        first: whether the first of an order is meant.
    """

    name: str
    truth: Array
    first: bool


class Pool(NamedTuple):
    """Those among which is chosen.

    Attributes:
        weights: how well every object belongs to them, shape (n,), at most 1.
        kinds: of arrangement that they are.
        chosen: whether words chose them.
        in_stack: whether they are a stack.
    """

    weights: Array
    kinds: tuple[str, ...] = ()
    chosen: bool = False
    in_stack: bool = False


def choose(evaluator: Evaluates, conditions: Sequence[Condition], pool: Pool, base: Array) -> list[Ranked]:
    """How well every object has the ranks that conditions ask for.

    Args:
        evaluator: of a scene.
        conditions: of a referent in the singular; those that do not rank are looked at for what ordinals count.
        pool: of those among which is chosen.
        base: how well every object is of the kind that is spoken of, shape (n,).
    """
    scene = evaluator.scene
    orders = orders_of(evaluator, conditions, pool, base)
    ordinals = [c.rank or 1 for c in conditions if c.concept == "ordinal"]
    found: list[Ranked] = []
    if ordinals and not any(order.rank is None for order in orders):
        if not orders:
            index = ordinals.pop(0)
            off = rank.counted_off(scene, evaluator.view, pool.weights, index, pool.kinds)
            found.append(Ranked("ordinal", off, index == 1))
        ordinals = []
    coarse = 1.0 if len(orders) < 2 else value("rank.joint")
    for order, index in _indexed(conditions, orders, ordinals):
        found.append(_placed(scene, order, pool, index, coarse))
    if any(c.concept == "middle" for c in conditions):
        middle = rank.middle(scene, pool.weights, chosen=pool.chosen)
        found.append(Ranked("middle", middle, True))
    return found


def _indexed(
    conditions: Sequence[Condition], orders: Sequence[Order], ordinals: Sequence[int]
) -> list[tuple[Order, int]]:
    """Orders with the ranks that are asked for; an ordinal tells the rank of what is named right before it.

    "The second farthest block that is nearest to the tower" is the second by distance, not by nearness to the tower.
    """
    counted = next((place for place, c in enumerate(conditions) if c.concept == "ordinal"), 0)
    own = counted > 0 and conditions[counted - 1].ranks and conditions[counted - 1].rank is None
    free = [order for order in orders if order.rank is None]
    ranks = dict(zip(map(id, free[::-1] if own else free), ordinals, strict=False))
    return [(order, order.rank or ranks.get(id(order), 1)) for order in orders]


def _placed(scene: Scene, order: Order, pool: Pool, index: int, coarse: float) -> Ranked:
    noise = order.noise * (coarse if index == 1 else 1.0)
    key = order.height * scene.z if pool.in_stack and order.height else order.key
    held = rank.truth(pool.weights, key, index, noise)
    if order.height > 0 and index == 1 and not pool.in_stack and _uneven(scene, pool.weights):
        highest = rank.truth(pool.weights, key + _ABOVE * scene.z, index, noise)
        held = (1 - value("rank.highest")) * held + value("rank.highest") * highest
    return Ranked(order.name, held, index == 1)


def orders_of(
    evaluator: Evaluates, conditions: Sequence[Condition], pool: Pool, base: Array, *, several: bool = False
) -> list[Order]:
    """What conditions rank by.

    Args:
        evaluator: of a scene.
        conditions: of a referent.
        pool: of those among which is chosen.
        base: how well every object is of the kind that is spoken of, shape (n,).
        several: whether so many are spoken of: "the three on the right".
    """
    orders: list[Order] = []
    counted = several or is_counted_from(conditions)
    for condition in conditions:
        if condition.concept == "extreme" and not condition.negated:
            orders += _extremes(evaluator, condition, pool)
        elif condition.concept in ("nearest", "farthest") and not condition.negated:
            orders.append(_by_distance(evaluator, condition, base))
        elif condition.concept == "size" and not condition.negated and size.vary(evaluator.scene):
            key = (condition.number or 1.0) * size.measure(evaluator.scene, condition.said)
            orders.append(Order("size", key, condition.rank, _ALIKE * evaluator.scene.edge))
        elif counted and counts_from(condition):
            orders += _extremes(evaluator, condition, pool)
        elif condition.concept == "toward" and counted and not condition.negated:
            key = lane(evaluator, condition, base)[1]
            orders.append(Order("lane", key, None, rank.blur(evaluator.scene)))
    return orders


def is_counted_from(conditions: Sequence[Condition]) -> bool:
    """Whether an ordinal counts from places and along directions that are said: nothing else tells an order."""
    told = any(c.ranks and c.rank is None and c.concept not in ("ordinal", "middle", "size") for c in conditions)
    return any(c.concept == "ordinal" for c in conditions) and not told


def counts_from(condition: Condition) -> bool:
    """Whether an ordinal counts from a place: "the first block on the left" is the first from there."""
    region = condition.region
    bare = region is not None and len(region.names) == 1 and not (region.middle or region.corner or region.rim)
    return condition.concept == "at" and bare and not condition.negated


def _extremes(evaluator: Evaluates, condition: Condition, pool: Pool) -> list[Order]:
    scene, region = evaluator.scene, condition.region
    assert region is not None
    noise, names = rank.blur(scene), list(region.names)
    orders: list[Order] = []
    if pool.in_stack or (not pool.chosen and _upright(scene, pool.weights)):
        for name, sign in (("up", 1.0), ("down", -1.0)):
            if name in names and (pool.in_stack or len(names) == 1):
                orders.append(Order("height", sign * scene.z, condition.rank, noise))
                names.remove(name)
    if names or region.middle or not orders:
        spot = place.make_spot(scene, tuple(names), region.owner or evaluator.view, middle=region.middle,
                               corner=len(names) > 1 or region.corner)  # fmt: skip
        highest = 1 if names == ["up"] and not region.middle and not pool.chosen else 0
        height = spot.upright if not region.bare or pool.in_stack else highest
        orders.append(Order(_family(names, region.middle), place.closeness(scene, spot), condition.rank, noise, height))
    return orders


def _family(names: Sequence[str], middle: bool) -> str:
    """A name for what an order is by, for features."""
    if middle or not names:
        return "point"
    if len(names) > 1:
        return "corner"
    return "side" if names[0] in ("left", "right") else "depth"


def _by_distance(evaluator: Evaluates, condition: Condition, base: Array) -> Order:
    scene = evaluator.scene
    sign = 1.0 if condition.concept == "nearest" else -1.0
    reference = condition.of[0]
    noise = rank.blur(scene)
    if reference.person is not None:
        return Order(f"{condition.concept}.person", -sign * distance_from(scene, reference.person), condition.rank,
                     noise)  # fmt: skip
    found = evaluator.denote(reference, base)
    if found.spot is not None and not found.weights.any():
        return Order(f"{condition.concept}.place", sign * place.closeness(scene, found.spot), condition.rank, noise)
    key = -sign * distance_to(evaluator, found, definite=reference.definite)
    return Order(f"{condition.concept}.thing", key, condition.rank, noise)


def first_of(orders: Sequence[Order], weights: Array, number: int) -> np.ndarray | None:
    """The first so many by orders among likely objects, boolean (n,); None where there are fewer."""
    likely = np.flatnonzero(weights > 0.3 * peak(weights))
    if not orders or len(likely) < number:
        return None
    key = np.asarray(sum(order.key / order.noise for order in orders))
    mask = np.zeros(len(weights), dtype=bool)
    mask[likely[np.argsort(-key[likely], kind="stable")][:number]] = True
    return mask


def _upright(scene: Scene, weights: Array) -> bool:
    """Whether all that is likely belongs to stacks."""
    likely = weights > 0.5 * peak(weights)
    return bool(likely.any()) and bool(scene.stacked[likely].all())


def _uneven(scene: Scene, weights: Array) -> bool:
    """Whether something likely lies on something, and colours tell things apart; else people speak of places."""
    lying = scene.stacked & scene.clear & (weights > 0.3 * peak(weights))
    return len(scene.layout.colors) > 1 and bool(lying.any())


def ranks_of(referent: Referent) -> bool:
    """Whether a referent ranks by anything."""
    return any(condition.ranks for condition in referent.conditions)


__all__ = ["ROBOT", "Order", "Pool", "Ranked", "choose", "first_of", "orders_of", "ranks_of"]
