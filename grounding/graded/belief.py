"""What a text asks for by its graded readings: a share of belief for every option, over all parses and viewpoints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grounding.graded.discourse import Told, read_text
from grounding.graded.reader import Reader
from grounding.language.parser import Parse
from grounding.language.tree import Phrase
from grounding.lexicon import words
from grounding.world import Array
from grounding.world.scene import ROBOT, SPEAKER, Scene

NEGLIGIBLE = 1e-3  # parses less likely than the best by this factor are not read
PARSE_WEIGHT = 0.5  # how much a parse's probability counts beside how well its reading agrees with the world
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


NO_BELIEF = GradedBelief((), (), 0.0)
"""Of whom nothing was read."""


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
        if words.is_view(text):
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
