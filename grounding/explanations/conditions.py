"""How well every condition of a meaning holds of a candidate, from the features that decided."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping

from grounding.explanations.candidates import Candidate
from grounding.explanations.values import Contribution, Degrees
from grounding.explanations.wording import condition_text
from grounding.lexicon.parameters import value
from grounding.meaning.referents import Condition, Referent
from grounding.model.features import family

TOLD = 1.15  # a condition is told as a reason where the answer has it so many times better
_RANKS: Mapping[str, tuple[str, ...]] = {
    "extreme": ("side", "depth", "point", "corner", "height"), "ordinal": ("ordinal",), "middle": ("middle",),
    "nearest": ("nearest.person", "nearest.place", "nearest.thing"), "size": ("size",),
    "farthest": ("farthest.person", "farthest.place", "farthest.thing"), "at": ("side", "depth"), "toward": ("lane",),
}  # fmt: skip
"""The features of ranks by concepts; "at" and "toward" rank where an ordinal counts along them."""


def degrees_of(condition: Condition, candidate: Candidate) -> Degrees:
    """How well a condition holds of a candidate; conditions of one family in one referent are told together."""
    columns, row = candidate.case.columns, candidate.row
    name = family(condition)

    def degree(*names: str) -> float | None:
        found = [float(columns[one][row]) for one in names if one in columns]
        return math.exp(min(sum(found), 0.0)) if found else None

    truth = degree(f"T.{name}")
    if condition.chooses and truth is None:
        truth = degree("outside")
    preference = degree(f"P.{name}", f"P.{name}.ranked")
    ranks = [one for short in _RANKS.get(condition.concept, ()) for one in (short, f"set.{short}")]
    counts = condition.ranks or (condition.concept in ("at", "toward") and truth in (None, 1.0))
    rank = degree(*(f"R.{one}{end}" for one in ranks for end in ("", ".nth"))) if counts else None
    return Degrees(truth, preference, rank)


def total(degrees: Degrees) -> float | None:
    """The product of degrees, not below what counts as equally untrue; None where nothing was measured."""
    found = [degree for degree in degrees if degree is not None]
    return max(math.prod(found), value("answer.floor")) if found else None


def reasons(
    referent: Referent, answer: Candidate, rival: Candidate, degrees: Callable[[Condition, Candidate], Degrees],
    name: str,
) -> Iterator[Contribution]:  # fmt: skip
    """Conditions that hold less of a rival than of the answer; a weight is log(rival / answer), below 0.

    Args:
        referent: of which both are candidates.
        answer: the one that was taken.
        rival: the other one.
        degrees: of a condition and a candidate.
        name: of the rival.
    """
    told = set()
    for condition in referent.conditions:
        own, other = degrees(condition, answer), degrees(condition, rival)
        good, bad = total(own), total(other)
        said = condition_text(condition)
        if good is None or bad is None or bad * TOLD > good or said in told:
            continue
        told.add(said)
        if condition.concept == "colour" and bad < 0.2:
            text = f"{name} is not {said}"
        else:
            text = f'{name} agrees less with "{said}" ({bad:.2f} against {good:.2f})'
        yield Contribution(text, math.log(bad / good))


def peaks(referent: Referent, candidates: list[Candidate]) -> Iterator[tuple[Condition, float]]:
    """How well every condition holds of what it holds of best among all candidates."""
    for condition in referent.conditions:
        found = [degrees_of(condition, candidate).truth for candidate in candidates]
        known = [truth for truth in found if truth is not None]
        if known:
            yield condition, max(known)
