"""Parts of the table as places to put things: sides, corners, the middle."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.degrees import gaussian
from grounding.lexicon.words import is_edge
from grounding.meaning.goal.clues import Clue
from grounding.model.phrases import PhraseReader
from grounding.placing.floor_plan import PITCH, FloorPlan
from grounding.placing.maps import Shift
from grounding.world import Array
from grounding.world.scene import SLANT

OUT = 0.68  # how far out sides and corners are, of the way from the middle to the edge
BORDER = 1.0  # how far what is put at an edge is from it [edges]
ALONG = 0.16  # width along what is named, of the half extent
ACROSS = 0.6  # width across it


_EVERY_CORNER = np.array([[1.0, 1], [1, -1], [-1, 1], [-1, -1]])


def _target(clue: Clue, plan: FloorPlan, reader: PhraseReader) -> tuple[Array, Array]:
    """Middles (m, 2) and widths (2,) of parts of the table in edges: all four where a corner is named by no side."""
    noun = clue.nouns[0]
    out, along = np.full(2, OUT), np.full(2, ALONG)
    if plan.board is not None:
        out, along = 1.0 - 1.0 / plan.board, 0.5 / plan.board
    if noun.place == "corner" and not noun.directions and not noun.middle:
        return np.asarray(plan.centre + _EVERY_CORNER * out * plan.half), np.asarray(along * plan.half)
    flat = dict.fromkeys({"up": "back", "down": "front"}.get(name, name) for name in noun.directions)
    vector = np.zeros(2)
    for name in flat:
        vector += np.round(plan.axes @ reader.scene.direction(name, noun.agent or reader.view))
    vector = np.clip(vector, -1, 1)
    slanted = reader.scene.on_table and vector[1] == 0  # the middle of the picture is nearer than the table's
    seen = np.array([0.0, -SLANT if slanted else 0.0])
    if plan.board is None and any(is_edge(text) for text in noun.text.split()):
        out = 1.0 - BORDER / plan.half
    centre = plan.centre + (vector * out + seen) * plan.half
    named = np.abs(vector) > 0.5
    free = ~named & bool(flat) & (not noun.middle)
    return np.asarray(centre[None]), np.asarray(np.where(free, ACROSS, along) * plan.half)


def _shifted(shift: Shift) -> Array:
    """How far to go from the middle of a part of the table [edges]."""
    return np.asarray(np.where(shift.metric, shift.steps, (shift.steps + shift.open) * PITCH))


def side_points(clue: Clue, shift: Shift, plan: FloorPlan, reader: PhraseReader) -> Array:
    """The points that are meant most, shape (m, 2) in edges."""
    centres, _ = _target(clue, plan, reader)
    return np.asarray(centres + _shifted(shift))


def side_map(clue: Clue, shift: Shift, points: Array, plan: FloorPlan, reader: PhraseReader) -> Array:
    """Measure how well points (p, 2) lie in a part of the table."""
    centres, width = _target(clue, plan, reader)
    centres = centres + _shifted(shift)
    away = (points[:, None] - centres[None]) / width
    return np.asarray(gaussian(away, 1.0).prod(axis=2).max(axis=1))
