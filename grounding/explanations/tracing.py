"""A reader of graded readings that notes what every phrase was worth while a text is followed."""

from __future__ import annotations

import numpy as np

from grounding.explanations.values import Weighed
from grounding.graded.nouns import Noun
from grounding.graded.reader import Reader
from grounding.graded.values import Effect, Membership, Place, Rank, Restriction, Value
from grounding.language.tree import Phrase
from grounding.world import Array
from grounding.world.scene import SPEAKER, Scene

LIKELY = 4  # of the objects or sets that a phrase may mean, so many are told
_LEAST = 0.005

Span = tuple[int, int]


class TracedReader(Reader):
    """Reads as its base class does, and remembers.

    Attributes:
        values: of noun phrases, by their words.
        modifiers: of other phrases, by the places of their first and last words.
        spoken: what clauses name directly, in order: nouns, and modifiers that are added to what was named before.
    """

    def __init__(self, scene: Scene, view: str, history: tuple[int, ...]) -> None:
        super().__init__(scene, view, history)
        self.values: dict[str, Value] = {}
        self.modifiers: dict[Span, list[Effect]] = {}
        self.spoken: list[tuple[Noun | Phrase, Array | None]] = []
        self._inside = 0

    def noun(self, noun: Noun) -> Value:
        """See `Reader.noun`."""
        if not self._inside:
            self.spoken.append((noun, self.context))
        self._inside += 1
        value = super().noun(noun)
        self._inside -= 1
        self.values.setdefault(noun.text, value)
        return value

    def effects(self, phrase: Phrase, base: Array) -> list[Effect]:
        """See `Reader.effects`."""
        if not self._inside:
            self.spoken.append((phrase, self.context))
        self._inside += 1
        found = super().effects(phrase, base)
        self._inside -= 1
        self.modifiers.setdefault(span_of(phrase), found)
        return found

    def weighed(self, phrase: Phrase) -> Weighed | None:
        """What a phrase was worth; None where it was read together with another one."""
        value = self.values.get(phrase.text) if phrase.tag == "NP" else None
        if value is not None:
            return self._value(value)
        effects = self.modifiers.get(span_of(phrase))
        return self._effects(effects) if effects else None

    def ranked(self, weights: Array, kind: str = "objects", note: str = "") -> Weighed:
        """Objects with their weights."""
        ids = self.scene.layout.ids
        order = [int(i) for i in np.argsort(-weights, kind="stable")[:LIKELY] if weights[i] > _LEAST]
        likely = tuple(((ids[i],), float(weights[i])) for i in order)
        return Weighed(kind, likely, dict(zip(ids, np.clip(weights, 0.0, 1.0).tolist(), strict=True)), note)

    def _sets(self, sets: tuple[tuple[np.ndarray, float], ...], note: str = "") -> Weighed:
        ids = self.scene.layout.ids
        weights = np.max([mask * chance for mask, chance in sets], axis=0) if sets else np.zeros(self.scene.n)
        likely = tuple(
            (tuple(ids[i] for i in np.flatnonzero(mask)), float(chance))
            for mask, chance in sorted(sets, key=lambda item: -item[1])[:LIKELY]
        )
        return Weighed("sets", likely, dict(zip(ids, np.clip(weights, 0.0, 1.0).tolist(), strict=True)), note)

    def _value(self, value: Value) -> Weighed:
        match value.kind:
            case "sets":
                return self._sets(value.sets)
            case "objects":
                return self.ranked(value.weights)
            case "place":
                return self.ranked(value.weights, "place", "" if value.place is None else self._where(value.place))
            case "agent":
                return Weighed("agent", note=f"the {value.agent}")
        return Weighed(value.kind)

    def _where(self, place: Place) -> str:
        if not place.directions or not {"left", "right", "front", "back", "up", "down"} & set(place.names):
            return ""
        owner = place.owner if self.scene.layout.world.speaker is not None or place.owner != SPEAKER else "robot"
        return f"as the {owner} sees it"

    def _effects(self, effects: list[Effect]) -> Weighed:
        """Several effects hold together."""
        sets = [effect for effect in effects if isinstance(effect, Membership)]
        ranks = [effect for effect in effects if isinstance(effect, Rank)]
        degrees = [effect.weights for effect in effects if isinstance(effect, Restriction)]
        if ranks and not degrees and not sets:
            rank = ranks[0]
            order = [int(i) for i in np.argsort(-rank.key, kind="stable")]
            ids = self.scene.layout.ids
            weights = {ids[i]: 1.0 - place / max(len(order), 1) for place, i in enumerate(order)}
            return Weighed("order", tuple(((ids[i],), weights[ids[i]]) for i in order[:LIKELY]), weights)
        if sets and not degrees:
            return self._sets(sets[0].sets)
        total = np.prod(degrees, axis=0)
        for membership in sets:
            total = total * np.max([mask * chance for mask, chance in membership.sets], axis=0)
        return self.ranked(np.asarray(total), "degree")


def span_of(phrase: Phrase) -> Span:
    """The places of a phrase's first and last words."""
    return phrase.span
