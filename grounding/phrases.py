"""The meaning of every phrase of an instruction, in agreement with the answer that was given."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from grounding.inference import Hypothesis
from grounding.language.tree import Phrase
from grounding.meaning.nouns import read_noun
from grounding.meaning.referents import OBJECTS, SETS
from grounding.model.belief import Belief
from grounding.model.belief import Reading as Believed
from grounding.model.phrases import reader_of
from grounding.readings import Reading
from grounding.result import GroundedAction, PhraseGrounding
from grounding.symbols import Action, Container, ObjectSymbol, Region, Symbol, symbol_key

LIKELY = 0.3  # a reading agrees with an answer to whose objects it gives such a part of the best one's weight
_LISTED = 0.1  # objects less likely for a phrase than this are not listed
_MOST = 6

Symbols = list[tuple[Symbol, float]]


def by_factors(reading: Reading, belief: Mapping[Action, float]) -> tuple[PhraseGrounding, ...]:
    """Every phrase of a reading with the symbols it was grounded to by the factors.

    Args:
        reading: the one to tell.
        belief: shares of the actions, told instead of their probabilities by the factor alone.
    """

    def symbols_of(_: Phrase, hypothesis: Hypothesis) -> Symbols:
        found: Symbols = []
        for symbol in hypothesis.symbols:
            known = isinstance(symbol, Action) and symbol in belief
            probability = belief[symbol] if known else hypothesis.probabilities.get(symbol, 1.0)  # type: ignore[index]
            found.append((symbol, probability))
        return found

    return walked(reading, symbols_of)


def by_answer(reading: Reading, belief: Belief, actions: Sequence[GroundedAction]) -> tuple[PhraseGrounding, ...]:
    """Every phrase with kinds, labels and numbers as the factors have them, and objects as the answer does.

    Args:
        reading: by the factors, whose hypothesis speaks of other objects than the answer.
        belief: with which the answer was found; it has a reading.
        actions: the answer with its rivals, the likeliest first.
    """
    agreeing = _agreeing(belief, actions[0].objects)
    named = dict(_weighed(reading.inference.tree, agreeing))
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
            and not (isinstance(symbol, Container) and symbol.objects and not set(members) <= set(symbol.objects))
        ]
        if phrase.tag in ("VP", "S", "FRAG") and phrase is reading.inference.tree:
            kept += [(Action(a.action, tuple(sorted(a.objects))), a.probability) for a in actions]
        if phrase in named:
            found = named[phrase]
            if phrase is target:
                found = dict.fromkeys(members, actions[0].probability) if len(members) > 1 else shares
            else:
                found = _leading(found, references)
            kept += [(ObjectSymbol(name), p) for name, p in found.items() if p >= _LISTED or name in members][:_MOST]
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


def _agreeing(belief: Belief, objects: tuple[str, ...]) -> Believed:
    """The likeliest reading that finds the answer likely."""
    for reading in belief.readings:
        if reading.told.target is None:
            continue
        index = reading.evaluator.scene.layout.index
        weights = reading.evaluator.denote(reading.told.target).weights
        share = sum(float(weights[index[name]]) for name in objects if name in index)
        if share > LIKELY * len(objects) * float(weights.max(initial=0.0)):
            return reading
    return belief.readings[0]


def _weighed(tree: Phrase, reading: Believed) -> Sequence[tuple[Phrase, dict[str, float]]]:
    """Noun phrases of things with their likely objects, in preorder."""
    reader, found = reader_of(reading), []
    ids = reader.scene.layout.ids
    for phrase in tree.preorder():
        if phrase.tag != "NP" or read_noun(phrase).head not in ("block", "container", "pronoun", "other"):
            continue
        referent, denotation = reader.phrase(phrase)
        weights = denotation.weights
        if referent.sort not in (OBJECTS, SETS) or not weights.any():
            continue
        if referent.sort == OBJECTS:
            weights = weights / float(weights.sum())
        order = sorted(range(len(weights)), key=lambda i: -weights[i])
        found.append((phrase, {ids[i]: min(1.0, float(weights[i])) for i in order if weights[i] >= _LISTED}))
    return found


def walked(reading: Reading, symbols_of: Callable[[Phrase, Hypothesis], Symbols]) -> tuple[PhraseGrounding, ...]:
    """Every phrase of a reading with its symbols, the likeliest first, in preorder.

    Args:
        reading: by the factors.
        symbols_of: a phrase with its hypothesis.
    """
    found: list[PhraseGrounding] = []

    def visit(phrase: Phrase, hypothesis: Hypothesis, depth: int) -> None:
        symbols = sorted(symbols_of(phrase, hypothesis), key=lambda item: (-item[1], symbol_key(item[0])))
        found.append(PhraseGrounding(phrase.text, phrase.tag, phrase.span, depth, tuple(symbols)))
        for child, part in zip(phrase.phrases, hypothesis.children, strict=True):
            visit(child, part, depth + 1)

    visit(reading.inference.tree, reading.hypothesis, 0)
    return tuple(found)
