"""Nearness and contact: beside something, touching it, apart from it."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.parameters import value
from grounding.world import Array

BESIDE, NEAR, TOUCHING, APART = "nearness.beside", "nearness.near", "nearness.touching", "nearness.apart"
HAVING, AMONG = "nearness.having", "nearness.among"
REACH = "enclosure.reach"


def truth(gaps: Array, edge: float, reach: str = BESIDE) -> Array:
    """How well gaps between boxes count as near: one at contact, one half at a reach.

    Args:
        gaps: of any shape in [m].
        edge: of a block [m].
        reach: the parameter that tells at which gap it half holds.
    """
    return np.asarray(1.0 / (1.0 + (gaps / (value(reach) * edge)) ** value("nearness.sharpness")))
