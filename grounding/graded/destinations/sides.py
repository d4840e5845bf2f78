"""Parts of the table as places to put things: sides, corners, the middle."""

from __future__ import annotations

import numpy as np

from grounding.graded.destinations.clues import Clue
from grounding.graded.destinations.maps import Shift, gaussian
from grounding.graded.destinations.places import PITCH, Plan
from grounding.graded.reader import Reader
from grounding.graded.scene import SLANT
from grounding.world import Array

OUT = 0.68  # how far out sides and corners are, of the way from the middle to the edge
ALONG = 0.16  # width along what is named, of the half extent
ACROSS = 0.6  # width across it


def _target(clue: Clue, plan: Plan, reader: Reader) -> tuple[Array, Array]:
    """Middle and widths of a part of the table, each of shape (2,), in edges."""
    noun = clue.nouns[0]
    flat = dict.fromkeys({"up": "back", "down": "front"}.get(name, name) for name in noun.directions)
    vector = np.zeros(2)
    for name in flat:
        vector += np.round(plan.axes @ reader.scene.direction(name, noun.agent or reader.view))
    vector = np.clip(vector, -1, 1)
    seen = np.array([0.0, -SLANT if vector[1] == 0 else 0.0])  # the middle of the picture is nearer than the table's
    centre = plan.centre + (vector * OUT + seen) * plan.half
    named = np.abs(vector) > 0.5
    free = ~named & bool(flat) & (not noun.middle)
    return np.asarray(centre), np.asarray(np.where(free, ACROSS, ALONG) * plan.half)


def side_points(clue: Clue, shift: Shift, plan: Plan, reader: Reader) -> Array:
    """The point that is meant most, shape (1, 2) in edges."""
    centre, _ = _target(clue, plan, reader)
    sign = shift.steps * PITCH + shift.open * PITCH
    return np.asarray((centre + sign)[None])


def side_map(clue: Clue, shift: Shift, points: Array, plan: Plan, reader: Reader) -> Array:
    """How well points (p, 2) lie in a part of the table."""
    centre, width = _target(clue, plan, reader)
    centre = centre + (shift.steps + shift.open) * PITCH
    return np.asarray(gaussian((points - centre) / width, 1.0).prod(axis=1))
