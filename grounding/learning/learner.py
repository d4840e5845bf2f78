"""From annotated examples to a model: the factors of all families, and those of the first pass."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from grounding.factors import FactorModel, train
from grounding.features.discretiser import strictness
from grounding.learning.examples import PROPOSED, Annotated, Negatives, collect
from grounding.learning.first_pass import learn_first_pass

FIRST_PASS = "first pass"


def learn(
    examples: Iterable[Annotated],
    penalty: float = 1.0,
    progress: Callable[[str], None] | None = None,
    notes: Mapping[str, object] | None = None,
    negatives: Negatives = PROPOSED,
) -> FactorModel:
    """Train all factors.

    Args:
        examples: annotated trees.
        penalty: strength of the L2 regularisation.
        progress: told the name of every family when its turn comes, and `FIRST_PASS` when that of the first pass does.
        notes: kept with the weights.
        negatives: which symbols are negatives beside those that are proposed.
    """
    known = list(examples)
    sets, coverage = collect(known, negatives)
    factors = {}
    for name, data in sets.items():
        if progress is not None:
            progress(name)
        factors[name] = train(data, penalty, strictness=strictness)
    if progress is not None:
        progress(FIRST_PASS)
    first_pass = learn_first_pass(known, penalty)
    counts = {name: f"{coverage.proposed[name]} of {n}" for name, n in sorted(coverage.annotated.items())}
    about = {"penalty": penalty, "annotated symbols proposed": counts, **(notes or {})}
    return FactorModel(factors, about, first_pass)
