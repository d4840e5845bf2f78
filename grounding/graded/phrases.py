"""What every phrase was taken to mean where the answer was found with graded readings."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.graded.belief import GradedBelief, GradedReading
from grounding.graded.nouns import read_noun
from grounding.inference import Hypothesis
from grounding.language.tree import Phrase
from grounding.phrases import walked
from grounding.readings import Reading
from grounding.result import GroundedAction, PhraseGrounding
from grounding.symbols import Action, Container, ObjectSymbol, Region, Symbol

_LIKELY = 0.1  # objects less likely for a phrase than this are not listed
_MOST = 6

Symbols = list[tuple[Symbol, float]]


def by_answer(reading: Reading, graded: GradedBelief, actions: Sequence[GroundedAction]) -> tuple[PhraseGrounding, ...]:
    """Every phrase with kinds, labels and numbers as the factors have them, and objects as the graded reading does.

    Args:
        reading: by the factors, whose hypothesis speaks of other objects than the answer.
        graded: the readings that the answer was found with.
        actions: the answer with its rivals, the likeliest first.
    """
    told = _agreeing(graded, actions[0].objects)
    named = dict(_weighed(reading.inference.tree, told))
    target = next(iter(named), None)
    shares = {a.objects[0]: a.probability for a in actions if len(a.objects) == 1}
    members = tuple(sorted(set(actions[0].objects)))  # nothing depends on the order of a set
    place = actions[0].destination
    references = () if place is None else place.reference

    def symbols_of(phrase: Phrase, hypothesis: Hypothesis) -> Symbols:
        kept: Symbols = [
            (symbol, hypothesis.probabilities.get(symbol, 1.0))
            for symbol in hypothesis.symbols
            if not isinstance(symbol, ObjectSymbol | Action | Region)
            and not (isinstance(symbol, Container) and symbol.objects)
        ]
        if phrase.tag in ("VP", "S", "FRAG") and phrase is reading.inference.tree:
            kept += [(Action(a.action, tuple(sorted(a.objects))), a.probability) for a in actions]
        if phrase in named:
            found = named[phrase]
            if phrase is target:
                found = dict.fromkeys(members, actions[0].probability) if len(members) > 1 else shares
            else:
                found = _leading(found, references)
            kept += [(ObjectSymbol(name), p) for name, p in found.items() if p >= _LIKELY or name in members][:_MOST]
        return kept

    return walked(reading, symbols_of)


def _leading(found: dict[str, float], references: tuple[str, ...]) -> dict[str, float]:
    """The objects of a phrase, those that the answer refers to first, where they are among them."""
    named = [name for name in references if name in found]
    if not named or not found:
        return found
    best = max(found.values())
    top = dict.fromkeys(named, best)
    return {**top, **{name: min(p, found[named[0]]) for name, p in found.items() if name not in top}}


def _agreeing(graded: GradedBelief, objects: tuple[str, ...]) -> GradedReading:
    """The likeliest graded reading that finds the answer likely."""
    for reading in graded.readings:
        index = reading.reader.scene.layout.index
        share = sum(float(reading.weights[index[name]]) for name in objects if name in index)
        if share > 0.3 * len(objects) * float(reading.weights.max(initial=0.0)):
            return reading
    return graded.readings[0]


def _weighed(tree: Phrase, told: GradedReading) -> Sequence[tuple[Phrase, dict[str, float]]]:
    """Noun phrases of things with their likely objects, in preorder."""
    reader, found = told.reader, []
    for phrase in tree.preorder():
        if phrase.tag != "NP" or read_noun(phrase).head not in ("block", "container", "pronoun", "other"):
            continue
        value = reader.value(phrase)
        if value.kind not in ("objects", "sets") or not value.weights.any():
            continue
        weights = value.weights
        if value.kind == "objects":
            weights = weights / float(weights.sum())
        order = sorted(range(len(weights)), key=lambda i: -weights[i])
        ids = reader.scene.layout.ids
        found.append((phrase, {ids[i]: min(1.0, float(weights[i])) for i in order if weights[i] >= _LIKELY}))
    return found
