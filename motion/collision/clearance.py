"""Distances that pairs of bodies keep, and pairs that are nearer."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

CLEARANCE = 0.005
"""Distance kept from everything where no contact is meant, metres."""
CLOSE = 0.0015
"""Distance that the hand keeps from what it must come close to: what its box stands on, or stands next to; metres."""


class Near(NamedTuple):
    """Two bodies that are nearer than allowed.

    Attributes:
        bodies: their names.
        distance: metres; negative is penetration.
        place: where, x, y, z in metres.
    """

    bodies: tuple[str, str]
    distance: float
    place: tuple[float, float, float] = (np.nan, np.nan, np.nan)


@dataclass(frozen=True)
class Rules:
    """Distances that pairs of bodies keep.

    Attributes:
        clearance: distance that all other pairs keep, metres.
        hand_clearance: distance that the moving hand and what it holds keep from boxes, metres.
        touching: names of boxes that the hand may touch.
        resting: names of bodies that the held box may touch.
        close: names of boxes to which the hand, and what it holds, may come as near as `CLOSE`.
    """

    clearance: float = CLEARANCE
    hand_clearance: float = CLEARANCE
    touching: frozenset[str] = field(default_factory=frozenset)
    resting: frozenset[str] = field(default_factory=frozenset)
    close: frozenset[str] = field(default_factory=frozenset)
