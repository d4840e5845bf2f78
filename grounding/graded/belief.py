"""What a text asks for by its graded readings: a share of belief for every option, over all parses and viewpoints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grounding.graded import words
from grounding.graded.destinations import Spot, agreed, find_spot, leads_off
from grounding.graded.destinations.units import in_spaces
from grounding.graded.discourse import Told, read_text
from grounding.graded.reader import Reader
from grounding.language.parser import Parse
from grounding.language.tree import Phrase
from grounding.result import Destination
from grounding.world import Array
from grounding.world.scene import ROBOT, SPEAKER, Scene

NEGLIGIBLE = 1e-3  # parses less likely than the best by this factor are not read
PARSE_WEIGHT = 0.5  # how much a parse's probability counts beside how well its reading agrees with the world
HEARD = 3  # readings that are asked where to
DOUBT = 0.02  # every reading is worth so much, as eyes and words err
UNMARKED = 0.75
"""How likely an unmarked left is the robot's where nobody is named and the speaker faces it: people who write for a
robot take its view more often than their own."""
ADDRESSED = 0.92
"""The same where the robot is spoken to as "you": who measures from it also sees from it."""
ONESELF = 0.5
"""The same where only the speaker is named."""
BURIED = 0.3  # what carries something is less likely to be handled
_ALONG = frozenset("behind row column line first second third fourth fifth last".split())

Option = tuple[str, tuple[str, ...]]


@dataclass(frozen=True, eq=False)
class GradedReading:
    """One parse, read with one view.

    Attributes:
        place: of the parse in the list.
        reader: with which it was read.
        told: what it tells.
        weights: of each object as what is handled, shape (n,).
        truth: how well the description holds of what it fits best, in [0, 1].
        share: of belief among all readings.
    """

    place: int
    reader: Reader
    told: Told
    weights: Array
    truth: float
    share: float


@dataclass(frozen=True, eq=False)
class GradedBelief:
    """The graded readings of a text.

    Attributes:
        options: (action, ids) with their shares of belief, the likeliest first.
        readings: the likeliest first.
        truth: of the best reading.
    """

    options: tuple[tuple[Option, float], ...]
    readings: tuple[GradedReading, ...]
    truth: float

    def shares(self) -> dict[int, float]:
        """The share of belief of every parse that was read."""
        shares: dict[int, float] = {}
        for reading in self.readings:
            shares[reading.place] = shares.get(reading.place, 0.0) + reading.share
        return shares

    def parses(self) -> tuple[int, ...]:
        """The parses by their share of belief, the likeliest first."""
        shares = self.shares()
        return tuple(sorted(shares, key=lambda place: -shares[place]))

    def destination(self, objects: tuple[str, ...]) -> Destination | None:
        """Where the likeliest readings bring an object: what most of them agree on."""
        source = self.readings[0].reader.scene.layout.index.get(objects[0]) if objects and self.readings else None
        if source is None:
            return None
        scene = self.readings[0].reader.scene
        if len(objects) > 1 and not any(_leads(piece) for r in self.readings[:HEARD] for piece in r.told.destination):
            return None  # "stack the two red blocks": on what?
        found: dict[tuple[str, tuple[Phrase, ...]], tuple[Spot, float]] = {}
        for reading in self.readings[:HEARD]:
            told, view = reading.told, reading.reader.view
            said = view, tuple(told.destination)
            if said in found:
                found[said] = (found[said][0], found[said][1] + reading.share)
                continue
            pieces = [in_spaces(piece, scene.edge) for piece in told.destination]
            whole = in_spaces(told.whole, scene.edge) if told.whole is not None and told.kind == "place" else None
            spot = find_spot(pieces, source, reading.reader, whole)
            if spot is not None:
                found[said] = (spot, reading.share)
            elif reading is self.readings[0] and self.leads_off(objects):
                return None
        spot = agreed([(spot, share) for spot, share in found.values()], scene.edge)
        return None if spot is None else _destination(spot, source, scene)

    def leads_off(self, objects: tuple[str, ...]) -> bool:
        """Whether the likeliest reading moves an object so far that it leaves the table."""
        if len(objects) != 1 or not self.readings:
            return False
        reading = self.readings[0]
        scene = reading.reader.scene
        pieces = [in_spaces(piece, scene.edge) for piece in reading.told.destination]
        return objects[0] in scene.layout.index and leads_off(pieces, scene.layout.index[objects[0]], reading.reader)


NO_BELIEF = GradedBelief((), (), 0.0)
"""Of whom nothing was read."""


def _leads(piece: Phrase) -> bool:
    """Whether a piece of a destination tells more than the verb does."""
    return bool(piece.phrases) or any(words.directions(leaf.text) for leaf in piece.leaves) or piece.tag != "VP"


def believe(parses: Sequence[Parse], scene: Scene, history: Sequence[str] = ()) -> GradedBelief:
    """Read every likely parse with every view.

    Args:
        parses: of the text, the likeliest first.
        scene: the world.
        history: ids of the objects handled before, the latest last.
    """
    index = scene.layout.index
    handled = tuple(index[name] for name in history if name in index)
    found: list[GradedReading] = []
    for place, parse in enumerate(parses):
        if parse.probability < NEGLIGIBLE * parses[0].probability:
            continue
        for view, prior in _views(parse.tree, scene).items():
            reader = Reader(scene, view, handled)
            told = read_text(parse.tree, reader)
            if told.target is None or not told.target.any():
                continue
            weights = told.target * np.where(scene.clear, 1.0, BURIED)
            truth = float(weights.max())
            distinct = truth / float(weights.sum())
            worth = (truth + DOUBT) * distinct * parse.probability**PARSE_WEIGHT * prior
            found.append(GradedReading(place, reader, told, weights, truth, worth))
    total = sum(reading.share for reading in found)
    shared = [
        GradedReading(r.place, r.reader, r.told, r.weights, r.truth, r.share / total)
        for r in sorted(found, key=lambda r: -r.share)
    ]
    return GradedBelief(_options(shared, scene), tuple(shared), shared[0].truth if shared else 0.0)


def _views(tree: Phrase, scene: Scene) -> dict[str, float]:
    """Whose directions are meant where no side is marked, with their probabilities."""
    if scene.layout.world.speaker is None:
        return {ROBOT: 1.0}
    texts = [leaf.text for leaf in tree.leaves]
    for place, text in enumerate(texts):
        if text in words.VIEWS:
            before = texts[max(0, place - 3) : place]
            if "your" in before:
                return {ROBOT: 1.0}
            if "my" in before:
                return {SPEAKER: 1.0}
    if not any(words.directions(text) or text in _ALONG for text in texts):
        return {ROBOT: 1.0}
    named = {words.agent(text) for text in texts}
    robots = ADDRESSED if ROBOT in named and not _third_person(texts) else ONESELF if SPEAKER in named else UNMARKED
    return {ROBOT: robots, SPEAKER: 1.0 - robots}


def _third_person(texts: Sequence[str]) -> bool:
    """Whether the robot is only spoken of, not spoken to."""
    return not any(text in ("you", "your", "yours", "you're") for text in texts)


def _options(readings: Sequence[GradedReading], scene: Scene) -> tuple[tuple[Option, float], ...]:
    shares: dict[Option, float] = {}
    for reading in readings:
        told, kind = reading.told, reading.told.kind
        if told.sets:
            total = sum(weight for _, weight in told.sets)
            for mask, weight in told.sets:
                names = tuple(sorted(scene.layout.ids[i] for i in np.flatnonzero(mask)))
                shares[kind, names] = shares.get((kind, names), 0.0) + reading.share * weight / total
            continue
        for i, weight in enumerate(reading.weights / reading.weights.sum()):
            if weight > 1e-6:
                option = (kind, (scene.layout.ids[i],))
                shares[option] = shares.get(option, 0.0) + reading.share * float(weight)
    return tuple(sorted(shares.items(), key=lambda item: (-item[1], item[0])))


def _destination(spot: Spot, source: int, scene: Scene) -> Destination:
    """A spot as a destination: on what it is on, or on the table."""
    item = scene.layout.things[source]
    half = float(item.size[2]) / 2
    names = tuple(scene.layout.ids[i] for i in spot.reference)
    if spot.on:
        support = scene.layout.things[spot.reference[0]]
        height = float(support.position[2] + support.half_extents[2]) + half
    else:
        height = _table_top(scene) + half
    x, y = (float(value) for value in spot.point)
    return Destination((x, y, height), spot.relation if names else None, names)


def _table_top(scene: Scene) -> float:
    for item in scene.layout.world.objects:
        if item.type == "table":
            return float(item.position[2] + item.half_extents[2])
    return float(min((o.position[2] - o.half_extents[2] for o in scene.layout.things), default=0.0))
