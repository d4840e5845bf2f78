"""Maps of how well every candidate place agrees with a clue, each in [0, 1]."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.lexicon.degrees import gaussian
from grounding.meaning.goal.clues import Clue, Offset
from grounding.meaning.goal.lengths import Metres
from grounding.model.phrases import PhraseReader
from grounding.placing.anchors import Anchors
from grounding.placing.floor_plan import PITCH, FloorPlan, Places
from grounding.world import Array

OWN_UNSAID = {"": 2.25, "slightly": 0.5, "far": 5.0}
"""The length of a way where only a direction is said [edges]."""
BESIDES = 1.15  # how far along one axis where the other one is spoken of as well [edges]
SPREAD = 1.1  # of that, as a factor's logarithm
STRETCH = {1: 1.2, 2: 1.14}
"""The length of people's steps, by the number of axes along which they go [edges]: a step leaves a gap."""
FROM_CENTRE, FROM_SIDE = 1.0, 0.45
"""Weights of counting blocks from the centre of something, and of counting between the sides."""
EXACT = 0.1  # how far off something is that was measured [edges]
OTHERWISE = 0.1  # how often a tower comes to be lower or higher than is said
CLOSE = 0.9  # nothing that comes nearer to something goes beyond this distance from it [edges]
WITHIN = 0.4  # how far from the middle of a table that is named, of its half extents
SET_DOWN = 1.0  # within how many edges something is set down where only the table is named
CROWDED = 0.15  # how well something still is that way of a reference whose own lane is taken
BESIDE = {"": 1.3, "slightly": 0.8, "far": 4.0}  # how far from a reference [edges]


class Shift:
    """A sum of offsets along "right" and "back": exact lengths, and signs where nothing is said.

    Args:
        offsets: one after the other.
        reader: whose view is taken where nobody is named.
        axes: "right" and "back", shape (2, 2).
        square: width of the squares of a board [edges], 0 where there is none.
    """

    def __init__(self, offsets: Sequence[Offset], reader: PhraseReader, axes: Array, square: float = 0.0) -> None:
        self.square = square
        self.steps = np.zeros(2)
        self.open = np.zeros(2)
        self.extent = [""] * 2
        self.said = np.zeros(2, dtype=bool)
        self.metric = np.zeros(2, dtype=bool)
        for offset in offsets:
            flat = [_FLAT.get(name, name) for name in offset.names]
            vector = np.zeros(2)
            for name in flat:
                vector += axes @ reader.scene.direction(name, offset.owner or reader.view)
            vector = vector / max(float(np.abs(vector).max()), 1e-9)  # west-northwest: twice as far west as north
            for k in np.flatnonzero(np.abs(vector) > 0.3):
                if offset.steps is None:
                    self.open[k] = np.sign(vector[k])
                    self.extent[k] = offset.extent or self.extent[k]
                    continue
                self.said[k] = True
                if isinstance(offset.steps, Metres):
                    self.metric[k] = True
                    self.steps[k] += vector[k] * offset.steps / reader.scene.edge
                else:
                    self.steps[k] += vector[k] * offset.steps
        self.open[self.said] = 0.0
        self.far = any(offset.counted == "sides" for offset in offsets)

    @property
    def lengths(self) -> Array:
        """Said lengths of a way, shape (2,) [edges]."""
        stretch = self.square or STRETCH[max(1, int((self.said | (self.open != 0)).sum()))]
        return np.asarray(np.where(self.metric, self.steps, self.steps * stretch))

    @property
    def typical(self) -> Array:
        """The length of the way along each axis where nothing is said, shape (2,) [edges]."""
        several = int((self.said | (self.open != 0)).sum()) > 1
        return np.array([BESIDES if several and not e else OWN_UNSAID[e] for e in self.extent])


_FLAT = {"up": "back", "down": "front"}


def moved(shift: Shift, start: Array, points: Array) -> Array:
    """From where something stands: so far, or just that way. `points` (p, 2), `start` (2,) in edges."""
    total = np.ones(len(points))
    vague = not shift.said.any()
    wanted = shift.lengths
    for k in range(2):
        along = points[:, k] - start[k]
        if shift.said[k]:
            total *= gaussian(along - wanted[k], EXACT if shift.metric[k] else 0.25 + 0.12 * abs(wanted[k]))
        elif shift.open[k]:
            total *= _logarithmic(along * shift.open[k], shift.typical[k])
        else:
            total *= gaussian(along, EXACT if shift.metric.any() else 0.7 if vague else 0.35)
    return total


def _logarithmic(along: Array, typical: float) -> Array:
    return np.asarray(gaussian(np.log(np.maximum(along, 0.05) / typical), SPREAD) * (along > 0.15))


def offset_from(shift: Shift, anchors: Anchors, points: Array, strict: bool) -> Array:
    """From references: so far between the sides, or beside them that way; shape (p, h)."""
    total = np.ones((len(points), len(anchors.share)))
    for k in range(2):
        low, high = anchors.low[:, k], anchors.high[:, k]
        at = points[:, k][:, None]
        if shift.said[k]:
            sign = np.sign(shift.steps[k]) or 1.0
            along = (at - np.where(sign > 0, high, low)) * sign
            steps = abs(shift.steps[k])
            if shift.metric[k]:
                total *= gaussian(along - (steps + 1.0), EXACT)  # from side to side
                continue
            width = 0.25 + 0.1 * steps
            centre = gaussian(along - steps * (shift.square or 1.1 * PITCH), width)
            total *= (
                np.maximum(FROM_CENTRE * centre, FROM_SIDE * gaussian(along - (steps + 1) * PITCH, width))
                if shift.far and not shift.square
                else centre
            )
        elif shift.open[k]:
            along = (at - np.where(shift.open[k] > 0, high, low)) * shift.open[k]
            total *= _beyond(along, BESIDE[shift.extent[k]], strict)
        else:
            off = np.maximum(np.maximum(low - at, at - high), 0.0)
            centred = np.abs(at - (low + high) / 2)
            if shift.metric.any():
                total *= gaussian(centred, EXACT)
                continue
            aligned = gaussian(off, 0.2 if strict else 0.4) * gaussian(centred, 0.8 + (high - low))
            total *= aligned if strict else np.maximum(aligned, CROWDED * np.exp(-off))
    return total


def _beyond(along: Array, typical: float, strict: bool) -> Array:
    rising = gaussian(np.minimum(along - 0.95, 0.0), 0.2)
    falling = np.exp(-np.maximum(along - typical, 0.0) / (0.5 if strict else 1.6))
    return np.asarray(rising * falling)


def _from(points: Array, plan: FloorPlan, members: Sequence[int]) -> tuple[Array, Array]:
    """The larger and the smaller distance along the axes of points (p, 2) from objects, each of shape (m, p)."""
    across, along = (np.abs(plan.points[list(members), k][:, None] - points[:, k]) for k in range(2))
    return np.maximum(across, along), np.minimum(across, along)


def next_to(places: Places, plan: FloorPlan, anchors: Anchors, touching: bool) -> Array:
    """Next to a member of each hypothesis, shape (p, h)."""
    found = np.zeros((len(places.points), len(anchors.share)))
    for h, members in enumerate(anchors.members):
        away, aside = _from(places.points, plan, members)
        gap = away - PITCH
        near = gaussian(gap, 0.12) if touching else np.exp(-np.maximum(gap, 0.0) / 0.5)
        found[:, h] = (near * (0.5 + 0.5 * gaussian(aside, 0.2))).max(axis=0)
    return found


def on_top(places: Places, plan: FloorPlan, anchors: Anchors) -> Array:
    """On top of a member of each hypothesis, shape (p, h)."""
    found = np.zeros((len(places.points), len(anchors.share)))
    above = np.flatnonzero(places.support >= 0)
    for h, members in enumerate(anchors.members):
        away, _ = _from(places.points[above], plan, members)
        found[above, h] = (away.min(axis=0) < 0.3) / np.sqrt(len(members))
    return found


def raising(places: Places, plan: FloorPlan, height: int) -> Array:
    """On a tower that then is so many blocks high, or on anything where that is 0, shape (p,)."""
    found = np.asarray(places.support >= 0, dtype=float)
    if height > 1:
        found = found * np.where(plan.level[places.support] + 1 == height, 1.0, OTHERWISE)
    return found


def lying(places: Places, start: Array) -> Array:
    """On the table, rather near where it is, shape (p,)."""
    away = np.linalg.norm(places.points - start, axis=1)
    return np.asarray((places.support < 0) * np.exp(-away / SET_DOWN))


def lying_on(places: Places, plan: FloorPlan) -> Array:
    """On the table that was named, rather in its middle, shape (p,)."""
    off = np.abs(places.points - plan.centre) / plan.half
    return np.asarray((places.support < 0) * (off.max(axis=1) <= 1.0) * gaussian(off, WITHIN).prod(axis=1))


def in_between(plan: FloorPlan, anchors: Anchors, points: Array) -> Array:
    """Between two, or amid several, shape (p, h)."""
    found = np.zeros((len(points), len(anchors.share)))
    for h, members in enumerate(anchors.members):
        inside = plan.points[list(members)]
        centre = inside.mean(axis=0)
        if len({tuple(p) for p in np.round(inside, 1).tolist()}) == 1:
            found[:, h] = 0.3 * gaussian(np.abs(points - centre).max(axis=1), 1.5)
        elif len(members) == 2:
            span = inside[1] - inside[0]
            length = float(np.linalg.norm(span))
            off = points - centre
            along = off @ span / length
            across = off @ np.array([-span[1], span[0]]) / length
            found[:, h] = gaussian(along, 0.3 + 0.12 * length) * gaussian(across, 0.35 + 0.05 * length)
        else:
            extent = np.maximum((inside.max(axis=0) - inside.min(axis=0)) / 2, 0.5)
            found[:, h] = gaussian((points - centre) / (0.5 + 0.5 * extent), 1.0).prod(axis=1)
    return found


def in_line(clue: Clue, anchors: Anchors, points: Array) -> Array:
    """In one row or column with a reference, shape (p, h)."""
    at = points[:, None]
    off = np.maximum(np.maximum(anchors.low - at, at - anchors.high), 0.0)
    off = np.minimum(off + 0.3 * np.abs(at - anchors.centre), np.abs(at - anchors.centre))
    column, row = gaussian(off[..., 0], 0.25), gaussian(off[..., 1], 0.25)
    away = np.exp(-np.linalg.norm(at - anchors.centre, axis=2) / 8.0)
    found = row if clue.axis == "row" else column if clue.axis == "column" else np.maximum(row, column)
    return np.asarray(found * away)


def inside(clue: Clue, anchors: Anchors, points: Array) -> Array:
    """In a row, a column, a circle or a group, shape (p, h)."""
    at = points[:, None]
    off = np.maximum(np.maximum(anchors.low - at, at - anchors.high), 0.0)
    kinds = {kind for noun in clue.nouns for kind in noun.kinds}
    if kinds == {"circle"}:
        width = 0.5 + 0.1 * (anchors.high - anchors.low)
        return np.asarray(gaussian(at - anchors.centre, width).prod(axis=2))
    if "row" in kinds and "column" not in kinds:
        return np.asarray(gaussian(off[..., 1], 0.35) * np.exp(-off[..., 0] / 3.0))
    if "column" in kinds and "row" not in kinds:
        return np.asarray(gaussian(off[..., 0], 0.35) * np.exp(-off[..., 1] / 3.0))
    return np.asarray(np.exp(-np.maximum(off.max(axis=2) - 0.2, 0.0) / 0.7))


def _way(start: Array, span: Array, points: Array) -> tuple[Array, Array, Array]:
    """How far points lie along ways and beside them, shape (p, h), and how long the ways are, shape (h,)."""
    length = np.maximum(np.linalg.norm(span, axis=1), 0.5)
    off = points[:, None] - start
    across = np.abs(off[..., 0] * span[:, 1] - off[..., 1] * span[:, 0]) / length
    return (off * span).sum(axis=2) / length, across, length


def part_of_way(clue: Clue, edge: float) -> float | None:
    """How far a clue goes towards or away from something [edges], None where it does not say."""
    steps = clue.offsets[0].steps if clue.offsets else None
    if steps is None:
        return None
    return float(steps) / edge if isinstance(steps, Metres) else steps * STRETCH[1]


def ends_of_way(start: Array, anchors: Anchors, length: float) -> Array:
    """Where a way of some length towards each hypothesis ends, away from it where the length is negative, (h, 2)."""
    span = anchors.centre - start
    return np.asarray(start + length * span / np.maximum(np.linalg.norm(span, axis=1, keepdims=True), 1e-9))


def at_ends(ends: Array, points: Array) -> Array:
    """How well points (p, 2) are where ways end, shape (p, h)."""
    return np.asarray(gaussian(np.linalg.norm(points[:, None] - ends, axis=2), EXACT))


def leaving(start: Array, anchors: Anchors, points: Array) -> Array:
    """Farther from a reference than where it stands, on the way from there, shape (p, h)."""
    along, across, _ = _way(start, start - anchors.centre, points)
    return np.asarray(_logarithmic(along, OWN_UNSAID[""]) * gaussian(across, 0.7))


def approaching(start: Array, anchors: Anchors, points: Array) -> Array:
    """Nearer to a reference than where it stands, on the way there, shape (p, h)."""
    along, across, length = _way(start, anchors.centre - start, points)
    left = length - along
    before = (along > 0.3) & (left > CLOSE)
    return np.asarray(gaussian(across, 0.6) * np.exp(-np.maximum(left - 1.1, 0) / (0.5 * length)) * before)
