"""What a picture of a grounding marks: the objects acted on, the containers and references of its phrases."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from grounding.pictures.palette import MARKS, Rgb
from grounding.result import GroundedAction, Grounding, PhraseGrounding
from grounding.symbols import (
    LAST,
    Action,
    Cardinal,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectColor,
    ObjectSymbol,
    ObjectType,
    Ordinal,
    Region,
    SpatialReference,
    Symbol,
)
from grounding.world import Array

EXPRESSED = 0.5
"""A symbol of this probability and more is taken to be meant, beside the likeliest."""
_MOST = len(MARKS)
_RELATIONS = {
    "top": "on", "bottom": "under", "near": "beside", "left": "left of", "right": "right of", "front": "before",
    "back": "behind", "between": "between", "center": "in the middle of", "far": "far from",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Mark:
    """Objects that a picture points out.

    Attributes:
        text: the phrase that means them.
        role: "object" (each is ringed), "container" (one line around all) or "region" (a dashed line around all).
        objects: their ids.
        probability: of the phrase's meaning.
        color: of the marking and of its text.
        destination: where they are brought to, (3,) in the world's frame in [m], or None.
        meaning: the symbol in words.
    """

    text: str
    role: str
    objects: tuple[str, ...]
    probability: float
    color: Rgb
    destination: Array | None = None
    meaning: str = ""


def expressed(phrase: PhraseGrounding) -> tuple[tuple[Symbol, float], ...]:
    """The symbols that a phrase is taken to mean: the likeliest, and every other that is likelier than not."""
    first, rest = phrase.groundings[:1], phrase.groundings[1:]
    return first + tuple(pair for pair in rest if pair[1] >= EXPRESSED)


def telling(phrase: PhraseGrounding) -> tuple[tuple[Symbol, float], ...]:
    """Of the symbols that a phrase is taken to mean, those that say most.

    Goals come before regions, these before containers, objects, what is said of them, and single labels.
    """
    found = expressed(phrase)
    best = min((_rank(symbol) for symbol, _ in found), default=0)
    return tuple(pair for pair in found if _rank(pair[0]) == best)


def _rank(symbol: Symbol) -> int:
    match symbol:
        case Action(_, objects, _):
            return 0 if objects else 7
        case Region():
            return 1
        case Container(_, objects):
            return 2 if objects else 5
        case ObjectSymbol():
            return 3
        case ObjectAttribute() | ContainerAttribute():
            return 4
    return 6


def meaning_of(symbol: Symbol) -> str:
    """A symbol in the fewest words."""
    match symbol:
        case ObjectSymbol(name) | ObjectType(name) | ObjectColor(name) | SpatialReference(name):
            return name
        case Cardinal(number):
            return str(number)
        case Ordinal(number):
            return "last" if number == LAST else f"number {number}"
        case Container(kind, objects):
            return f"{kind} of {listed(objects)}" if objects else kind
        case Region(relation, kind, objects):
            whole = "" if kind == "object" else f"the {kind} of "
            return f"{_RELATIONS[relation]} {whole}{listed(objects)}".strip()
        case ObjectAttribute(label, color, relation, index):
            return _said(color, label, relation, None if index in (None, 1) else f"number {index}")
        case ContainerAttribute(label, color, relation, number):
            return _said(None if number is None else str(number), color, label, relation)
        case Action(kind, objects, destination):
            where = "" if destination is None else meaning_of(destination)
            return " ".join(part for part in (kind, listed(objects), where) if part)
    return str(symbol)


def listed(names: Iterable[str]) -> str:
    """Names in the order in which people count: b2 before b10."""
    return " ".join(sorted(names, key=lambda name: [int(p) if p.isdigit() else p for p in re.split(r"(\d+)", name)]))


def _said(*parts: str | None) -> str:
    return " ".join(part for part in parts if part) or "anything"


def marks_of(grounding: Grounding) -> tuple[Mark, ...]:
    """The marks of a grounding, what is acted on first; of an ambiguous one its readings.

    Phrases that mean the same objects share one mark, named by the longest noun phrase among them.
    """
    if grounding.outcome != "grounded":
        readings = grounding.alternatives[:_MOST]
        return tuple(_of_action(grounding, action, MARKS[i]) for i, action in enumerate(readings))
    marks = [_of_action(grounding, action, MARKS[0]) for action in grounding.actions[:2]]
    seen = {(mark.role, frozenset(mark.objects)) for mark in marks}
    for phrase in _outermost(grounding.phrases):
        for role, objects, probability, meaning in _marked(phrase):
            key = (role, frozenset(objects))
            taken = [frozenset(mark.objects) for mark in marks if mark.role == role]
            known = any(key[1] <= other if role == "object" else key[1] >= other for other in taken)
            if key in seen or known or len(marks) >= _MOST:  # of containers the outer phrase has named the narrower one
                continue
            seen.add(key)
            marks.append(Mark(phrase.text, role, objects, probability, MARKS[len(marks)], None, meaning))
    return tuple(marks)


def _outermost(phrases: Sequence[PhraseGrounding]) -> list[PhraseGrounding]:
    """Noun phrases first, without those that a longer one with the same first word completes."""
    kept = [
        phrase
        for phrase in phrases
        if not any(
            other.tag == phrase.tag and other.words[0] == phrase.words[0] and other.words[1] > phrase.words[1]
            for other in phrases
        )
    ]
    return sorted(kept, key=lambda p: (p.tag != "NP", p.depth, p.words))


def _marked(phrase: PhraseGrounding) -> list[tuple[str, tuple[str, ...], float, str]]:
    """Roles, objects, probability and meaning of what a phrase marks."""
    found = telling(phrase)
    single = [(symbol.id, p) for symbol, p in found if isinstance(symbol, ObjectSymbol)]
    result = [
        ("container", symbol.objects, p, meaning_of(symbol))
        for symbol, p in found
        if isinstance(symbol, Container) and symbol.objects
    ]
    if single:
        names = tuple(name for name, _ in single)
        result.append(("object", names, min(p for _, p in single), " ".join(names)))
    return result


def _objects(symbol: Symbol) -> tuple[str, ...]:
    match symbol:
        case ObjectSymbol(name):
            return (name,)
        case Container(_, objects):
            return objects
    return ()


def _of_action(grounding: Grounding, action: GroundedAction, color: Rgb) -> Mark:
    named = [
        phrase
        for phrase in grounding.phrases
        if phrase.tag == "NP"
        and {name for symbol, _ in expressed(phrase) for name in _objects(symbol)} == set(action.objects)
    ]
    text = min(named, key=lambda phrase: (phrase.depth, phrase.words)).text if named else grounding.instruction
    meaning = f"{action.action} {listed(action.objects)}"
    place = action.destination
    if place is not None and place.relation is not None:
        meaning += f" {_RELATIONS.get(place.relation, place.relation)} {listed(place.reference)}".rstrip()
    if place is None:
        return Mark(text, "object", action.objects, action.probability, color, None, meaning)
    return Mark(text, "object", action.objects, action.probability, color, np.array(place.position), meaning)
