"""Descriptions that tell things apart: of many that could be said, the shortest that the reader itself understands.

Every candidate is a noun phrase as a tree. It is read as if a person had said it, and the weights of what it means tell
how likely it leads to the thing that is to be described: a question made of such descriptions can be answered in its
own words.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from grounding.built_phrases import modified, modifier, noun_phrase
from grounding.describing import name_object
from grounding.language.tree import Phrase, Word
from grounding.lexicon.person import distance_from
from grounding.lexicon.relations import said
from grounding.model.cases import Weights
from grounding.model.evaluator import EVEN, Evaluator
from grounding.model.phrases import PhraseReader
from grounding.numbers import spelled
from grounding.world import Array
from grounding.world.scene import ROBOT, SPEAKER, Scene

CLEAR = 0.75  # what leads to its thing with such a share of all weight is understood
AMONG = 0.9  # and with such a share among the things in question
AMBIGUOUS = 0.65  # what leads to its thing with no greater share is not said
DOUBT = 0.2  # what a description costs that leads to other things alone
FAINT = 0.05  # things that a phrase means to a lesser degree are no rivals
HOLDS = 0.3  # what holds to a lesser degree is not said
_LANDMARKS = 8
_LARGEST = 12  # arrangements of more are not counted at sight
_NEAR = 3.0  # a thing is described by others at most so many edges away
_SIDES = {"left": "on the left", "right": "on the right", "front": "at the front", "back": "at the back"}
_RELATIONS = ("behind", "in front of", "to the left of", "to the right of", "next to")
_RANKS = ("second", "third", "fourth", "fifth", "sixth")
_SWAPPED = {"me": "you", "you": "me", "my": "your", "your": "my"}


@dataclass(frozen=True)
class Description:
    """A way to speak of a thing.

    Attributes:
        text: as the robot says it; "you" is the person.
        noun: the kind of thing in it, with its colour ("red block"), which "one" can stand for.
        cost: how long and how unusual it is.
    """

    text: str
    noun: str
    cost: float = 0.0

    def again(self) -> str:
        """As it is said where the same kind of thing has just been named."""
        return self.text.replace(self.noun, "one", 1) if self.noun else self.text


@dataclass(frozen=True)
class _Candidate:
    tree: Phrase
    noun: str
    cost: float


class Describer:
    """Describes the things of one scene.

    Args:
        scene: the world.
        weights: of features.
    """

    def __init__(self, scene: Scene, weights: Weights = EVEN) -> None:
        self.scene = scene
        views = [ROBOT] if scene.layout.world.speaker is None else [ROBOT, SPEAKER]
        self._readers = [PhraseReader(Evaluator(scene, view, weights=weights)) for view in views]
        self._worth: dict[str, Array] = {}
        self._orders: dict[str, Array] = {}
        self._arranged: list[tuple[np.ndarray, Phrase]] | None = None

    def describe(self, name: str, among: Sequence[str] = ()) -> Description:
        """The best description of a thing.

        Args:
            name: its id.
            among: ids of what it could be confused with; all things by default.
        """
        layout = self.scene.layout
        if name not in layout.index:
            return Description(name_object(layout, name), layout.world[name].type)
        index = layout.index[name]
        rivals = np.array([i != index and (not among or layout.ids[i] in among) for i in range(layout.size)])
        best: Description | None = None
        vague, share = None, AMBIGUOUS
        for candidate in self._candidates(index):
            if best is not None and candidate.cost >= best.cost:
                continue
            weights = self._weights(candidate.tree)
            held, likely = float(weights[index]), np.where(weights < FAINT, 0.0, weights)
            total, rivalled = float(likely.sum()), held + float(likely[rivals].sum())
            if held < HOLDS or held < CLEAR * total or held < AMONG * rivalled:
                if held >= HOLDS and held > share * max(rivalled, 0.7 * total):
                    share = held / max(rivalled, 0.7 * total)
                    vague = Description(_said(candidate.tree.text), candidate.noun, 1.0)
                continue
            cost = candidate.cost + DOUBT * (1 - held / float(weights.sum()))
            if best is None or cost < best.cost:
                best = Description(_said(candidate.tree.text), candidate.noun, cost)
        if best is not None:
            return best
        noun = self._noun(index)
        return vague or Description(f"the {noun} {name}", noun)

    def _weights(self, tree: Phrase) -> Array:
        """Measure how well a phrase leads to every thing, by the view that understands it worst, shape (n,)."""
        text = tree.text
        if text not in self._worth:
            found = [reader.phrase(tree).denotation for reader in self._readers]
            self._worth[text] = np.min([denotation.weights * denotation.truth for denotation in found], axis=0)
        return self._worth[text]

    def _candidates(self, index: int) -> Iterator[_Candidate]:
        """Noun phrases that may be true of a thing, the plainer ones first."""
        noun = self._noun(index)
        yield _Candidate(noun_phrase(f"the {noun}"), noun, 0.0)
        alike = self._alike(index)
        for cost, words in self._extremes(index, alike):
            yield _Candidate(noun_phrase(f"the {words} {noun}"), noun, cost)
        bare = noun_phrase(f"the {noun}")
        for cost, words in self._places(index, alike):
            yield _Candidate(modified(bare, modifier(words)), noun, cost)
        for cost, relation in self._relations(index):
            yield _Candidate(modified(bare, relation), noun, cost)
        yield from self._within(index, noun)
        for cost, words in self._ordinals(index, alike):
            yield _Candidate(noun_phrase(f"the {words} {noun}"), noun, cost)

    def _noun(self, index: int) -> str:
        """What a thing is, with its colour where colours differ."""
        item = self.scene.layout.things[index]
        coloured = len(self.scene.layout.colors) > 1 and item.color != "unknown"
        return f"{item.color} {item.type}" if coloured else item.type

    def _alike(self, index: int) -> np.ndarray:
        """The things that a thing's noun is true of as well, boolean (n,)."""
        item, layout = self.scene.layout.things[index], self.scene.layout
        return self.scene.members(layout.matching(item.type, item.color if " " in self._noun(index) else None))

    def _keys(self) -> dict[str, Array]:
        """What ranks are counted by, larger first, by their words."""
        if not self._orders:
            left = {who: self.scene.xy @ self.scene.direction("left", who) for who in (ROBOT, SPEAKER)}
            away = {who: distance_from(self.scene, who) for who in (ROBOT, SPEAKER)}
            self._orders.update({
                "leftmost": left[ROBOT], "rightmost": -left[ROBOT], "nearest": -away[ROBOT], "farthest": away[ROBOT],
                "from my left": left[SPEAKER], "from my right": -left[SPEAKER],
                "closest to me": -away[SPEAKER], "closest to you": -away[ROBOT],
                "farthest to me": away[SPEAKER], "farthest to you": away[ROBOT],
            })  # fmt: skip
        return self._orders

    def _place(self, index: int, words: str, among: np.ndarray) -> int:
        """How many of some things come before a thing, where they are counted by some words."""
        key = self._keys()[words]
        return int((among & (key > key[index])).sum())

    def _extremes(self, index: int, among: np.ndarray) -> Iterator[tuple[float, str]]:
        """Extremes that a thing may be; of those among which one other comes before it at most."""
        if len(self._readers) == 1:
            words = ("leftmost", "rightmost", "nearest", "farthest")
            yield from ((0.05, word) for word in words if self._place(index, word, among) < 2)
        yield 0.08, "middle"

    def _ranks(self, index: int, words: str, among: np.ndarray, cost: float) -> Iterator[tuple[float, str]]:
        """Ranks that a thing may have by some words, each with what it costs to say."""
        place = self._place(index, words, among)
        for number in range(max(place - 2, 0), min(place + 1, len(_RANKS))):
            yield cost + 0.1 * number, _RANKS[number]

    def _ordinals(self, index: int, among: np.ndarray) -> Iterator[tuple[float, str]]:
        words = ("nearest", "farthest") if len(self._readers) > 1 else ("leftmost", "rightmost", "nearest", "farthest")
        for word in words:
            yield from ((cost, f"{rank} {word}") for cost, rank in self._ranks(index, word, among, 0.3))

    def _places(self, index: int, among: np.ndarray) -> Iterator[tuple[float, str]]:
        if len(self._readers) == 1:
            yield from ((0.07, words) for words in _SIDES.values())
        else:  # whose left it is has to be said where people face each other
            ends = (f"{word} to {who}" for word in ("closest", "farthest") for who in ("me", "you"))
            yield from ((0.05, words) for words in ends if self._place(index, words, among) < 2)
            yield from ((0.06, f"on my {side}") for side in ("left", "right"))
            yield from ((0.2, f"farthest to my {side}") for side in ("left", "right"))
            for words in ("from my left", "from my right", "closest to me", "closest to you"):
                yield from ((cost, f"{rank} {words}") for cost, rank in self._ranks(index, words, among, 0.35))
        yield 0.15, "in the middle of the table"
        if len(self._readers) == 1:
            corners = [f"{depth} {side}" for depth in ("front", "back") for side in ("left", "right")]
            yield from ((0.2, f"in the {corner} corner") for corner in corners)

    def _relations(self, index: int) -> Iterator[tuple[float, Phrase]]:
        """Relations to what is named plainly and lies near, and to towers and rows that are the only ones."""
        scene = self.scene
        relations = _RELATIONS if len(self._readers) == 1 else ("next to",)
        gaps = scene.gaps[index]
        order = [int(i) for i in np.argsort(gaps, kind="stable") if i != index and gaps[i] < _NEAR * scene.edge]
        stacked = scene.apart[index] < 0.5 * scene.edge
        for other in order[:_LANDMARKS]:
            reference = self._landmark(other)
            if reference is None:
                continue
            if stacked[other]:
                words = ("on top of", "on") if scene.z[index] > scene.z[other] else ("under",)
                yield from ((0.08, modifier(word, reference)) for word in words)
            else:
                yield from ((0.15, modifier(word, reference)) for word in relations)
        for other in (int(i) for i in np.argsort(gaps, kind="stable") if i != index):
            reference = self._landmark(other)
            if reference is not None:
                yield from ((0.25, modifier(word, reference)) for word in said())
        for mask, name in self._arrangements():
            if not mask[index]:
                yield from ((0.14 + 0.05 * len(name.phrases), modifier(word, name)) for word in relations)
            else:
                yield 0.12, modifier("in", name)

    def _within(self, index: int, noun: str) -> Iterator[_Candidate]:
        """Places in an arrangement: "the middle block in the row of five"."""
        alike = self._alike(index)
        for mask, name in self._arrangements():
            among = alike & mask
            if not mask[index]:
                continue
            ranks = [word for _, word in self._ordinals(index, among)]
            words = ["middle", *(word for _, word in self._extremes(index, among)), "top", "bottom", *ranks]
            for place, word in enumerate(dict.fromkeys(words)):
                cost = 0.2 + 0.02 * place + 0.05 * len(name.phrases)
                yield _Candidate(modified(noun_phrase(f"the {word} {noun}"), modifier("in", name)), noun, cost)

    def _arrangements(self) -> list[tuple[np.ndarray, Phrase]]:
        """Arrangements that their kind or number singles out: their members, boolean (n,), and what they are called."""
        if self._arranged is None:
            layout, found = self.scene.layout, []
            for kind in ("tower", "row", "column", "circle"):
                evident = layout.prominent(a for a in layout.arrangements if a.kind == kind and a.evident)
                counts = [a.count for a in evident]
                for a in evident:
                    if counts.count(a.count) == 1 and a.count <= _LARGEST:
                        mask, name = self.scene.members(a.mask), noun_phrase(f"the {kind}")
                        if len(evident) == 1:
                            found.append((mask, name))
                        members = Phrase("NP", (Word(spelled(a.count), "CD", 0), Word("blocks", "NNS", 1)))
                        found.append((mask, modified(name, modifier("of", members))))
            self._arranged = found
        return self._arranged

    def _landmark(self, index: int) -> Phrase | None:
        """A thing that its colour alone singles out."""
        item = self.scene.layout.things[index]
        if item.color == "unknown" or self.scene.layout.matching(item.type, item.color) != 1 << index:
            return None
        return noun_phrase(f"the {item.color} {item.type}")


def listed_descriptions(descriptions: Sequence[Description], rest: int = 0) -> str:
    """Descriptions as alternatives: "the red block on the left or the one behind the tower".

    Args:
        descriptions: what is named.
        rest: how many more there are.
    """
    texts: list[str] = []
    last = None
    for description in descriptions:
        again = description.again()
        short = description.noun and description.noun == last and again != description.text and again != "the one"
        texts.append(again if short else description.text)
        last = description.noun
    texts = list(dict.fromkeys(texts))
    if rest > 0:
        texts.append("another one" if rest == 1 else f"one of {spelled(rest)} others")
    if len(texts) == 1:
        return texts[0]
    return f"{', '.join(texts[:-1])}{',' if len(texts) > 2 else ''} or {texts[-1]}"


def _said(text: str) -> str:
    """Words that a person would say, turned into what the robot says: "me" and "you" change places."""
    return " ".join(_SWAPPED.get(word, word) for word in text.split())
