"""Clues whose references were looked up in a scene: how well places agree with them, and where they point exactly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grounding.lexicon.support import bare
from grounding.meaning.goal.clues import RELATION, Clue
from grounding.meaning.nouns import read_noun
from grounding.model.phrases import PhraseReader
from grounding.placing import maps
from grounding.placing.amid_sets import amid_sets
from grounding.placing.anchors import Anchors, around, carrying, find_anchors
from grounding.placing.completing import completing, shape_map
from grounding.placing.floor_plan import PITCH, FloorPlan, Places
from grounding.placing.sides import side_map, side_points
from grounding.placing.truths import preferences, truths
from grounding.world import Array

_CROSSED = 7  # coordinates of exact points that are combined


@dataclass(frozen=True, eq=False)
class GroundedClue:
    """A clue with what its references may be."""

    clue: Clue
    anchors: Anchors | None
    shift: maps.Shift


def ground_clue(clue: Clue, source: int, plan: FloorPlan, reader: PhraseReader) -> GroundedClue | None:
    """Look up the references of a clue; None where they are not there and no direction is named."""
    shift = maps.Shift(clue.offsets, reader, plan.axes, 0.0 if plan.board is None else plan.pitch)
    if clue.relation in ("own", "surface", "tower", "place", "make"):
        return GroundedClue(clue, None, shift)
    if _is_above(clue) and reader.scene.towers and len(reader.scene.layout.colors) > 1:
        clue = Clue("on", clue.nouns)  # where things stand on things what is above one is on it, but not on a map
    anchors = find_anchors(clue.nouns, source, plan.points, reader) if clue.nouns else None
    if anchors is not None and clue.relation == "on":
        anchors = carrying(anchors, bare(reader.scene, source))
    if anchors is None:
        return GroundedClue(Clue("own", (), clue.offsets), None, shift) if clue.offsets else None
    if anchors.members == ((source,),):  # "to the left of it"
        return GroundedClue(Clue("own", (), clue.offsets), None, shift) if clue.offsets else None
    return GroundedClue(clue, anchors, shift)


def _is_above(clue: Clue) -> bool:
    """Tells whether a clue leads above something, and no length is said."""
    return clue.relation == "offset" and all(o.names == ("up",) and o.steps is None for o in clue.offsets)


def truth_of(g: GroundedClue, places: Places, plan: FloorPlan, reader: PhraseReader) -> Array | None:
    """How true a clue is of places, shape (p, h); None where it has no references or is no concept of the lexicon."""
    if g.anchors is None or (g.clue.relation == "between" and _arranged(g.clue)):
        return None  # between arrangements the lexicon is asked as a whole, see `agreement`
    return truths(g.clue.relation, g.anchors, g.shift, places, plan, reader, strict=g.clue.strict)


def _arranged(clue: Clue) -> bool:
    """Tells whether what a clue relates to are arrangements."""
    nouns = [read_noun(phrase) for noun in clue.nouns for phrase in noun.conjoined] or list(clue.nouns)
    return any(noun.head == "container" for noun in nouns)


def agreement(g: GroundedClue, places: Places, source: int, plan: FloorPlan, reader: PhraseReader) -> Array:
    """Measure how well places agree with a clue, shape (p, h); (p, 1) where it has no references."""
    if g.anchors is None:
        return _of_itself(g, places, source, plan, reader)[:, None]
    points = places.points
    length = _way(g.clue, reader)
    if length is not None:
        return maps.at_ends(maps.ends_of_way(plan.points[source], g.anchors, length), points)
    if g.clue.relation.startswith(RELATION):
        return preferences(g.clue.relation.removeprefix(RELATION), g.anchors, places, plan, reader)
    match g.clue.relation:
        case "offset":
            return maps.offset_from(g.shift, g.anchors, points, g.clue.strict)
        case "on":
            return maps.on_top(places, plan, g.anchors)
        case "between":
            held = amid_sets(g.clue.nouns, reader, plan.world(points))
            if held is not None:
                return np.repeat(held[:, None], len(g.anchors.share), axis=1)
            return maps.in_between(plan, g.anchors, points)
        case "align":
            return maps.in_line(g.clue, g.anchors, points)
        case "in":
            return maps.inside(g.clue, g.anchors, points)
        case "apart":
            return maps.leaving(plan.points[source], g.anchors, points)
        case "toward":
            return maps.approaching(plan.points[source], g.anchors, points)
    return maps.next_to(places, plan, g.anchors, g.clue.relation == "touch")


def _way(clue: Clue, reader: PhraseReader) -> float | None:
    """How far a clue leads towards something, or away from it with a minus [edges]; None where it does not say."""
    length = maps.part_of_way(clue, reader.scene.edge) if clue.relation in ("toward", "apart") else None
    return None if length is None else length if clue.relation == "toward" else -length


def _of_itself(g: GroundedClue, places: Places, source: int, plan: FloorPlan, reader: PhraseReader) -> Array:
    """Measure how well places agree with a clue that has no references, shape (p,)."""
    match g.clue.relation:
        case "tower":
            return maps.raising(places, plan, g.clue.height)
        case "surface":
            return maps.lying_on(places, plan) if g.clue.nouns else maps.lying(places, plan.points[source])
        case "make":
            return shape_map(places.points, *completing(g.clue.nouns[0], source, plan))
        case "place":
            return side_map(g.clue, g.shift, places.points, plan, reader)
    return maps.moved(g.shift, plan.points[source], places.points)


def exact_points(grounded: Sequence[GroundedClue], source: int, plan: FloorPlan, reader: PhraseReader) -> Array:
    """The points that clues name, and those where the coordinates of several cross."""
    found = [np.zeros((0, 2))]
    for g in grounded if plan.board is None else ():  # on a board all squares are candidates
        relation = g.clue.relation
        if relation == "make":
            found.append(completing(g.clue.nouns[0], source, plan)[0])
            continue
        if relation == "place":
            found.append(side_points(g.clue, g.shift, plan, reader))
            continue
        anchors = g.anchors or around(source, plan.points)
        length = _way(g.clue, reader)
        if length is not None:
            found.append(maps.ends_of_way(plan.points[source], anchors, length))
            continue
        centre, half = anchors.centre[:3], (anchors.high - anchors.low)[:3] / 2
        if relation in ("own", "offset"):
            sign = np.sign(g.shift.steps) + g.shift.open
            own = relation == "own"
            typical = g.shift.typical if own else np.full(2, PITCH)
            steps = np.abs(g.shift.lengths if own else 1.1 * g.shift.steps * PITCH)
            if g.shift.metric.any() and not own:
                steps = np.where(g.shift.metric, np.abs(g.shift.steps) + 1.0, steps)
                typical = np.zeros(2)
            for more in (0.0,) if own or g.shift.metric.any() else (PITCH, 0.0):
                reach = np.where(g.shift.said, steps + more * (steps > 0), typical)
                found.append(centre + sign * (half + reach))
        elif relation in ("between", "align", "in"):
            found.append(centre)
    points = np.concatenate(found)
    if len(found) > 2:
        xs, ys = points[:_CROSSED, 0], points[:_CROSSED, 1]
        crossed = np.stack(np.meshgrid(xs, ys, indexing="ij"), axis=-1).reshape(-1, 2)
        points = np.concatenate([points, crossed])
    return points
