"""The graded reading of phrases: every noun phrase and modifier is worth a degree for every object."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from grounding.graded import history as past
from grounding.graded.arrangements import read_arrangement
from grounding.graded.modifiers import read_effects, with_modifiers
from grounding.graded.place_phrases import read_place
from grounding.graded.selection import FAINT, select
from grounding.graded.values import SETS, Effect, Rank, Value
from grounding.language.tree import Phrase
from grounding.lexicon import colour, degrees
from grounding.lexicon import words as w
from grounding.meaning import recall
from grounding.meaning.nouns import Noun, read_noun
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

STRANGE = 0.08  # a thing called by an unknown name is hardly one of those that are there


class Reader:
    """Reads phrases in one scene with one view for unmarked directions.

    It is what the modules of places, arrangements and modifiers are given to read the phrases within theirs.

    Args:
        scene: the world.
        view: whose left is meant where nobody is named.
        history: indices of the objects handled before, the latest last.
        context: what was spoken of before, weights (n,), or None.

    Attributes:
        several: whether what was spoken of before are several.
    """

    def __init__(self, scene: Scene, view: str = ROBOT, history: tuple[int, ...] = (), context: Array | None = None):
        self.scene = scene
        self.view = view
        self.history = history
        self.context = context
        self.several = False

    def value(self, phrase: Phrase) -> Value:
        """What a noun phrase is worth."""
        return self.noun(read_noun(phrase))

    def noun(self, noun: Noun) -> Value:
        """What a noun that was read is worth."""
        n = self.scene.n
        if recall.is_recalled(noun) and (self.history or recall.is_surely_recalled(noun)):
            return Value("objects", past.latest(self.history, colour.truth(self.scene, noun.colors)))
        if noun.conjoined:
            return self._conjoined(noun)
        match noun.head:
            case "agent":
                return Value("agent", np.zeros(n), agent=noun.agent)
            case "table":
                return Value("table", np.zeros(n))
            case "pronoun":
                return self._pronoun()
            case "place":
                return read_place(self, noun)
            case "container":
                return read_arrangement(self, noun)
            case "block" | "other":
                return self._objects(noun)
        return Value("nothing", np.zeros(n))

    def value_of(self, noun: Noun) -> Array:
        """The weights of a noun."""
        return self.noun(noun).weights

    def effects(self, phrase: Phrase, base: Array) -> list[Effect]:
        """What a modifier does to the objects `base` (n,) of the noun that it follows."""
        return read_effects(self, phrase, base)

    def chosen(self, noun: Noun, base: Array) -> Value:
        """What a noun of objects and its modifiers choose from `base` (n,), how well objects agree with its words."""
        noun, effects = with_modifiers(self, noun, base)
        return select(self.scene, self.view, noun, base, effects, self._unspoken(noun))

    def everything_in(self, noun: Noun) -> Value:
        """All that lies on the table or on a side of it: what "clear the left side" means."""
        scene = self.scene
        value = self.noun(noun)
        inside = np.ones(scene.n, dtype=bool)
        for direction in value.place.directions if value.place is not None else ():
            inside &= scene.scaled @ direction > 0
        weights = inside.astype(float)
        return Value("sets", weights, ((inside, 1.0),)) if inside.any() else Value("nothing", weights)

    def within(self, noun: Noun, pool: Array) -> Array:
        """What a noun means among objects that were spoken of, weights (n,)."""
        inside = np.where(pool > 0.3 * degrees.peak(pool), 1.0, FAINT)
        return self.chosen(noun, colour.truth(self.scene, noun.colors) * inside).weights

    def ranked_again(self, target: Array, rank: Rank) -> Array:
        """Objects that were found, ranked by what is said afterwards."""
        return target * degrees.ranked(target / degrees.peak(target), rank.key, rank.ordinal or 1, rank.noise)

    def _objects(self, noun: Noun) -> Value:
        if noun.head == "other" and not (noun.modifiers or noun.colors):
            return Value("nothing", np.zeros(self.scene.n))
        if self.several and self.context is not None and _points_back(noun):
            inside = self.context > 0.3 * degrees.peak(self.context)
            return Value("sets", self.context, ((inside, 1.0),), number=noun.number)
        value = self.chosen(noun, colour.truth(self.scene, noun.colors))
        return replace(value, weights=STRANGE * value.weights) if noun.strange else value

    def _unspoken(self, noun: Noun) -> Array | None:
        """How well every object is "another one" than was spoken of; None where none is asked for."""
        if noun.other and self.context is not None:
            return 1 - 0.98 * self.context
        if noun.other and self.history:
            colors = tuple(item.color for item in self.scene.layout.things)
            return degrees.softened(past.others(self.history, colors, noun))
        return None

    def _pronoun(self) -> Value:
        if self.context is not None:
            return Value("objects", self.context)
        weights = np.zeros(self.scene.n)
        if not self.history:
            return Value("nothing", weights)
        weights[self.history[-1]] = 1.0
        return Value("objects", weights)

    def _conjoined(self, noun: Noun) -> Value:
        """Noun phrases joined with "and": more of the same thing, or two things."""
        first = read_noun(noun.conjoined[0])
        if first.head == "block" and all(not _has_noun(part) for part in noun.conjoined[1:]):
            return self.noun(replace(first, modifiers=(*first.modifiers, *noun.conjoined[1:], *noun.modifiers)))
        parts = [self.value(part) for part in noun.conjoined]
        if len(parts) == 2 and {kind for part in parts for kind in part.kinds} == {"row", "column"}:
            return _crossing(*parts)
        pools = [p.weights for p in parts if p.kind in ("objects", "sets")]
        if not pools:
            return Value("nothing", np.zeros(self.scene.n))
        found = _pairs(*pools) if len(pools) == 2 else ()
        return Value("sets", np.max(pools, axis=0), found, definite=noun.definite, number=len(parts))


def _crossing(row: Value, column: Value) -> Value:
    """Where a row and a column meet: "the second row and the third column"."""
    found = [
        (one & other, weight * chance)
        for one, weight in row.sets[:SETS]
        for other, chance in column.sets[:SETS]
        if (one & other).any()
    ]
    found.sort(key=lambda item: -item[1])
    weights = np.zeros(len(row.weights))
    for mask, weight in found:
        weights = np.maximum(weights, mask * weight)
    return Value("sets", weights, tuple(found[: 2 * SETS]))


def _pairs(one: Array, other: Array) -> tuple[tuple[np.ndarray, float], ...]:
    """The likeliest pairs of two different objects."""
    found = []
    order = [(float(one[i] * other[j]), i, j) for i in np.argsort(-one)[:4] for j in np.argsort(-other)[:4]]
    for weight, i, j in sorted(order, key=lambda item: -item[0])[:SETS]:
        if i != j and weight > 0.01:
            mask = np.zeros(len(one), dtype=bool)
            mask[[i, j]] = True
            found.append((mask, weight))
    return tuple(found)


def _points_back(noun: Noun) -> bool:
    """Whether a plural tells nothing but how many: "the two", "these four blocks"."""
    told = (noun.colors, noun.modifiers, noun.directions, noun.ordinals, noun.distance, noun.middle, noun.lone)
    return noun.plural and noun.definite and not any(told) and not noun.conjoined


def _has_noun(phrase: Phrase) -> bool:
    """Whether a noun phrase names a kind of thing itself."""
    return any(w.is_block(leaf.text) or w.containers(leaf.text) for leaf in phrase.leaves)
