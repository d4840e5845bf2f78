"""From clues to the place that agrees best with all of them: a map over places that are free and supported."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from grounding.language.tree import Phrase
from grounding.lexicon.table import under
from grounding.meaning.goal.clues import RELATION, Clue
from grounding.meaning.goal.items import Item, line_up
from grounding.meaning.goal.listening import listen
from grounding.meaning.wholes import noun_of_whole
from grounding.model.phrases import PhraseReader
from grounding.model.standing import meant_tables
from grounding.placing import maps
from grounding.placing.completing import completing
from grounding.placing.finger_room import leave_room
from grounding.placing.floor_plan import FloorPlan, Places, find_places, lay_out, lying_at
from grounding.placing.grounded_clues import GroundedClue, agreement, exact_points, ground_clue, truth_of
from grounding.placing.maps import Shift
from grounding.world import Array

FLOOR = 0.02  # a clue that does not hold leaves so much: words and eyes err
VAGUE = 0.1  # shapes are in the eye of who looks
UNSAID_TOP = 0.002  # how likely something goes on top of something though nothing says so
NEAR = 0.6  # places so close [edges] are as good as one another
UNPARTED = 0.7  # how much a place counts that was found in a text whose parts are not known
HELD = 0.01  # where no clue agrees so much with any place, there is no room where it would
UNTRUE = 0.2  # where between two things no place is truer than this there is no room
MEASURED = 0.01  # the same of what was measured
STAYING = 0.3  # what goes less far [edges] is not moved
NEARER = 75.0  # of places that the words leave open the nearer ones are preferred, fading over so many edges
_KEPT = 60  # of the best places are compared
REGION = 0.25  # what agrees with the words so much, beside the place that is chosen, is meant as well
_AROUND, _STEP = 2.0, 0.4  # how far about that place it is looked for, and how densely [edges]
_POINTS = 64  # of them are kept, at most


@dataclass(frozen=True, eq=False)
class FoundSpot:
    """A place where something is to go.

    Attributes:
        point: x, y on the table [m].
        relation: a spatial reference to the objects, or None.
        reference: indices of the objects.
        on: whether it goes on top of the reference.
        certainty: the share of belief within a block of it, in [0, 1].
        region: other places on the table where the words hold nearly as well, the best first, shape (k, 2) [m].
    """

    point: Array
    relation: str | None
    reference: tuple[int, ...]
    on: bool
    certainty: float
    region: Array = field(default_factory=lambda: np.zeros((0, 2)))


def find_spot(
    phrases: Iterable[Phrase], source: int, reader: PhraseReader, whole: Phrase | None = None
) -> FoundSpot | None:
    """Find the place to which the words of a destination lead.

    Args:
        phrases: what follows the verb and what it moves, and what is said of "it" afterwards.
        source: index of what is moved.
        reader: of the scene; the source is no reference.
        whole: the text, read without what names the source where the phrases say nothing.

    Returns:
        the place with the most belief around it, free and supported; None where the words say nothing or there is no
        room.
    """
    found = _settle(listen(line_up(phrases)), source, reader)
    if found is None and whole is not None:
        rest = [item for item in line_up([whole]) if not _names(item, source, reader)]
        found = _settle(listen(rest), source, reader)
        found = None if found is None else replace(found, certainty=UNPARTED * found.certainty)
    return found


def leads(phrases: Iterable[Phrase], source: int, reader: PhraseReader) -> bool:
    """Tells whether words for where to say anything, whether or not there is room."""
    plan = lay_out(reader.scene, reader.view)
    grounded = (ground_clue(clue, source, plan, reader) for clue in listen(line_up(phrases)))
    return any(g is not None and _tells_where(g.clue, source, plan) for g in grounded)


def leads_off(phrases: Iterable[Phrase], source: int, reader: PhraseReader) -> bool:
    """Tells whether a way is told, with its lengths, that ends where there is no table."""
    plan = lay_out(reader.scene, reader.view)
    for clue in listen(line_up(phrases)):
        shift = Shift(clue.offsets, reader, plan.axes, 0.0 if plan.board is None else plan.pitch)
        if clue.relation == "own" and shift.said.any():
            end = plan.points[source] + shift.lengths
            if not bool(np.all(np.abs(end - plan.boxes[0]) <= plan.boxes[1], axis=1).any()):
                return True
    return False


def agreed(spots: Sequence[tuple[FoundSpot, float]], edge: float) -> FoundSpot | None:
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
    """Tells whether a piece names what is moved."""
    if item.kind not in ("thing", "shape") or item.noun is None:
        return False
    weights = reader.weights(item.noun)
    return bool(weights.any()) and float(weights[source]) > 0.5 * float(weights.sum())


def _settle(clues: list[Clue], source: int, reader: PhraseReader) -> FoundSpot | None:
    """Find where clues lead together, see `find_spot`."""
    scene = reader.scene
    main = _table_of(clues, source, reader)
    plan = lay_out(scene, reader.view, main)
    grounded = [g for clue in clues if (g := ground_clue(clue, source, plan, reader)) is not None]
    if not any(_tells_where(g.clue, source, plan) for g in grounded):
        return None
    places = find_places(plan, scene, source, exact_points(grounded, source, plan, reader))
    if not len(places.points):
        return None
    stacked = any(g.clue.relation in ("on", "tower") for g in grounded)
    squares = plan.board is not None and all(g.clue.relation in ("place", "own") for g in grounded)
    if squares:  # a square is meant, whatever stands there
        belief = np.ones(len(places.points))
    else:
        belief = np.where(places.support >= 0, 1.0 if stacked else UNSAID_TOP, 1.0) * places.prior
    away = np.abs(places.points - plan.points[source]).max(axis=1)
    measured = any(g.shift.metric.any() or maps.part_of_way(g.clue, scene.edge) is not None for g in grounded)
    belief = belief * (away > (MEASURED if measured else STAYING)) * np.exp(-away / NEARER)
    held, true = [], []
    for g in grounded:
        single, truth = _held(g, places, source, plan, reader)
        if truth is not None and g.clue.relation == "between" and g.anchors is not None:
            true.append(truth @ g.anchors.share)
        held.append(single)
        floor = VAGUE if g.clue.relation == "make" else FLOOR
        belief = belief * (
            floor + (1 - floor) * _pooled(g, single)
        )
    spot = _choose(places, belief, grounded, held, true, plan, measured=measured)
    exact = measured or plan.board is not None or any(clue.relation == "touch" or clue.strict for clue in clues)
    if spot is None or spot.on:
        return spot
    if plan.board is None:
        spot = replace(spot, region=_region(spot, places, grounded, held, source, plan, reader))
    return spot if exact else replace(spot, point=leave_room(spot.point, source, scene))


def _region(
    spot: FoundSpot, places: Places, grounded: Sequence[GroundedClue], held: Sequence[Array], source: int,
    plan: FloorPlan, reader: PhraseReader,
) -> Array:  # fmt: skip
    """Places on the table where all clues hold nearly as well as at a spot, the best first, shape (k, 2) [m].

    They are looked for among all places and, more densely, around the spot.
    """
    at = plan.local(spot.point)
    near = lying_at(plan, source, at + _OFFSETS)
    closer = [_held(g, near, source, plan, reader)[0] for g in grounded]
    agreed = np.concatenate([_together(grounded, held), _together(grounded, closer)])
    points = np.concatenate([places.points, near.points])
    lying = np.concatenate([places.support, near.support]) < 0
    away = np.linalg.norm(points - at, axis=1)
    best = float(agreed[lying & (away < NEAR)].max(initial=0.0))
    inside = np.flatnonzero(lying & (agreed >= REGION * best) & (agreed > HELD))
    left = points[inside[np.lexsort((np.round(away[inside], 6), -np.round(agreed[inside], 3)))]]
    chosen: list[Array] = []
    while len(left) and len(chosen) < _POINTS:
        chosen.append(left[0])
        left = left[np.abs(left - left[0]).max(axis=1) > _STEP - 1e-6]
    return plan.world(np.array(chosen).reshape(-1, 2))


def _offsets() -> Array:
    line = np.arange(-_AROUND, _AROUND + 1e-9, _STEP)
    return np.asarray(np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1).reshape(-1, 2))


_OFFSETS = _offsets()


def _held(
    g: GroundedClue, places: Places, source: int, plan: FloorPlan, reader: PhraseReader
) -> tuple[Array, Array | None]:
    """How well a clue holds at places, for each of its hypotheses, and what the lexicon says of that, shape (p, h)."""
    single, truth = agreement(g, places, source, plan, reader), truth_of(g, places, plan, reader)
    return single if truth is None else single * truth, truth


def _together(grounded: Sequence[GroundedClue], held: Sequence[Array]) -> Array:
    """How well all clues hold at places, shape (p,)."""
    total = np.ones(len(held[0]))
    for g, single in zip(grounded, held, strict=True):
        total *= _pooled(g, single)
    return total


def _pooled(g: GroundedClue, single: Array) -> Array:
    """How well a clue holds at places over its hypotheses, shape (p,)."""
    return np.asarray(single.max(axis=1) if g.anchors is None else single @ g.anchors.share)


def _table_of(clues: list[Clue], source: int, reader: PhraseReader) -> int:
    """The index of the table whose parts are meant: one that is named, else that on which something stands."""
    scene = reader.scene
    here = int(under(scene, scene.xy[[source]])[0])
    for clue in clues:
        for noun in clue.nouns:
            named = noun if noun.head == "table" else noun_of_whole(noun)
            if named is not None and named.head == "table" and (named.colors or named.directions or named.other):
                fits = meant_tables(scene, reader.noun(named).referent, reader.view, here)
                return int(np.argmax(fits)) if fits.any() else max(here, 0)
    return max(here, 0)


def _tells_where(clue: Clue, source: int, plan: FloorPlan) -> bool:
    """Tells whether a clue leads to places; one that an arrangement comes about only does where one can."""
    return clue.relation != "make" or bool(len(completing(clue.nouns[0], source, plan)[0]))


def _choose(
    places: Places, belief: Array, grounded: list[GroundedClue], held: list[Array], true: list[Array],
    plan: FloorPlan, *, measured: bool,
) -> FoundSpot | None:  # fmt: skip
    """The place with the most belief around it, or where it was measured the one with most belief."""
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
    best = int(np.argmax(weights if measured else gain))
    if all(float(single[kept[best]].max()) < HELD for single in held):
        return None
    if any(float(truth[kept[best]]) < UNTRUE for truth in true):
        return None
    close = square[best] < 1.0
    certainty = float(weights[close].sum()) / total
    at = int(kept[best])
    support = int(places.support[at])
    relation, reference = _reference(grounded, held, at)
    if support >= 0:
        relation, reference = "top", (support,)
    return FoundSpot(plan.world(places.points[at]), relation, reference, support >= 0, min(certainty, 1.0))


def _reference(grounded: list[GroundedClue], held: list[Array], at: int) -> tuple[str | None, tuple[int, ...]]:
    """Name what the words relate a place to, by the clue that says most about it."""
    for g, single in zip(grounded, held, strict=True):
        if g.anchors is None or g.clue.relation == "toward":
            continue
        best = int(np.argmax(single[at] * g.anchors.share))
        if g.clue.relation == "apart" or g.clue.relation.startswith(RELATION):
            return None, g.anchors.members[best]
        names = [n for offset in g.clue.offsets for n in offset.names]
        flat = {"up": "back", "down": "front"}.get(names[0], names[0]) if len(set(names)) == 1 else "near"
        relation = "between" if g.clue.relation == "between" else flat if names else "near"
        return relation, g.anchors.members[best]
    return None, ()
