"""What arrangements may be: rows, columns, groups and towers, as wholes restricted and ranked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.lexicon import arrangement, person, rank
from grounding.lexicon.degrees import peak
from grounding.lexicon.parameters import value
from grounding.meaning.referents import Condition, Referent
from grounding.model.cases import Case
from grounding.model.choosing import Order, Pool, Ranked, orders_of
from grounding.model.features import add_held, add_rank
from grounding.model.holding import SETS as TRIED
from grounding.model.holding import Evaluates, Held
from grounding.model.restricting import base_of, restricted
from grounding.model.things import set_case
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

_ENDS = {"row": {"up": 0, "back": 0, "down": -1, "front": -1}, "column": {"left": 0, "right": -1}}


def arrangement_cases(evaluator: Evaluates, referent: Referent) -> list[Case]:
    """All that a noun of an arrangement may mean."""
    scene, conditions = evaluator.scene, referent.conditions
    stuff = base_of(scene, conditions) > 0.5
    number = None if referent.plural else referent.number
    colours = tuple(word for c in conditions if c.concept == "colour" and not c.negated for word in c.words)
    found = evaluator.arrangements(referent.kinds, stuff, number, colours)
    lines = _counted_lines(scene, referent, stuff) if referent.number is None else []
    cases = []
    if referent.plural:
        wholes = arrangement.together(found, referent.number)
        cases += [_case(evaluator, referent, wholes, None, counted=False)] if wholes else []
    if lines:
        cases.append(_case(evaluator, referent, lines, number, counted=True))
    if found:
        cases.append(_case(evaluator, referent, found, number, counted=False))
    return cases


def _case(
    evaluator: Evaluates, referent: Referent, found: Sequence[arrangement.Candidate], number: int | None, *,
    counted: bool,
) -> Case:  # fmt: skip
    """Arrangements restricted and ranked as wholes, each standing at the mean of its members."""
    scene = evaluator.scene
    everything = np.ones(scene.n)
    case = set_case(Case(scene.n, everything.copy()), found, number)
    assert case.masks is not None
    case.truth = case.truth * np.array([candidate.looks for candidate in found])
    shadow = arrangement.overshadowed(found)
    case.add("shadow", shadow)
    case.add("shadowed", -(shadow < 0).astype(float))
    shares = case.masks / np.maximum(case.masks.sum(axis=1, keepdims=True), 1)
    modifying = [c for c in referent.conditions if c.concept not in ("colour", "kind")]
    for condition in modifying:
        if condition.restricts:
            both = _held(evaluator, condition, shares)
            add_held(case, condition, both, ranked=any(c.ranks for c in modifying))
            case.truth = case.truth * both.truth
        elif condition.chooses:
            inside = _inside(evaluator, condition, shares)
            add_held(case, condition, Held(inside, np.ones(len(found))), ranked=False)
            case.truth = case.truth * inside
    if counted:
        case.note("counted")
    else:
        _rank(evaluator, case, shares, modifying)
    return case


def _held(evaluator: Evaluates, condition: Condition, shares: Array) -> Held:
    """How well a condition holds of sets: of their members in the mean, or of where they are as wholes."""
    scene = evaluator.scene
    if condition.concept == "before" and {"front", "back"} & set(condition.words) and not condition.negated:
        owner = condition.of[0].person or ROBOT
        return Held(np.ones(len(shares)), person.before(scene, owner, shares @ scene.xy))
    held = restricted(evaluator, condition, np.ones(scene.n))
    return Held(shares @ held.truth, np.clip(shares @ held.preference, 0.0, 1.0))


def _inside(evaluator: Evaluates, condition: Condition, shares: Array) -> Array:
    sets = evaluator.denote(condition.of[0]).sets[:TRIED]
    total = np.zeros(len(shares))
    for mask, chance in sets:
        total = total + chance * (shares @ mask)
    return np.minimum(total, 1.0)


def _rank(evaluator: Evaluates, case: Case, shares: Array, modifying: Sequence[Condition]) -> None:
    """Add how well every arrangement has the ranks that are asked for."""
    scene = evaluator.scene
    assert case.masks is not None
    orders = orders_of(evaluator, modifying, Pool(np.ones(scene.n), chosen=True), np.ones(scene.n))
    ordinals = [c.rank or 1 for c in modifying if c.concept == "ordinal"]
    size = next((c.number for c in modifying if c.concept == "size"), None)
    if any(c.concept == "middle" for c in modifying):
        away = -np.linalg.norm(scene.xy - scene.box[0], axis=1)
        orders.append(Order("middle", away, None, 0.5 * scene.edge))
    if ordinals and not orders and size is None:
        name = "left"
        orders.append(Order("ordinal", scene.xy @ scene.direction(name, evaluator.view), None, rank.blur(scene)))
    weights = np.clip(case.truth / peak(case.truth), 0.0, 1.0)
    for order in orders:
        index = order.rank or (ordinals.pop(0) if ordinals else 1)
        held = _ranked(case.masks, weights, shares @ order.key, index, order.noise)
        add_rank(case, Ranked(f"set.{order.name}", held, index == 1))
        case.truth = case.truth * held
    if size is not None:
        index = ordinals.pop(0) if ordinals else 1
        held = _ranked(case.masks, weights, size * case.masks.sum(axis=1), index, 0.3)
        add_rank(case, Ranked("set.size", held, index == 1))
        case.truth = case.truth * held


def _ranked(masks: np.ndarray, weights: Array, key: Array, index: int, noise: float) -> Array:
    """Rank sets; those that share members do not compete for a place, the likelier one stands for them."""
    masks = masks.astype(float)
    keep = np.ones(len(weights), dtype=bool)
    order = np.argsort(-weights, kind="stable")
    for place, i in enumerate(order):
        keep[i] = not any(keep[j] and (masks[i] * masks[j]).any() for j in order[:place])
    ranked = rank.truth(weights * keep, key, index, noise)
    for i in np.flatnonzero(~keep):
        rival = weights * keep * ~((masks @ masks[i]) > 0)
        rival[i] = weights[i]
        ranked[i] = 0.6 * rank.truth(rival, key, index, noise)[i]
    return np.asarray(ranked)


def _counted_lines(scene: Scene, referent: Referent, stuff: np.ndarray) -> list[arrangement.Candidate]:
    """The "third row", the "last column", the "top row" of all rows that the table is parted into."""
    kind = next((kind for kind in _ENDS if kind in referent.kinds), None)
    regions = [c.region for c in referent.conditions if c.concept == "extreme" and c.region is not None]
    names = [name for region in regions for name in region.names]
    if kind is None or "diagonal" in referent.kinds or len(names) > 1:
        return []
    ends = [_ENDS[kind][name] for name in names if name in _ENDS[kind]] or _by_person(scene, referent, kind)
    ordinals = _ordinals(referent)
    middle = any(c.concept == "middle" for c in referent.conditions)
    if not (ordinals or ends or middle):
        return []
    found: dict[bytes, arrangement.Candidate] = {}
    for gap in arrangement.GAPS:
        parts = arrangement.partition(scene, stuff, kind, gap)
        index = ordinals[0] - 1 if ordinals and ordinals[0] > 0 else -1
        if ends:
            index = ends[0] if not ordinals else index if ends[0] == 0 else -1 - index
        elif middle:
            index = len(parts) // 2
        if -len(parts) <= index < len(parts):
            key = parts[index].tobytes()
            before = found[key].looks if key in found else 0.0
            looks = before + 1.0 / len(arrangement.GAPS)
            found[key] = arrangement.Candidate(parts[index], looks, "counted")
    return sorted(found.values(), key=lambda candidate: -candidate.looks)


def _by_person(scene: Scene, referent: Referent, kind: str) -> list[int]:
    """The end from which rows are counted by how far they are from somebody: "the second nearest row"."""
    for condition in referent.conditions:
        person_of = condition.of[0].person if condition.of else None
        if kind == "row" and condition.concept in ("nearest", "farthest") and person_of is not None:
            front = scene.direction("front", person_of)[0] < 0.0
            return [-1 if front == (condition.concept == "nearest") else 0]
    return []


def _ordinals(referent: Referent) -> list[int]:
    """The ranks that are said of lines, those by distance from somebody as well: "second closest to you"."""
    return [c.rank or 1 for c in referent.conditions if c.concept == "ordinal" or (
        c.rank is not None and c.concept in ("nearest", "farthest"))]  # fmt: skip


def conjoined_cases(evaluator: Evaluates, referent: Referent) -> list[Case]:
    """What things joined with "and" may be: one of each, or where lines meet."""
    scene = evaluator.scene
    parts = [_likeliest(evaluator, part) for part in referent.parts]
    found: list[tuple[np.ndarray, float]] = [(np.zeros(scene.n, dtype=bool), 1.0)]
    for number, options in enumerate(parts):
        joined = []
        for mask, chance in found:
            for other, likely in options:
                crossing = referent.crossing and number > 0
                together = mask & other if crossing else mask | other
                if together.any() and (crossing or not (mask & other).any()):
                    apart = value("arrangement.apart") if scene.towers and not scene.in_one_tower(together) else 1.0
                    joined.append((together, chance * likely * apart))
        found = sorted(joined, key=lambda item: -item[1])[: 2 * TRIED]
    if not found:
        return []
    chances = np.array([max(chance, 1e-4) for _, chance in found])
    case = Case(len(found), np.ones(len(found)), np.array([mask for mask, _ in found]))
    case.add("set", np.log(chances))
    return [case]


def _likeliest(evaluator: Evaluates, part: Referent) -> list[tuple[np.ndarray, float]]:
    found = evaluator.denote(part)
    if found.sets:
        return list(found.sets[:4])
    order = np.argsort(-found.weights)[:4]
    singles = np.eye(evaluator.scene.n, dtype=bool)
    return [(singles[i], float(found.weights[i])) for i in order if found.weights[i] > value("answer.floor")]
