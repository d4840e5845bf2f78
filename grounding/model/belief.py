"""What a text asks for: its readings, over parses and viewpoints, become one distribution over what may be meant."""

from __future__ import annotations

from collections.abc import Mapping, MutableMapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from grounding.language.parser import Parse
from grounding.language.tree import Phrase
from grounding.lexicon.degrees import peak
from grounding.lexicon.parameters import value
from grounding.meaning.discourse.following import read_text
from grounding.meaning.discourse.told import Told
from grounding.meaning.nouns import is_measuring, read_noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import OBJECTS, SETS
from grounding.model.cases import Case, Weights, doubts_of
from grounding.model.evaluator import EVEN, Evaluator
from grounding.model.features import BINS, logarithm
from grounding.model.surroundings import context_in
from grounding.model.views import views
from grounding.world import Array
from grounding.world.scene import SPEAKER, Scene

NEGLIGIBLE = 1e-3  # parses less likely than the best by this factor are not read
FAMILIAR = 16  # texts of more words are unlike those that the grammar is sure of
NOTHING: tuple[str, ...] = ()
"""The option that nothing here is meant."""

Objects = tuple[str, ...]
Seen = tuple[str, tuple[int, ...]]
"""Whose view, and the indices of what was handled before."""


@dataclass(frozen=True, eq=False)
class Reading:
    """One parse, read with one view.

    Attributes:
        place: of the parse in the list.
        evaluator: with which it was evaluated.
        told: what it tells.
        cases: that its target may be.
        nothing: the case that nothing is what it means.
        doubts: what makes it likelier that the text is misheard, by the names in `DOUBTS`.
    """

    place: int
    evaluator: Evaluator
    told: Told
    cases: tuple[Case, ...]
    nothing: Case
    doubts: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Option:
    """What is believed of one thing that may be meant.

    Attributes:
        objects: ids.
        probability: that these are meant, given that something is.
        kinds: of action with their shares, the likeliest first.
    """

    objects: Objects
    probability: float
    kinds: tuple[tuple[str, float], ...]


@dataclass(frozen=True, eq=False)
class Belief:
    """What is believed of a text.

    Attributes:
        options: ids of what may be meant with their probabilities, the likeliest first; `NOTHING` among them.
        readings: the likeliest first.
        shares: of belief, of the readings in this order.
        kinds: of action that each option is to be handled with, the likeliest first, with their shares.
    """

    options: tuple[tuple[Objects, float], ...]
    readings: tuple[Reading, ...]
    shares: tuple[float, ...]
    kinds: dict[Objects, tuple[tuple[str, float], ...]]

    @property
    def nothing(self) -> float:
        """How likely it is that nothing here is meant."""
        return self.probability(NOTHING) if self.options else 1.0

    @property
    def is_empty(self) -> bool:
        """Whether it is likelier that nothing here is meant than any single thing."""
        return bool(self.options) and self.options[0][0] == NOTHING

    def probability(self, objects: Objects) -> float:
        """How likely some objects are what is meant."""
        return next((share for names, share in self.options if names == objects), 0.0)

    def parses(self) -> tuple[int, ...]:
        """The places of the parses that were read, by their share of belief, the likeliest first."""
        shares: dict[int, float] = {}
        for reading, share in zip(self.readings, self.shares, strict=True):
            if reading.place >= 0:
                shares[reading.place] = shares.get(reading.place, 0.0) + share
        return tuple(sorted(shares, key=lambda place: -shares[place]))

    @property
    def leaves_choice(self) -> bool:
        """Whether the likeliest reading asks for any one of several: "a red block", "any block of the row"."""
        target = self.readings[0].told.target if self.readings else None
        return target is not None and target.sort == OBJECTS and not target.definite

    @property
    def on_another_table(self) -> bool:
        """Whether what is asked for is said to be on one of several tables where nothing of its kind is."""
        reading = self.readings[0] if self.readings else None
        target = None if reading is None else reading.told.target
        said = () if target is None else target.conditions
        if reading is None or not any(c.concept == "on_table" and c.of and not c.negated for c in said):
            return False
        return max((peak(case.truth) for case in reading.cases), default=0.0) <= 2 * value("answer.floor")

    @property
    def agreement(self) -> float:
        """How well what is handled agrees with the world, by the likeliest reading and by those of the speaker."""
        asked = [r for i, r in enumerate(self.readings) if not i or r.evaluator.view == SPEAKER]
        return max((r.evaluator.denote(r.told.target).truth for r in asked if r.told.target is not None), default=0.0)

    def listed(self) -> tuple[Option, ...]:
        """All that may be meant, the likeliest first, given that something is."""
        something = max(1.0 - self.nothing, 1e-12)
        return tuple(
            Option(names, min(share / something, 1.0), self.kinds[names]) for names, share in self.options if names
        )


NO_BELIEF = Belief((), (), (), {})
"""The belief in nothing of a text that nobody read."""


def read(
    parses: Sequence[Parse], scene: Scene, history: Sequence[str] = (), weights: Weights = EVEN,
    known: MutableMapping[Seen, Evaluator] | None = None,
) -> tuple[Reading, ...]:  # fmt: skip
    """Read every likely parse with every view.

    Args:
        parses: of the text, the likeliest first.
        scene: the world.
        history: ids of the objects handled before, the latest last.
        weights: of features, for what is spoken of on the way.
        known: evaluators of the same scene and weights from texts before, to which those of this text are added.
    """
    index = scene.layout.index
    handled = tuple(index[name] for name in history if name in index)
    known = {} if known is None else known
    evaluators: dict[str, Evaluator] = {}
    context = context_in(scene, handled)
    doubts = doubts_of(len(parses[0].tree.leaves), len(parses[0].unknown_words)) if parses else {}
    found = []
    for place, parse in enumerate(parses):
        if parse.probability < NEGLIGIBLE * parses[0].probability:
            continue
        told = read_text(parse.tree, Reader(context))
        if told.target is None:
            continue
        for view, form in views(parse.tree, scene):
            if view not in evaluators:
                seen = known.setdefault((view, handled), Evaluator(scene, view, handled, weights))
                evaluators[view] = seen.renewed()
            evaluator = evaluators[view]
            cases = evaluator.candidates(told.target)
            nothing = Case(1, np.ones(1))
            within = evaluator.truth_within(told.target)
            goal = _goal(told, evaluator)
            for case in cases:
                _note(case, parse, parses[0], told, form)
                case.note(f"target.{_shape(told)}.{told.kind}")
                _note_within(case, "within", within)
            _note(nothing, parse, parses[0], told, form)
            _note_within(nothing, "nothing.within", within)
            nothing.note("nothing")
            nothing.note("nothing.words", len(parse.tree.leaves) / 10)
            for name, truth in goal.items():
                for limit in BINS:
                    if truth < limit:
                        nothing.note(f"nothing.{name}<{limit}")
            nothing.note("nothing.several" if told.target.sort == SETS else "nothing.one")
            for case in cases:
                _fit(case)
            found.append(Reading(place, evaluator, told, tuple(cases), nothing, doubts))
    return tuple(found)


def _note(case: Case, parse: Parse, best: Parse, told: Told, form: str) -> None:
    """Note what a reading says as a whole."""
    name = "parse" if len(parse.tree.leaves) <= FAMILIAR else "parse.long"
    case.note(name, float(np.log(parse.probability / best.probability)))
    if form:
        case.note(f"view.{form}")
    if told.doubt:
        case.note("doubt", float(told.doubt))
    if parse.tree.tag == "FRAG":
        case.note("fragment")


def _note_within(case: Case, name: str, within: float) -> None:
    """Note how well what is spoken of on the way is there."""
    case.note(name, float(logarithm(np.array([within]))[0]))
    for limit in BINS:
        if within < limit:
            case.note(f"{name}<{limit}")


def _shape(told: Told) -> str:
    """What sort of thing the target is."""
    target = told.target
    assert target is not None
    return "one" if target.sort != SETS else "arrangement" if target.kinds else "several"


def _goal(told: Told, evaluator: Evaluator) -> dict[str, float]:
    """The smallest truths of the things that a destination speaks of, definite ones and others."""
    reader = Reader(context_in(evaluator.scene, evaluator.history, told.target))
    found: dict[str, float] = {}
    for phrase in told.destination:
        for inner in _outermost(phrase):
            noun = read_noun(inner)
            if noun.head in ("block", "container") and not is_measuring(noun):
                referent = reader.refer(noun)
                name = "goal" if noun.definite else "goal.some"
                found[name] = min(found.get(name, 1.0), evaluator.denote(referent).truth)
    return found


def _outermost(phrase: Phrase) -> list[Phrase]:
    """The noun phrases that are in no other one."""
    if phrase.tag == "NP":
        return [phrase]
    return [inner for child in phrase.phrases for inner in _outermost(child)]


def _fit(case: Case) -> None:
    """Note how well a case fits what it fits best, and how many it fits."""
    if case.size:
        best = peak(case.truth)
        case.note("fit", float(logarithm(np.array([best]))[0]))
        case.note("spread", -float(np.log(max(float(case.truth.sum()) / best, 1.0))))


def rows_of(reading: Reading) -> list[tuple[Objects, Case, int]]:
    """All candidates of a reading: the ids that each stands for, its case and its place there."""
    scene = reading.evaluator.scene
    ids = scene.layout.ids
    found: list[tuple[Objects, Case, int]] = [(NOTHING, reading.nothing, 0)]
    for case in reading.cases:
        for row in range(case.size):
            if case.masks is None:
                found.append(((ids[row],), case, row))
            elif case.masks[row].any():
                names = tuple(sorted(ids[i] for i in np.flatnonzero(case.masks[row])))
                found.append((names, case, row))
    return found


def believe(readings: Sequence[Reading], weights: Weights) -> Belief:
    """Weigh readings and their candidates together."""
    scored: list[list[tuple[Objects, float]]] = []
    for reading in readings:
        scores: dict[int, Array] = {id(case): case.scores(weights) for case in (*reading.cases, reading.nothing)}
        scored.append([(names, float(scores[id(case)][row])) for names, case, row in rows_of(reading)])
    if not scored:
        return NO_BELIEF
    best = max(score for rows in scored for _, score in rows)
    shares: dict[Objects, float] = {}
    kinds: dict[Objects, dict[str, float]] = {}
    worth = []
    for reading, rows in zip(readings, scored, strict=True):
        total = 0.0
        for names, score in rows:
            share = float(np.exp(score - best))
            total += share
            shares[names] = shares.get(names, 0.0) + share
            of = kinds.setdefault(names, {})
            of[reading.told.kind] = of.get(reading.told.kind, 0.0) + share
        worth.append(total)
    whole = sum(shares.values())
    order = sorted(range(len(readings)), key=lambda i: -worth[i])
    misheard = weights.mishearing(readings[0].doubts)
    told = {names: (1 - misheard) * share / whole + misheard / len(shares) for names, share in shares.items()}
    options = sorted(told.items(), key=lambda item: (-item[1], item[0]))
    ranked = {names: tuple(sorted(of.items(), key=lambda item: (-item[1], item[0]))) for names, of in kinds.items()}
    return Belief(tuple(options), tuple(readings[i] for i in order), tuple(worth[i] / whole for i in order), ranked)
