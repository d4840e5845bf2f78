"""Noun phrases of places: "the left side", "the middle of the row", "your right"."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from grounding.graded.places import in_place, make_place, part_of
from grounding.graded.values import Restriction, Value
from grounding.lexicon import degrees
from grounding.meaning.nouns import Noun, read_noun

if TYPE_CHECKING:
    from grounding.graded.reader import Reader

_RIMS = frozenset("corner corners edge edges end ends border boundary".split())


def read_place(reader: Reader, noun: Noun) -> Value:
    """What a noun whose head names a place is worth: a place, or the objects at the end of something."""
    scene = reader.scene
    names = list(noun.directions)
    if not names and noun.agent and not noun.middle:
        names = ["front"]  # "your side"
    whole = whole_of(reader, noun)
    some_part = "part" in noun.text.split() and not (noun.directions or noun.middle)
    if whole is not None and whole.kind == "sets" and some_part:
        return whole
    if whole is not None and whole.place is not None and whole.kind == "place":  # "the middle of the left edge"
        names += [name for name in whole.place.names if name not in names]
    middle = noun.middle or bool(whole is not None and whole.kind == "place" and whole.place and whole.place.middle)
    place = make_place(scene, names, noun.agent or reader.view, middle=middle, corner=noun.place == "corner",
                       bare=noun.place is None, rim=not _RIMS.isdisjoint(noun.text.split()))  # fmt: skip
    if whole is not None and whole.kind in ("sets", "objects") and whole.weights.any():
        return part_of(scene, place, whole)
    weights = in_place(scene, place, np.ones(scene.n))
    for modifier in noun.modifiers:
        for effect in reader.effects(modifier, np.ones(scene.n)):
            if isinstance(effect, Restriction):
                weights = weights * degrees.softened(effect.weights)
    return Value("place", weights, place=place)


def whole_of(reader: Reader, noun: Noun) -> Value | None:
    """What a place is a part of: "of the row", "its left"."""
    if reader.context is not None and noun.text.split(" ", 1)[0] == "its":
        return Value("objects", reader.context)
    whole = noun_of_whole(noun)
    return None if whole is None else reader.noun(whole)


def noun_of_whole(noun: Noun) -> Noun | None:
    """The noun of what a place is a part of."""
    for modifier in noun.modifiers:
        if modifier.tag == "PP" and [word.text for word in modifier.words][-1:] in (["of"], ["in"], ["from"]):
            for child in modifier.phrases:
                return read_noun(child)
    return None
