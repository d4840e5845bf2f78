"""What an explanation holds, as values and as JSON."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from grounding.symbols import Symbol, symbol_json

Objects = tuple[str, ...]


@dataclass(frozen=True)
class Contribution:
    """What one thing adds to the log odds or to the log of a weight.

    Attributes:
        text: in words.
        weight: positive where it speaks for, negative where it speaks against.
    """

    text: str
    weight: float

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {"text": self.text, "weight": round(self.weight, 3)}


@dataclass(frozen=True)
class Judged:
    """A symbol and the features that decided upon it.

    Attributes:
        symbol: that a phrase was taken to mean, or a runner-up.
        probability: of its correspondence with the phrase, given the children's groundings.
        log_odds: the sum of all its features' weights.
        pros: the features with the largest positive weights, a fact of the context crossed with a role of the symbol.
        cons: those with the most negative weights.
    """

    symbol: Symbol
    probability: float
    log_odds: float
    pros: tuple[Contribution, ...] = ()
    cons: tuple[Contribution, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            **symbol_json(self.symbol),
            "probability": round(self.probability, 4),
            "log_odds": round(self.log_odds, 3),
            "for": [pro.to_json() for pro in self.pros],
            "against": [con.to_json() for con in self.cons],
        }


@dataclass(frozen=True)
class Weighed:
    """What a phrase is worth in the graded reading.

    Attributes:
        kind: objects, sets, order, degree, place, agent, table or nothing.
        likely: ids with their weights in [0, 1], the likeliest first; of an order those that come first.
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
        symbols: that it was taken to mean, the likeliest first.
        weighed: what it is worth in the graded reading; None where that reads it together with another phrase.
        rival: the likeliest symbol of the same family that it was not taken to mean.
        lost: why that lost: what it lacks or has beside the symbol that was chosen.
    """

    text: str
    tag: str
    words: tuple[int, int]
    depth: int
    symbols: tuple[Judged, ...]
    weighed: Weighed | None = None
    rival: Judged | None = None
    lost: tuple[Contribution, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "text": self.text,
            "tag": self.tag,
            "words": list(self.words),
            "symbols": [judged.to_json() for judged in self.symbols],
            "graded": None if self.weighed is None else self.weighed.to_json(),
            "runner_up": None
            if self.rival is None
            else {**self.rival.to_json(), "lost": [reason.to_json() for reason in self.lost]},
        }


@dataclass(frozen=True)
class Option:
    """What may have been meant.

    Attributes:
        action: pick, place or clear.
        objects: ids.
        probability: that these are meant.
        graded: its share of belief by the graded readings.
        factors: its share by the factors.
    """

    action: str
    objects: Objects
    probability: float
    graded: float
    factors: float

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "action": self.action,
            "objects": list(self.objects),
            "probability": round(self.probability, 4),
            "graded": round(self.graded, 4),
            "factors": round(self.factors, 4),
        }


@dataclass(frozen=True)
class Rival:
    """An option that lost.

    Attributes:
        option: what it is.
        reasons: why it lost, the weightiest first; a weight is the logarithm of how many times better the answer is.
        features: the same by the factors: what it lacks or has beside the answer.
    """

    option: Option
    reasons: tuple[Contribution, ...]
    features: tuple[Contribution, ...]

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
        complete: whether the grammar covers the whole text.
        mended: words that were read as others: (as written, as read).
        unknown_words: words that nobody knows.
        viewpoint: whose directions are meant where no side is marked.
        truth: how well the description holds of what it fits best, in [0, 1].
        answer: the likeliest option; None where there is none.
        rivals: the options that lost, the likeliest first.
        phrases: outer ones first.
        factors_alone: what the factors would have meant by themselves, where that is something else than the answer.
    """

    sentence: str
    parse: str
    complete: bool
    mended: tuple[tuple[str, str], ...]
    unknown_words: tuple[str, ...]
    viewpoint: str
    truth: float
    answer: Option | None
    rivals: tuple[Rival, ...]
    phrases: tuple[PhraseExplained, ...]
    factors_alone: tuple[Objects, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain values: the object `explanation` of a result that is asked for with `--explain`."""
        return {
            "sentence": self.sentence,
            "parse": self.parse,
            "complete": self.complete,
            "mended": [{"written": written, "read": read} for written, read in self.mended],
            "unknown_words": list(self.unknown_words),
            "viewpoint": self.viewpoint,
            "truth": round(self.truth, 4),
            "answer": None if self.answer is None else self.answer.to_json(),
            "factors_alone": [list(objects) for objects in self.factors_alone],
            "rivals": [rival.to_json() for rival in self.rivals],
            "phrases": [phrase.to_json() for phrase in self.phrases],
        }
