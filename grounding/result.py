"""What grounding an instruction gives: outcome, actions, alternatives, and what every phrase was taken to mean."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from grounding.symbols import Symbol, symbol_json

OUTCOMES = ("grounded", "ambiguous", "no_referent", "not_understood", "answered")


@dataclass(frozen=True)
class Destination:
    """Where objects are to be placed.

    Attributes:
        position: where the first object's centre is to be, x, y, z in the world's frame in [m].
        relation: the spatial reference that words gave ("top" is on it), or None.
        reference: ids of the objects that the relation is to.
        region: other places where the words hold nearly as well, the best first; for whoever cannot serve `position`.
    """

    position: tuple[float, float, float]
    relation: str | None = None
    reference: tuple[str, ...] = ()
    region: tuple[tuple[float, float, float], ...] = field(default=(), repr=False, compare=False)

    def to_json(self) -> dict[str, Any]:
        """Plain values; relation and reference only where words gave them."""
        data: dict[str, Any] = {"position": [round(value, 6) for value in self.position]}
        if self.relation is not None:
            data["relation"] = self.relation
            data["reference"] = list(self.reference)
        return data


@dataclass(frozen=True)
class GroundedAction:
    """One thing to do.

    Attributes:
        action: pick, place or clear.
        objects: ids, in the order they are to be handled.
        probability: that this is what was meant.
        destination: of a place, else None.
        arm: "left" or "right" where it was said with which hand, else None.
    """

    action: str
    objects: tuple[str, ...]
    probability: float
    destination: Destination | None = None
    arm: str | None = None

    def to_json(self) -> dict[str, Any]:
        """Plain values, as in a result; "arm" only where it was said."""
        return {
            "action": self.action,
            "objects": list(self.objects),
            "probability": round(self.probability, 4),
            "destination": None if self.destination is None else self.destination.to_json(),
            **({} if self.arm is None else {"arm": self.arm}),
        }


@dataclass(frozen=True)
class PhraseGrounding:
    """What one phrase was taken to mean.

    Attributes:
        text: its words.
        tag: NP, PP, VP, ...
        words: index of its first and of its last word.
        depth: 0 for the whole sentence, growing inward.
        groundings: symbols with their probabilities, the likeliest first.
    """

    text: str
    tag: str
    words: tuple[int, int]
    depth: int
    groundings: tuple[tuple[Symbol, float], ...]

    def to_json(self) -> dict[str, Any]:
        """Plain values, as in a result."""
        return {
            "text": self.text,
            "tag": self.tag,
            "words": list(self.words),
            "groundings": [{**symbol_json(s), "probability": round(p, 4)} for s, p in self.groundings],
        }


@dataclass(frozen=True)
class Grounding:
    """The answer to one instruction.

    Attributes:
        instruction: as it was given.
        outcome: one of `OUTCOMES`.
        actions: what to do, in order; empty unless `outcome` is "grounded".
        alternatives: other readings, the likeliest first.
        question: that tells the alternatives apart, where the outcome is "ambiguous".
        explanation: one sentence on the outcome, for people; beside an answer, what it had to assume.
        unknown_words: words that are in neither lexicon nor treebank.
        milliseconds: how long it took.
        phrases: every phrase of the parse that was taken, outer ones first.
        mended: words that were read as others: (as written, as read).
        answer: to a question about the world, where the outcome is "answered".
    """

    instruction: str
    outcome: str
    actions: tuple[GroundedAction, ...] = ()
    alternatives: tuple[GroundedAction, ...] = ()
    question: str | None = None
    explanation: str = ""
    unknown_words: tuple[str, ...] = ()
    milliseconds: float = 0.0
    phrases: tuple[PhraseGrounding, ...] = field(default=(), repr=False)
    mended: tuple[tuple[str, str], ...] = ()
    answer: str | None = None

    def timed(self, milliseconds: float) -> Grounding:
        """The same answer with the time it took."""
        return replace(self, milliseconds=milliseconds)

    def to_json(self) -> dict[str, Any]:
        """Plain values, the result format; "mended" only where words were, "answer" only to a question."""
        data: dict[str, Any] = {
            "instruction": self.instruction,
            "outcome": self.outcome,
            "actions": [action.to_json() for action in self.actions],
            "alternatives": [action.to_json() for action in self.alternatives],
            "question": self.question,
            "explanation": self.explanation,
            "unknown_words": list(self.unknown_words),
            "milliseconds": round(self.milliseconds, 3),
            "phrases": [phrase.to_json() for phrase in self.phrases],
        }
        if self.answer is not None:
            data["answer"] = self.answer
        if self.mended:
            data["mended"] = [list(pair) for pair in self.mended]
        return data
