"""What an explanation holds, as values and as JSON."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from grounding.symbols import Symbol, symbol_json

Objects = tuple[str, ...]


class Degrees(NamedTuple):
    """How well a condition holds of something; None where the condition is not of that kind.

    Attributes:
        truth: how true it is, in [0, 1].
        preference: how much it would be meant among those of which it is true, in [0, 1].
        rank: how well it has the rank that is asked for, in [0, 1].
    """

    truth: float | None = None
    preference: float | None = None
    rank: float | None = None

    def to_json(self) -> dict[str, Any]:
        """Plain values, those that there are."""
        return {name: round(value, 4) for name, value in self._asdict().items() if value is not None}


@dataclass(frozen=True)
class LineExplained:
    """A line of the meaning, and how well it holds.

    Attributes:
        text: of the line, as in `grounding.meaning.notation`.
        name: of the referent of which it tells; "" for the goal.
        degrees: of the answer and of the runner-up where it tells of what is handled, else of what is most likely
            meant there: ids with degrees. Empty where nothing was measured.
        likely: of a line that tells a sort: ids with weights beside the best, the likeliest first.
        truth: of a line that tells a sort: how well all that is said holds of the best; None for other lines.
    """

    text: str
    name: str = ""
    degrees: tuple[tuple[Objects, Degrees], ...] = ()
    likely: tuple[tuple[Objects, float], ...] = ()
    truth: float | None = None

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "line": self.text,
            "name": self.name,
            "degrees": [{"objects": list(names), **degrees.to_json()} for names, degrees in self.degrees],
            "likely": [{"objects": list(names), "weight": round(weight, 4)} for names, weight in self.likely],
            "truth": None if self.truth is None else round(self.truth, 4),
        }


@dataclass(frozen=True)
class Contribution:
    """What one thing adds to the logarithm of how likely a rival is beside the answer.

    Attributes:
        text: in words.
        weight: negative where it speaks for the answer, positive where it speaks for the rival.
        feature: of the model, "" for a reason that sums up several.
    """

    text: str
    weight: float
    feature: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        named = {"feature": self.feature} if self.feature else {}
        return {"text": self.text, "weight": round(self.weight, 3), **named}


@dataclass(frozen=True)
class Weighed:
    """What a phrase means among the objects.

    Attributes:
        kind: objects, sets, degree, place, person, table or nothing.
        likely: ids with their weights in [0, 1], the likeliest first.
        weights: of every object, for pictures.
        note: whose side it is, or who is meant; "" where there is nothing to say.
    """

    kind: str
    likely: tuple[tuple[Objects, float], ...] = ()
    weights: Mapping[str, float] = field(default_factory=dict)
    note: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "kind": self.kind,
            "likely": [{"objects": list(names), "weight": round(weight, 4)} for names, weight in self.likely],
            "weights": {name: round(weight, 4) for name, weight in self.weights.items()},
            "note": self.note,
        }


@dataclass(frozen=True)
class PhraseExplained:
    """One phrase of the parse that was taken.

    Attributes:
        text: its words.
        tag: NP, PP, VP, ...
        words: index of its first and of its last word.
        depth: 0 for the whole sentence, growing inward.
        symbols: that the result says it means, with probabilities.
        weighed: what it means among the objects; None where it says nothing of them by itself.
    """

    text: str
    tag: str
    words: tuple[int, int]
    depth: int
    symbols: tuple[tuple[Symbol, float], ...] = ()
    weighed: Weighed | None = None

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "text": self.text,
            "tag": self.tag,
            "words": list(self.words),
            "symbols": [{**symbol_json(symbol), "probability": round(p, 4)} for symbol, p in self.symbols],
            "meant": None if self.weighed is None else self.weighed.to_json(),
        }


@dataclass(frozen=True)
class Option:
    """What may have been meant.

    Attributes:
        action: pick, place or clear.
        objects: ids.
        probability: that these are meant.
    """

    action: str
    objects: Objects
    probability: float

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "action": self.action, "objects": list(self.objects), "probability": round(self.probability, 4)
        }  # fmt: skip


@dataclass(frozen=True)
class Rival:
    """An option that lost.

    Attributes:
        option: what it is.
        reasons: the conditions that hold less of it, the weightiest first.
        features: of the model that say most of it beside the answer, the weightiest first.
    """

    option: Option
    reasons: tuple[Contribution, ...] = ()
    features: tuple[Contribution, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            **self.option.to_json(),
            "lost": [reason.to_json() for reason in self.reasons],
            "features": [reason.to_json() for reason in self.features],
        }


@dataclass(frozen=True)
class Explanation:
    """Why an instruction was understood as it was.

    Attributes:
        sentence: the outcome in one sentence; "" for plain answers.
        parse: the tree that was taken, in brackets.
        probability: of that tree among the parses.
        complete: whether the grammar covers the whole text.
        mended: words that were read as others: (as written, as read).
        unknown_words: words that nobody knows.
        viewpoint: whose directions are meant where no side is marked.
        truth: how well the description holds of the answer, or of what it fits best, in [0, 1].
        nothing: how likely it is that nothing here is meant.
        missing: what is not there, in words.
        meaning: its lines.
        answer: the likeliest option; None where there is none.
        rivals: the options that lost, the likeliest first.
        phrases: outer ones first.
    """

    sentence: str = ""
    parse: str = ""
    probability: float = 0.0
    complete: bool = True
    mended: tuple[tuple[str, str], ...] = ()
    unknown_words: tuple[str, ...] = ()
    viewpoint: str = ""
    truth: float = 0.0
    nothing: float = 0.0
    missing: tuple[str, ...] = ()
    meaning: tuple[LineExplained, ...] = ()
    answer: Option | None = None
    rivals: tuple[Rival, ...] = ()
    phrases: tuple[PhraseExplained, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain values: the object `explanation` of a result that is asked for with `--explain`."""
        return {
            "sentence": self.sentence,
            "parse": self.parse,
            "probability": round(self.probability, 4),
            "complete": self.complete,
            "mended": [{"written": written, "read": read} for written, read in self.mended],
            "unknown_words": list(self.unknown_words),
            "viewpoint": self.viewpoint,
            "truth": round(self.truth, 4),
            "nothing": round(self.nothing, 4),
            "missing": list(self.missing),
            "meaning": [line.to_json() for line in self.meaning],
            "answer": None if self.answer is None else self.answer.to_json(),
            "rivals": [rival.to_json() for rival in self.rivals],
            "phrases": [phrase.to_json() for phrase in self.phrases],
        }
