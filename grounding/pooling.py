"""Pools what the factors of the ADCG and the graded readings believe into one probability for every option.

The pool is log-linear: p(o) is proportional to (g(o) + e)^a (f(o) + d)^b, with g and f the shares of the graded
readings and of the factors. Where a text is unlike what the factors were trained on they believe in
nothing or in the wrong thing, so that their silence is weak evidence: d is large.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

GRADED_POWER = 1.0
GRADED_FLOOR = 0.002
FACTOR_POWER = 0.5
FACTOR_FLOOR = 0.05

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
    factors: Mapping[tuple[str, Objects], float], graded: Sequence[tuple[tuple[str, Objects], float]]
) -> tuple[Pooled, ...]:
    """Pool two beliefs over (action, ids).

    Args:
        factors: shares by the factors; what is missing to 1 is belief in nothing.
        graded: shares by the graded readings; they sum to 1, or are empty.

    Returns:
        the options, the likeliest first; their probabilities sum to 1.
    """
    names: dict[Objects, tuple[float, float]] = {}
    kinds: dict[Objects, dict[str, float]] = {}
    for source, entries in enumerate((factors.items(), graded)):
        for (kind, objects), share in entries:
            pair = list(names.get(objects, (0.0, 0.0)))
            pair[source] += share
            names[objects] = (pair[0], pair[1])
            of = kinds.setdefault(objects, {})
            of[kind] = of.get(kind, 0.0) + share
    if not graded:
        weights = {objects: f for objects, (f, _) in names.items()}
    else:
        weights = {
            objects: (g + GRADED_FLOOR) ** GRADED_POWER * (f + FACTOR_FLOOR) ** FACTOR_POWER
            for objects, (f, g) in names.items()
        }
    total = sum(weights.values())
    if total <= 0:
        return ()
    found = [
        Pooled(objects, weight / total, tuple(sorted(kinds[objects].items(), key=lambda item: (-item[1], item[0]))))
        for objects, weight in weights.items()
    ]
    return tuple(sorted(found, key=lambda option: (-option.probability, option.objects)))
