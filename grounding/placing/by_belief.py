"""The destination of a text: the place that most of its likeliest readings agree on."""

from __future__ import annotations

import numpy as np

from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.lexicon.table import tables, under
from grounding.model.belief import Belief, Reading
from grounding.model.phrases import PhraseReader, reader_of
from grounding.placing.finger_room import leave_room
from grounding.placing.floor_plan import find_places, lay_out
from grounding.placing.spots import FoundSpot, agreed, find_spot, leads, leads_off
from grounding.result import Destination
from grounding.world import Array
from grounding.world.scene import Scene

ASIDE = 2.2  # how far something is put aside at least, so that another one finds room in its place [edges]
HEARD = 3  # readings that are asked where to


def destination(belief: Belief, objects: tuple[str, ...]) -> Destination | None:
    """Find where the likeliest readings of a text bring objects: the place that most of them agree on.

    Args:
        belief: of the text.
        objects: ids of what is moved.

    Returns:
        None where nothing says where to, or no place that is meant is free.
    """
    source = _source(belief, objects)
    if source is None:
        return None
    heard = _telling(belief)[:HEARD]
    scene = heard[0][0].evaluator.scene
    if len(objects) > 1 and not any(_leads(piece) for reading, _ in heard for piece in reading.told.destination):
        return None  # "stack the two red blocks": on what?
    found: dict[tuple[str, tuple[Phrase, ...]], tuple[FoundSpot, float]] = {}
    full: dict[str, str] = {}
    for reading, share in heard:
        said = reading.evaluator.view, tuple(reading.told.destination)
        words = " ".join(piece.text for piece in reading.told.destination)
        if said in found:
            found[said] = (found[said][0], found[said][1] + share)
            continue
        spot = None if full.get(words, said[0]) != said[0] else _find(reading, source)
        if spot is not None:
            found[said] = (spot, share)
            continue
        if reading is heard[0][0] and leads_off_table(belief, objects):
            return None
        full.setdefault(words, said[0])  # where there is no room as one looks, nobody else's look finds any
    spot = agreed(list(found.values()), scene.edge)
    return None if spot is None else _stated(spot, source, scene)


def free_place(source: int, reader: PhraseReader) -> Destination | None:
    """The next free place on the table at which something leaves its own place free; None where there is none."""
    scene = reader.scene
    plan = lay_out(scene, reader.view)
    places = find_places(plan, scene, source, np.zeros((0, 2)))
    away = np.linalg.norm(places.points - plan.points[source], axis=1)
    fits = np.flatnonzero((places.support < 0) & (away >= ASIDE))
    if not len(fits):
        return None
    point = plan.world(places.points[fits[np.argmin(away[fits])]])
    return _stated(FoundSpot(leave_room(point, source, scene), None, (), False, 1.0), source, scene)


def leads_off_table(belief: Belief, objects: tuple[str, ...]) -> bool:
    """Tells whether the likeliest reading of a text moves an object so far that it leaves the table."""
    source = _source(belief, objects)
    if source is None or len(objects) != 1:
        return False
    reading = _telling(belief)[0][0]
    return leads_off(_pieces(reading), source, reader_of(reading))


def where_to(belief: Belief, objects: tuple[str, ...]) -> str:
    """The words by which the likeliest reading tells where to, without the verb; "" where it tells nothing."""
    source = _source(belief, objects)
    if source is None:
        return ""
    reading = _telling(belief)[0][0]
    pieces = [piece for piece in reading.told.destination if piece.phrases]
    return " ".join(piece.text for piece in pieces) if leads(pieces, source, reader_of(reading)) else ""


def _telling(belief: Belief) -> list[tuple[Reading, float]]:
    """The readings that tell of something to handle, the likeliest first, with their shares."""
    return [item for item in zip(belief.readings, belief.shares, strict=True) if item[0].told.target is not None]


def _source(belief: Belief, objects: tuple[str, ...]) -> int | None:
    """The index of what is moved first; None where nothing is told of it."""
    telling = _telling(belief)
    return telling[0][0].evaluator.scene.layout.index.get(objects[0]) if objects and telling else None


def _find(reading: Reading, source: int) -> FoundSpot | None:
    told = reading.told
    whole = told.whole if told.kind == "place" else None
    return find_spot(_pieces(reading), source, reader_of(reading), whole)


def _pieces(reading: Reading) -> list[Phrase]:
    return list(reading.told.destination)


def _leads(piece: Phrase) -> bool:
    """Tells whether a piece of a destination tells more than the verb does."""
    return bool(piece.phrases) or any(w.directions(leaf.text) for leaf in piece.leaves) or piece.tag != "VP"


def _stated(spot: FoundSpot, source: int, scene: Scene) -> Destination:
    """A spot as a destination: on what it is on, or on the table."""
    half = float(scene.layout.things[source].size[2]) / 2
    names = tuple(scene.layout.ids[i] for i in spot.reference)
    if spot.on:
        support = scene.layout.things[spot.reference[0]]
        height = float(support.position[2] + support.half_extents[2]) + half
    else:
        height = _table_top(scene, spot.point) + half
    x, y = (float(value) for value in spot.point)
    region = tuple((float(a), float(b), _table_top(scene, np.array([a, b])) + half) for a, b in spot.region)
    return Destination((x, y, height), spot.relation if names else None, names, region)


def _table_top(scene: Scene, point: Array) -> float:
    found = tables(scene)
    if found:
        item = found[max(int(under(scene, point[None])[0]), 0)]
        return float(item.position[2] + item.half_extents[2])
    return float(min((thing.position[2] - thing.half_extents[2] for thing in scene.layout.things), default=0.0))
