"""The names and values of features: log truth, log preference and rank of every condition, with bins."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.parameters import value
from grounding.meaning.referents import Condition
from grounding.model.cases import Case
from grounding.model.choosing import Ranked
from grounding.model.holding import Held
from grounding.world import Array

BINS = (0.15, 0.5)
"""Below these degrees a condition holds hardly, or rather not."""


def logarithm(degrees: Array) -> Array:
    """The logarithm of degrees in [0, 1], not below that of `answer.floor`."""
    return np.asarray(np.log(np.maximum(degrees, value("answer.floor"))))


def family(condition: Condition) -> str:
    """The family of a condition, for features."""
    name = condition.concept
    if condition.concept == "toward" and condition.strict:
        name = "toward.strict"
    elif condition.concept == "relation":
        name = f"relation.{condition.words[0]}"
    elif condition.concept == "same" and condition.said:
        name = f"same.{condition.said}"
    elif condition.concept == "at" and condition.region is not None:
        region = condition.region
        shape = "corner" if region.corner or len(region.names) > 1 else "middle" if region.middle else "side"
        name = f"at.{'rim' if region.rim and not region.names else shape}"
    elif condition.concept == "before":
        name = "before" if {"front", "back"} & set(condition.words) else "before.side"
    return f"not.{name}" if condition.negated else name


def add_held(case: Case, condition: Condition, held: Held, *, ranked: bool) -> None:
    """Add what a condition that restricts says of every candidate.

    Args:
        case: to which is added.
        condition: of the referent.
        held: how well it holds.
        ranked: whether the referent ranks as well, so that preferences say little.
    """
    name, truth, preference = family(condition), logarithm(held.truth), logarithm(held.preference)
    case.add(f"T.{name}", truth)
    if condition.said and condition.of:
        case.add(f"T.{name}:{condition.said}", truth)
    for limit in BINS:
        below = (held.truth < limit).astype(float)
        case.add(f"T<{limit}", below)
        case.add(f"T.{name}<{limit}", below)
    suffix = ".ranked" if ranked else ""
    if np.any(preference != 0):
        case.add(f"P.{name}{suffix}", preference)
    together = held.truth * held.preference
    best = float((together * (case.truth > 0.3)).max(initial=0.0)) or float(together.max(initial=1e-9))
    case.add(f"best.{name}{suffix}", logarithm(np.minimum(together / max(best, 1e-9), 1.0)))


def add_rank(case: Case, ranked: Ranked) -> None:
    """Add how well every candidate has a rank."""
    name = ranked.name if ranked.first else f"{ranked.name}.nth"
    column = logarithm(ranked.truth)
    case.add(f"R.{name}", column)
    for limit in BINS:
        below = (ranked.truth < limit).astype(float)
        case.add(f"R<{limit}", below)
        case.add(f"R.{name}<{limit}", below)
