"""Pools what the factors of the ADCG and the graded readings believe into one probability for every option.

The pool is log-linear: p(o) is proportional to ((g(o) + e) (1 + k l(o)))^a (f(o) + d)^b, with g, l and f the shares of
the graded readings, of the literal one and of the factors. Where a text is unlike what the factors were trained on they
believe in nothing or in the wrong thing, so that their silence is weak evidence: d is large.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

GRADED_POWER = 1.4
GRADED_FLOOR = 0.002
FACTOR_POWER = 0.4
FACTOR_FLOOR = 0.05
FAMILIAR = 16  # texts of more words are unlike those that the factors were learned from
PLAIN = 7  # with every word more than these, more may have been misunderstood as a whole
DOUBT_PER_WORD = 0.012
MOST_DOUBT = 0.15
KIND_WORTH = 0.3  # of what the factors say of the kind of action, beside what the clauses' verbs say

Objects = tuple[str, ...]


@dataclass(frozen=True)
class Pooled:
    """What is believed of one option.

    Attributes:
        objects: ids.
        probability: that these are meant.
        kinds: of action with their shares, the likeliest first.
    """

    objects: Objects
    probability: float
    kinds: tuple[tuple[str, float], ...]


def pool(
    factors: Mapping[tuple[str, Objects], float],
    graded: Sequence[tuple[tuple[str, Objects], float]],
    words: int = 0,
    literal: Sequence[tuple[tuple[str, Objects], float]] = (),
    literal_worth: float = 1.0,
) -> tuple[Pooled, ...]:
    """Pool two beliefs over (action, ids).

    Args:
        factors: shares by the factors; what is missing to 1 is belief in nothing.
        graded: shares by the graded readings; they sum to 1, or are empty.
        literal: shares by the literal reading; they sum to 1, or are empty.
        literal_worth: how many times likelier what holds literally is than what does not.
        words: of the text; what the factors say of long ones counts less, as they multiply what may go wrong.

    Returns:
        the options, the likeliest first; their probabilities sum to 1, less the doubt that a long text leaves.
    """
    names: dict[Objects, tuple[float, float]] = {}
    sharp: dict[Objects, float] = {}
    kinds: dict[Objects, dict[str, float]] = {}
    for source, (entries, worth) in enumerate(((factors.items(), KIND_WORTH), (graded, 1.0))):
        for (kind, objects), share in entries:
            pair = list(names.get(objects, (0.0, 0.0)))
            pair[source] += share
            names[objects] = (pair[0], pair[1])
            of = kinds.setdefault(objects, {})
            of[kind] = of.get(kind, 0.0) + worth * share
    for (kind, objects), share in literal:
        sharp[objects] = sharp.get(objects, 0.0) + share
        names.setdefault(objects, (0.0, 0.0))
        of = kinds.setdefault(objects, {})
        of[kind] = of.get(kind, 0.0) + share
    if not graded and not literal:
        weights = {objects: f for objects, (f, _) in names.items()}
    else:
        power = FACTOR_POWER * min(1.0, FAMILIAR / max(words, 1)) ** 2
        weights = {
            objects: ((g + GRADED_FLOOR) * (1.0 + literal_worth * sharp.get(objects, 0.0))) ** GRADED_POWER
            * (f + FACTOR_FLOOR) ** power
            for objects, (f, g) in names.items()
        }
    total = sum(weights.values())
    if total <= 0:
        return ()
    sure = 1.0 - min(MOST_DOUBT, DOUBT_PER_WORD * max(0, words - PLAIN)) if graded else 1.0
    found = [
        Pooled(
            objects, sure * weight / total, tuple(sorted(kinds[objects].items(), key=lambda item: (-item[1], item[0])))
        )
        for objects, weight in weights.items()
    ]
    return tuple(sorted(found, key=lambda option: (-option.probability, option.objects)))
