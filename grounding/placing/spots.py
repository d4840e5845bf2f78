"""From clues to the place that agrees best with all of them: a map over places that are free and supported."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from grounding.placing import maps
from grounding.placing.anchors import Anchors, around, find_anchors
from grounding.meaning.goal.clues import Clue
from grounding.meaning.goal.items import Item, line_up
from grounding.meaning.goal.listening import listen
from grounding.placing.places import PITCH, Places, Plan, find_places, lay_out
from grounding.placing.room import leave_room
from grounding.placing.shapes import completing, shape_map
from grounding.placing.sides import side_map, side_points
from grounding.model.phrases import PhraseReader
from grounding.language.tree import Phrase
from grounding.world import Array

FLOOR = 0.02  # a clue that does not hold leaves so much: words and eyes err
VAGUE = 0.1  # shapes are in the eye of who looks
UNSAID_TOP = 0.02  # how likely something goes on top of something though nothing says so
NEAR = 0.6  # places so close [edges] are as good as one another
UNPARTED = 0.7  # how much a place counts that was found in a text whose parts are not known
HELD = 0.01  # where no clue agrees so much with any place, there is no room where it would
STAYING = 0.3  # what goes less far [edges] is not moved
NEARER = 75.0  # of places that the words leave open the nearer ones are preferred, fading over so many edges
_KEPT = 60  # of the best places are compared
_CROSSED = 7  # coordinates of exact points that are combined


@dataclass(frozen=True, eq=False)
class Spot:
    """Where something is to go.

    Attributes:
        point: x, y on the table [m].
        relation: a spatial reference to the objects, or None.
        reference: indices of the objects.
        on: whether it goes on top of the reference.
        certainty: the share of belief within a block of it, in [0, 1].
    """

    point: Array
    relation: str | None
    reference: tuple[int, ...]
    on: bool
    certainty: float


@dataclass(frozen=True, eq=False)
class _Grounded:
    """A clue with what its references may be."""

    clue: Clue
    anchors: Anchors | None
    shift: maps.Shift


def find_spot(phrases: Iterable[Phrase], source: int, reader: PhraseReader, whole: Phrase | None = None) -> Spot | None:
    """Where the words of a destination lead.

    Args:
        phrases: what follows the verb and what it moves, and what is said of "it" afterwards.
        source: index of what is moved.
        reader: of the scene; the source is no reference.
        whole: the text, read without what names the source where the phrases say nothing.

    Returns:
        the place with the most belief around it, free and supported; None where the words say nothing or there is no
        room.
    """
    found = settle(listen(line_up(phrases)), source, reader)
    if found is None and whole is not None:
        rest = [item for item in line_up([whole]) if not _names(item, source, reader)]
        found = settle(listen(rest), source, reader)
        found = None if found is None else replace(found, certainty=UNPARTED * found.certainty)
    return found


def leads_off(phrases: Iterable[Phrase], source: int, reader: PhraseReader) -> bool:
    """Whether a way is told, with its lengths, that ends where there is no table."""
    plan = lay_out(reader.scene, reader.view)
    for clue in listen(line_up(phrases)):
        shift = maps.Shift(clue.offsets, reader, plan.axes)
        if clue.relation == "own" and shift.said.any():
            end = plan.points[source] + shift.lengths
            if bool((np.abs(end - plan.centre) > plan.half).any()):
                return True
    return False


def agreed(spots: Sequence[tuple[Spot, float]], edge: float) -> Spot | None:
    """Of the places that several readings lead to, the one with most of them around it.

    Args:
        spots: places with their readings' shares of belief.
        edge: of a block [m].
    """
    if not spots:
        return None
    points = np.array([[*spot.point / edge, float(spot.on)] for spot, _ in spots])
    weights = np.array([share * spot.certainty for spot, share in spots])
    square = ((points[:, None] - points[None]) ** 2).sum(axis=2)
    return spots[int(np.argmax(np.exp(-0.5 * square / NEAR**2) @ weights))][0]


def _names(item: Item, source: int, reader: PhraseReader) -> bool:
    """Whether a piece names what is moved."""
    if item.kind not in ("thing", "shape") or item.noun is None:
        return False
    weights = reader.weights(item.noun)
    return bool(weights.any()) and float(weights[source]) > 0.5 * float(weights.sum())


def settle(clues: list[Clue], source: int, reader: PhraseReader) -> Spot | None:
    """Where clues lead together, see `find_spot`."""
    scene = reader.scene
    plan = lay_out(scene, reader.view)
    grounded = [g for clue in clues if (g := _ground(clue, source, plan, reader)) is not None]
    if (
        not grounded
        or all(g.clue.relation in ("make", "tower") for g in grounded)
        and not any(g.clue.relation == "tower" or len(completing(g.clue.nouns[0], source, plan)[0]) for g in grounded)
    ):
        return None
    places = find_places(plan, scene, source, _exact(grounded, source, plan, reader))
    if not len(places.points):
        return None
    stacked = any(g.clue.relation in ("on", "tower") for g in grounded)
    belief = np.where(places.support >= 0, 1.0 if stacked else UNSAID_TOP, 1.0) * places.prior
    away = np.abs(places.points - plan.points[source]).max(axis=1)
    belief = belief * (away > STAYING) * np.exp(-away / NEARER)
    held = []
    for g in grounded:
        single = _map(g, places, source, plan, reader)
        held.append(single)
        floor = VAGUE if g.clue.relation == "make" else FLOOR
        belief = belief * (
            floor + (1 - floor) * (single.max(axis=1) if g.anchors is None else single @ g.anchors.share)
        )
    spot = _choose(places, belief, grounded, held, plan)
    if spot is None or spot.on or any(clue.relation == "touch" or clue.strict for clue in clues):
        return spot
    return replace(spot, point=leave_room(spot.point, source, scene))


def _ground(clue: Clue, source: int, plan: Plan, reader: PhraseReader) -> _Grounded | None:
    shift = maps.Shift(clue.offsets, reader, plan.axes)
    if clue.relation in ("own", "surface", "tower", "place", "make"):
        return _Grounded(clue, None, shift)
    anchors = find_anchors(clue.nouns, source, plan.points, reader) if clue.nouns else None
    if anchors is None:
        return _Grounded(Clue("own", (), clue.offsets), None, shift) if clue.offsets else None
    if anchors.members == ((source,),):  # "to the left of it"
        return _Grounded(Clue("own", (), clue.offsets), None, shift) if clue.offsets else None
    return _Grounded(clue, anchors, shift)


def _map(g: _Grounded, places: Places, source: int, plan: Plan, reader: PhraseReader) -> Array:
    """How well places agree with a clue, shape (p, h); (p, 1) where it has no references."""
    points, relation = places.points, g.clue.relation
    if g.anchors is None:
        if relation == "tower":
            return maps.raising(places, plan, g.clue.height)[:, None]
        if relation == "surface":
            return maps.lying(places, plan.points[source])[:, None]
        if relation == "make":
            return shape_map(points, *completing(g.clue.nouns[0], source, plan))[:, None]
        if relation == "place":
            return side_map(g.clue, g.shift, points, plan, reader)[:, None]
        return maps.moved(g.shift, plan.points[source], points)[:, None]
    if relation == "offset":
        return maps.shifted(g.shift, g.anchors, points, g.clue.strict)
    if relation == "on":
        return maps.on_top(places, plan, g.anchors)
    if relation == "between":
        return maps.amid(plan, g.anchors, points)
    if relation == "align":
        return maps.aligned(g.clue, g.anchors, points)
    if relation == "in":
        return maps.within(g.clue, g.anchors, points)
    if relation == "toward":
        return maps.approaching(plan.points[source], g.anchors, points)
    return maps.beside(places, plan, g.anchors, relation == "touch")


def _exact(grounded: list[_Grounded], source: int, plan: Plan, reader: PhraseReader) -> Array:
    """Where clues point, and where the coordinates of several cross."""
    found = [np.zeros((0, 2))]
    for g in grounded:
        relation = g.clue.relation
        if relation == "make":
            found.append(completing(g.clue.nouns[0], source, plan)[0])
            continue
        if relation == "place":
            found.append(side_points(g.clue, g.shift, plan, reader))
            continue
        anchors = g.anchors or around(source, plan.points)
        centre, half = anchors.centre[:3], (anchors.high - anchors.low)[:3] / 2
        if relation in ("own", "offset"):
            sign = np.sign(g.shift.steps) + g.shift.open
            own = relation == "own"
            typical = g.shift.typical if own else np.full(2, PITCH)
            steps = np.abs(g.shift.lengths if own else 1.1 * g.shift.steps * PITCH)
            for more in (0.0,) if own else (PITCH, 0.0):
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


def _choose(places: Places, belief: Array, grounded: list[_Grounded], held: list[Array], plan: Plan) -> Spot | None:
    """The place with the most belief around it."""
    kept = np.argpartition(-belief, min(_KEPT, len(belief) - 1))[:_KEPT]
    kept = kept[np.lexsort((kept, -belief[kept]))]
    weights = belief[kept]
    total = float(belief.sum())
    if total <= 0:
        return None
    points = np.column_stack([places.points[kept], places.support[kept] >= 0])
    norm = (points**2).sum(axis=1)
    square = norm[:, None] + norm - 2 * points @ points.T
    gain = np.exp(-0.5 * square / NEAR**2) @ weights
    best = int(np.argmax(gain))
    if all(float(single[kept[best]].max()) < HELD for single in held):
        return None
    close = square[best] < 1.0
    certainty = float(weights[close].sum()) / total
    at = int(kept[best])
    support = int(places.support[at])
    relation, reference = _reference(grounded, held, at)
    if support >= 0:
        relation, reference = "top", (support,)
    return Spot(plan.world(places.points[at]), relation, reference, support >= 0, min(certainty, 1.0))


def _reference(grounded: list[_Grounded], held: list[Array], at: int) -> tuple[str | None, tuple[int, ...]]:
    """What the words relate a place to, by the clue that says most about it."""
    for g, single in zip(grounded, held, strict=True):
        if g.anchors is None or g.clue.relation == "toward":
            continue
        best = int(np.argmax(single[at] * g.anchors.share))
        names = [n for offset in g.clue.offsets for n in offset.names]
        flat = {"up": "back", "down": "front"}.get(names[0], names[0]) if len(set(names)) == 1 else "near"
        relation = "between" if g.clue.relation == "between" else flat if names else "near"
        return relation, g.anchors.members[best]
    return None, ()
