"""The meaning of every phrase of an instruction, in agreement with the answer that was given."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.lexicon.words import flat
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import OBJECTS, SETS, Condition
from grounding.model.belief import Belief
from grounding.model.belief import Reading as Believed
from grounding.model.cases import Denotation
from grounding.model.phrases import PhraseReader, reader_of
from grounding.result import Destination, GroundedAction, PhraseGrounding
from grounding.symbols import (
    CONTAINER_KINDS,
    SPATIAL_REFERENCES,
    Action,
    Container,
    ObjectSymbol,
    Region,
    SpatialReference,
    Symbol,
    symbol_key,
)

LIKELY = 0.3  # a reading agrees with an answer to whose objects it gives such a part of the best one's weight
_LISTED = 0.1  # objects less likely for a phrase than this are not listed
_MOST = 6
_THINGS = ("block", "container", "pronoun", "other")
_CLAUSES = ("VP", "S", "FRAG")
_REGIONS = {"beside": "near", "touching": "near", "between": "between", "on": "top"}

Symbols = dict[Symbol, float]


def phrases_of(tree: Phrase, belief: Belief, actions: Sequence[GroundedAction]) -> tuple[PhraseGrounding, ...]:
    """Every phrase with its symbols, the likeliest first, outer phrases before inner ones.

    Words name kinds, colours, numbers and directions. Noun phrases have the objects or the arrangements that they mean,
    prepositional ones the regions, and the whole has the actions.

    Args:
        tree: the parse that was taken.
        belief: with which the answer was found.
        actions: the answer with its rivals, the likeliest first; none where there is none.
    """
    reading = _agreeing(belief, actions[0].objects) if actions else next(iter(_told(belief)), None)
    reader = None if reading is None else reader_of(reading)
    found, target = [], True
    for phrase, depth in walk(tree):
        symbols: Symbols = {symbol: 1.0 for word in phrase.words for symbol in meanings(word.text)}
        if phrase is tree and phrase.tag in _CLAUSES:
            symbols |= {_action(action): action.probability for action in actions}
        if reader is not None and phrase.tag == "NP" and read_noun(phrase).head in _THINGS:
            meant = _named(phrase, reader)
            if meant and target and actions:
                meant, target = _handled(meant, actions), False
            elif actions:
                meant = _leading(meant, actions[0].destination)
            symbols |= meant
        elif reader is not None and phrase.tag == "PP":
            symbols = _related(symbols, phrase, reader)
        ordered = sorted(symbols.items(), key=lambda item: (-item[1], symbol_key(item[0])))
        found.append(PhraseGrounding(phrase.text, phrase.tag, phrase.span, depth, tuple(ordered)))
    return tuple(found)


def walk(phrase: Phrase, depth: int = 0) -> Iterator[tuple[Phrase, int]]:
    """A phrase and all within it in preorder, each with how deep it lies."""
    yield phrase, depth
    for child in phrase.phrases:
        yield from walk(child, depth + 1)


def _told(belief: Belief) -> list[Believed]:
    return [reading for reading in belief.readings if reading.told.target is not None]


def _agreeing(belief: Belief, objects: tuple[str, ...]) -> Believed | None:
    """The likeliest reading that finds the answer likely."""
    told = _told(belief)
    for reading in told:
        assert reading.told.target is not None
        index = reading.evaluator.scene.layout.index
        weights = reading.evaluator.denote(reading.told.target).weights
        share = sum(float(weights[index[name]]) for name in objects if name in index)
        if share > LIKELY * len(objects) * float(weights.max(initial=0.0)):
            return reading
    return next(iter(told), None)


def _action(action: GroundedAction) -> Action:
    place = action.destination
    if place is None or place.relation not in SPATIAL_REFERENCES or not place.reference:
        return Action(action.action, action.objects)
    return Action(action.action, action.objects, Region(place.relation, "object", place.reference))


def _named(phrase: Phrase, reader: PhraseReader) -> Symbols:
    """The likely objects of a noun phrase, or its likely arrangements."""
    referent, denotation = reader.phrase(phrase)
    weights, ids = denotation.weights, reader.scene.layout.ids
    if referent.sort not in (OBJECTS, SETS) or not weights.any():
        return {}
    if referent.sort == SETS and referent.kinds and denotation.sets:
        likely = [(mask, chance) for mask, chance in denotation.sets if chance >= _LISTED][:_MOST]
        return {Container(_kind(referent.kinds), _names(mask, ids)): chance for mask, chance in likely}
    if referent.sort == OBJECTS:
        weights = weights / float(weights.sum())
    order = sorted(range(len(weights)), key=lambda i: -weights[i])[:_MOST]
    return {ObjectSymbol(ids[i]): min(1.0, float(weights[i])) for i in order if weights[i] >= _LISTED}


def _kind(kinds: Sequence[str]) -> str:
    """The kind of container in Γ, where a diagonal is a row."""
    return next((kind for kind in kinds if kind in CONTAINER_KINDS), "row")


def _names(mask: np.ndarray, ids: Sequence[str]) -> tuple[str, ...]:
    return tuple(name for name, inside in zip(ids, mask, strict=True) if inside)


def _handled(meant: Symbols, actions: Sequence[GroundedAction]) -> Symbols:
    """The objects of what is handled, as the answer has them."""
    best = actions[0]
    whole = next((s for s in meant if isinstance(s, Container) and set(s.objects) == set(best.objects)), None)
    if whole is not None:
        return {whole: best.probability}
    if len(best.objects) > 1:
        return {ObjectSymbol(name): best.probability for name in sorted(set(best.objects))}
    shares = {a.objects[0]: a.probability for a in actions if len(a.objects) == 1}
    return {ObjectSymbol(name): p for name, p in shares.items() if p >= _LISTED or name == best.objects[0]}


def _leading(meant: Symbols, place: Destination | None) -> Symbols:
    """The objects of a phrase, those that the answer refers to first, where they are among them."""
    named = [s for s in meant if isinstance(s, ObjectSymbol) and place is not None and s.id in place.reference]
    if not named:
        return meant
    top: Symbols = dict.fromkeys(named, max(meant.values()))
    return {**top, **{symbol: min(p, meant[named[0]]) for symbol, p in meant.items() if symbol not in top}}


def _related(symbols: Symbols, phrase: Phrase, reader: PhraseReader) -> Symbols:
    """The symbols of a prepositional phrase: the regions, sides and sets that it names, else what its words say."""
    conditions = Reader(reader.context).conditions(phrase, Noun(head="block"))
    found = {**_regions(conditions, reader), **_sides(conditions)}
    if any(condition.chooses for condition in conditions):
        found |= {s: p for inner in phrase.phrases if inner.tag == "NP" for s, p in _named(inner, reader).items()}
    if not found:
        return symbols
    return {**{symbol: p for symbol, p in symbols.items() if not isinstance(symbol, SpatialReference)}, **found}


def _sides(conditions: Sequence[Condition]) -> Symbols:
    """The sides of the table that something is said to be on, or to be counted from."""
    regions = [condition.region for condition in conditions if condition.region is not None]
    names = [name for region in regions for name in (*flat(region.names), *(["center"] if region.middle else []))]
    return {SpatialReference(name): 1.0 for name in names if name in SPATIAL_REFERENCES}


def _regions(conditions: Sequence[Condition], reader: PhraseReader) -> Symbols:
    """The regions that conditions name by what they relate to."""
    found: Symbols = {}
    for condition in conditions:
        relation = _relation(condition)
        denoted = [reader.evaluator.denote(referent) for referent in condition.of]
        if relation is None or not denoted or not all(d.weights.any() for d in denoted):
            continue
        names = tuple(name for denotation in denoted for name in _likeliest(denotation, reader.scene.layout.ids))
        kinds = condition.of[0].kinds if len(denoted) == 1 and denoted[0].sets else ()
        found[Region(relation, _kind(kinds) if kinds else "object", tuple(dict.fromkeys(names)))] = 1.0
    return found


def _relation(condition: Condition) -> str | None:
    if condition.negated:
        return None
    if condition.concept == "toward":
        names = flat(condition.words)
        return names[0] if len(names) == 1 and names[0] in SPATIAL_REFERENCES else None
    return _REGIONS.get(condition.concept)


def _likeliest(denotation: Denotation, ids: Sequence[str]) -> tuple[str, ...]:
    if denotation.sets:
        return _names(denotation.sets[0][0], ids)
    return (ids[int(np.argmax(denotation.weights))],)
