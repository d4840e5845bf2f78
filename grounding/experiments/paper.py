"""What the paper reports (Paul et al., RSS 2016, Section V): constants that stand beside our own figures."""

from __future__ import annotations

from collections import Counter
from types import MappingProxyType
from typing import NamedTuple

from grounding.corpus.format import Corpus


class Runtime(NamedTuple):
    """One line of Table I.

    Attributes:
        instructions: of the corpus in worlds of this size.
        dcg: seconds a phrase.
        adcg: seconds a phrase.
    """

    instructions: int
    dcg: float
    adcg: float


TABLE_I = MappingProxyType(
    {
        4: Runtime(4, 0.14, 0.007),
        5: Runtime(45, 0.21, 0.009),
        7: Runtime(62, 0.47, 0.010),
        10: Runtime(10, 2.96, 0.010),
        12: Runtime(13, 14.25, 0.011),
    }
)
"""By number of blocks."""

FIGURE_5 = MappingProxyType({"root": ((0.3, 0.781), (0.8, 0.361)), "complete": ((0.2, 0.667), (0.75, 0.228))})
"""The best and the worst accuracy with the holdouts they were reached at: what the text says of the curves."""


def is_papers(corpus: Corpus) -> bool:
    """Whether a corpus has as many instructions in worlds of every size as the paper's."""
    sizes = Counter(len(corpus.worlds[example.world].things) for example in corpus)
    return sizes == {size: line.instructions for size, line in TABLE_I.items()}
