"""Hypotheses on what phrases are grounded to, and the k best sets of independent binary correspondences."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from grounding.language.tree import Phrase
from grounding.symbols import Symbol

T = TypeVar("T")
_DECIDED = 40.0  # log odds beyond which a variable's uncertainty, 4e-18, is lost in the sum


@dataclass(frozen=True)
class Hypothesis:
    """One way to ground a phrase and everything below it.

    Attributes:
        symbols: the symbols whose correspondence with the phrase is true.
        log_probability: of this phrase's correspondences and all below.
        children: the hypotheses of the child phrases, in the order of `phrase.phrases`.
        probabilities: of every symbol that was judged likely enough to be looked at, whether true here or not.
    """

    symbols: frozenset[Symbol]
    log_probability: float
    children: tuple[Hypothesis, ...] = ()
    probabilities: Mapping[Symbol, float] = field(default_factory=dict, compare=False, repr=False)


@dataclass(frozen=True)
class Inference:
    """What inference found for one tree.

    Attributes:
        tree: the phrases.
        hypotheses: for the root, the likeliest first.
        evaluations: how many factors were evaluated.
        symbols: how many symbols were considered, over all phrases.
        sizes: the same by family: the sizes of the spaces that were searched.
    """

    tree: Phrase
    hypotheses: tuple[Hypothesis, ...]
    evaluations: int
    symbols: int
    sizes: Mapping[str, int] = field(default_factory=dict)


def aligned(phrase: Phrase, hypothesis: Hypothesis) -> Iterator[tuple[Phrase, Hypothesis]]:
    """Every phrase with its part of a hypothesis, parents before children."""
    yield phrase, hypothesis
    for child, part in zip(phrase.phrases, hypothesis.children, strict=True):
        yield from aligned(child, part)


def best_sets(
    log_odds: Sequence[float], count: int, least: float = math.log(1e-3)
) -> list[tuple[frozenset[int], float]]:
    """The likeliest truth assignments of independent binary variables.

    Args:
        log_odds: of each variable being true.
        count: how many assignments at most.
        least: assignments less likely than the best by more than this (in log) are left out.

    Returns:
        (indices of the true variables, log probability), the likeliest first. Assignments differ from the best one by
        flips, each of which costs the variable's absolute log odds.
    """
    base = frozenset([i for i, odds in enumerate(log_odds) if odds > 0])
    best = -sum([math.log1p(math.exp(-abs(odds))) for odds in log_odds if -_DECIDED < odds < _DECIDED])
    if count == 1:
        return [(base, best)]
    cheap = sorted([(abs(odds), i) for i, odds in enumerate(log_odds) if least <= odds <= -least])
    found = [(base, best)]
    heap: list[tuple[float, int, tuple[int, ...]]] = [(cheap[0][0], 0, (0,))] if cheap else []
    while heap and len(found) < count:
        cost, last, places = heapq.heappop(heap)
        if cost > -least:
            break
        flipped = frozenset(cheap[place][1] for place in places)
        found.append((base ^ flipped, best - cost))
        if last + 1 < len(cheap):
            heapq.heappush(heap, (cost + cheap[last + 1][0], last + 1, (*places, last + 1)))
            heapq.heappush(heap, (cost - cheap[last][0] + cheap[last + 1][0], last + 1, (*places[:-1], last + 1)))
    return found


def best_combinations(lists: Sequence[Sequence[Hypothesis]], count: int) -> list[tuple[Hypothesis, ...]]:
    """The likeliest ways to take one hypothesis from each list, the likeliest first."""
    combined: list[tuple[float, tuple[Hypothesis, ...]]] = [(0.0, ())]
    for hypotheses in lists:
        longer = [(score + h.log_probability, (*taken, h)) for score, taken in combined for h in hypotheses]
        longer.sort(key=lambda item: -item[0])
        combined = longer[:count]
    return [taken for _, taken in combined]
