"""What a noun of things may mean: restrictors make a pool before ranks choose within it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from grounding.lexicon import arrangement, rank
from grounding.lexicon.degrees import softened
from grounding.lexicon.parameters import value
from grounding.meaning.referents import SETS, Condition, Referent
from grounding.model.cases import Case, Denotation, Weights
from grounding.model.choosing import Order, Pool, choose, counts_from, first_of, is_counted_from, orders_of
from grounding.model.features import add_held, add_rank, logarithm
from grounding.model.holding import SETS as TRIED
from grounding.model.holding import Evaluates, Held
from grounding.model.relating import lane
from grounding.model.restricting import base_of, restricted
from grounding.symbols import LAST
from grounding.world import Array

_MOST_CASES = 12


@dataclass(eq=False)
class _Choice:
    """One set of every membership, from which is chosen."""

    mask: np.ndarray
    scalars: dict[str, float] = field(default_factory=dict)
    log: float = 0.0


def thing_cases(evaluator: Evaluates, referent: Referent, base: Array | None, *, carrying: bool) -> list[Case]:
    """All that a noun of things may mean.

    Args:
        evaluator: of a scene.
        referent: objects, or several of them.
        base: how well every object is of the kind of what the referent modifies, shape (n,), or None.
        carrying: whether it is spoken of because of what it carries.
    """
    scene, conditions = evaluator.scene, referent.conditions
    kind = base_of(scene, conditions) * (1.0 if base is None else base)
    counted = is_counted(referent)
    held = [(c, _held(evaluator, c, kind, counted=counted)) for c in conditions if c.restricts]
    choices = _choices(evaluator, conditions, kind)
    cases = []
    for choice in sorted(choices, key=lambda c: -c.log)[:_MOST_CASES]:
        truth = np.ones(scene.n) if base is None else base.copy()
        for _, found in held:
            truth = truth * softened(found.truth)
        pool = truth * np.where(choice.mask, 1.0, value("answer.floor"))
        case = Case(scene.n, pool.copy())
        case.scalars.update(choice.scalars)
        ranked = any(c.ranks for c in conditions)
        if base is not None:
            case.add("T.like", logarithm(base))
        for condition, found in held:
            add_held(case, condition, found, ranked=ranked)
        if choice.scalars:
            case.add("outside", np.where(choice.mask, 0.0, logarithm(np.zeros(1))[0]))
        if referent.sort == SETS:
            cases += _several(evaluator, referent, case, pool, kind)
        else:
            cases.append(_one(evaluator, referent, case, pool, kind, choice, carrying=carrying))
    return cases


def is_counted(referent: Referent) -> bool:
    """Whether objects are counted along what is said: "the third on the left", "the three on the left"."""
    return is_counted_from(referent.conditions) or (referent.plural and referent.number is not None)


def _held(evaluator: Evaluates, condition: Condition, kind: Array, *, counted: bool) -> Held:
    """How well a condition holds; where an ordinal counts along it, distance does not speak against."""
    if counted and counts_from(condition):
        return Held(np.ones(evaluator.scene.n), np.ones(evaluator.scene.n))
    if counted and condition.concept == "toward" and not condition.negated:
        return Held(lane(evaluator, condition, kind)[0], np.ones(evaluator.scene.n))
    return restricted(evaluator, condition, kind)


def _choices(evaluator: Evaluates, conditions: Sequence[Condition], kind: Array) -> list[_Choice]:
    """What lies in one set of every membership."""
    found = [_Choice(np.ones(evaluator.scene.n, dtype=bool))]
    for condition in conditions:
        if condition.chooses:
            options = _sets(evaluator, condition, kind) or [_Choice(found[0].mask, {"set.none": 1.0})]
            found = [
                _Choice(one.mask & option.mask, _summed(one.scalars, option.scalars), one.log + option.log)
                for one in found for option in options
            ]  # fmt: skip
    return found


def _summed(one: dict[str, float], other: dict[str, float]) -> dict[str, float]:
    return {name: one.get(name, 0.0) + other.get(name, 0.0) for name in {**one, **other}}


def _sets(evaluator: Evaluates, condition: Condition, kind: Array) -> list[_Choice]:
    """The sets that a membership may mean, with all that speaks for them."""
    reference = condition.of[0]
    name = f"set.{condition.concept}"
    denoted = evaluator.denote(reference, kind)
    found: list[_Choice] = []
    if denoted.sets:
        for mask, row, case, score in best_sets(denoted, evaluator.weights):
            found.append(_Choice(mask, _summed({name: 1.0}, case.features(row)), score))
        top = max((choice.log for choice in found), default=0.0)
        for choice in found:
            choice.log -= top
    elif denoted.likely.any():
        found.append(_Choice(denoted.likely, {name: 1.0}))
    if condition.concept == "those":  # who speaks of several and then of one mostly means one of them
        found.append(_Choice(np.ones(len(kind), dtype=bool), {"outside.those": 1.0}, -3.0))
    return found


def best_sets(
    denoted: Denotation, weights: Weights
) -> list[tuple[np.ndarray, int, Case, float]]:
    """The likeliest sets that a referent may mean, each with its case, its place there and its score."""
    found: dict[bytes, tuple[np.ndarray, int, Case, float]] = {}
    for case in denoted.cases:
        scores = case.scores(weights)
        for row in range(case.size):
            mask = case.masks[row] if case.masks is not None else np.zeros(0, dtype=bool)
            key = mask.tobytes()
            if mask.any() and (key not in found or found[key][3] < scores[row]):
                found[key] = (mask, row, case, float(scores[row]))
    return sorted(found.values(), key=lambda item: -item[3])[:TRIED]


def _one(
    evaluator: Evaluates, referent: Referent, case: Case, pool: Array, kind: Array, choice: _Choice, *, carrying: bool
) -> Case:
    scene, conditions = evaluator.scene, referent.conditions
    chosen = bool(choice.scalars)
    in_stack = chosen and bool(choice.mask.any()) and bool(scene.stacked[choice.mask].all())
    kinds = tuple(k for c in conditions if c.chooses for k in c.of[0].kinds)
    vertical = any(_is_vertical(c) for c in conditions)
    salient = pool * scene.salience if not (in_stack or vertical or carrying) else pool
    for ranked in choose(evaluator, conditions, Pool(salient, kinds, chosen, in_stack), kind):
        add_rank(case, ranked)
        case.truth = case.truth * ranked.truth
    name = ".carrying" if carrying else ".within" if in_stack else ".vertical" if vertical else ""
    case.add("buried" + name, (~scene.clear).astype(float))
    case.add("stacked" + name, (scene.stacked & scene.clear).astype(float))
    _presuppose(case, referent, pool, chosen=chosen)
    return case


def _is_vertical(condition: Condition) -> bool:
    """Whether a condition tells where something is in a stack, so that it may carry others."""
    if condition.region is not None and {"up", "down"} & set(condition.region.names):
        return True
    return condition.concept in ("centre", "part") and condition.of[-1].kinds[:1] == ("tower",)


def _presuppose(case: Case, referent: Referent, pool: Array, *, chosen: bool) -> None:
    """Note how well a set of so many members fits a noun that chooses among them."""
    count = int((pool > 0.3).sum())
    ranking = any(c.ranks for c in referent.conditions)
    if referent.only:
        case.note("only", -abs(count - 1.0))
    if any(c.concept == "ordinal" for c in referent.conditions) and count < 2:
        case.note("ordinal.one")
    if referent.definite and not ranking:
        name = "sole.chosen" if chosen else "sole"
        case.note(name, -float(min(max(count - 1, 0), 4)))
    if not count:
        case.note("empty")


def _several(evaluator: Evaluates, referent: Referent, case: Case, pool: Array, kind: Array) -> list[Case]:
    """What a plural may mean in a pool: the first so many where they are ranked, else what lies together."""
    scene = evaluator.scene
    orders: list[Order] = orders_of(
        evaluator, referent.conditions, Pool(pool), kind, several=referent.number is not None
    )
    within = bool(scene.stacked[pool > 0.3].all())  # of a stack every block may be meant
    salient = pool if within else pool * scene.salience
    first = first_of(orders, salient, referent.number) if referent.number else None
    if first is not None:
        found = [arrangement.Candidate(first, 1.0, "ranked")]
    else:
        found = [] if orders else _at_ends(evaluator, referent, salient)
        found = found or arrangement.collected(scene, pool, referent.number, referent.universal)
    return [set_case(case, found, referent.number)] if found else []


def _at_ends(evaluator: Evaluates, referent: Referent, pool: Array) -> list[arrangement.Candidate]:
    """The first or the last so many of a row or a column, where nothing tells from which end is counted."""
    scene, conditions = evaluator.scene, referent.conditions
    which = next((c.rank for c in conditions if c.concept == "ordinal" and c.rank in (1, LAST)), None)
    kinds = {kind for c in conditions if c.chooses for kind in c.of[0].kinds} & {"row", "column"}
    if which is None or not kinds or not referent.number:
        return []
    key = which * (scene.xy @ scene.direction(rank.start(scene, kinds), evaluator.view))
    share, found = value("rank.from_left"), []
    for sign, looks in ((1.0, share), (-1.0, 1.0 - share)):
        mask = first_of([Order("ordinal", sign * key, None, 1.0)], pool, referent.number)
        found += [] if mask is None else [arrangement.Candidate(mask, looks, "ranked")]
    return found


def set_case(case: Case, found: Sequence[arrangement.Candidate], number: int | None) -> Case:
    """A case of objects made one of sets: what holds of a set holds of its members in the mean.

    Args:
        case: of the objects one by one.
        found: the sets.
        number: of members that was said, or None.
    """
    masks = np.array([candidate.mask for candidate in found])
    shares = masks / np.maximum(masks.sum(axis=1, keepdims=True), 1)
    together = Case(len(found), shares @ case.truth, masks, dict(case.scalars))
    for name, column in case.columns.items():
        together.columns[name] = shares @ column
    looks = np.array([candidate.looks for candidate in found])
    together.add("looks", np.log(np.maximum(looks, 1e-3)))
    for form in {candidate.form for candidate in found}:
        together.add(f"form.{form}", np.array([float(candidate.form == form) for candidate in found]))
    if number is not None:
        off = np.abs(masks.sum(axis=1) - number).astype(float)
        together.add("number", -value("arrangement.number") * off)
        together.add("miscounted", -(off > 0).astype(float))
        together.truth = together.truth * np.exp(-value("arrangement.number") * off)
    return together
