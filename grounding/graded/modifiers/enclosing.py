"""Modifiers that say among what something lies: "between the towers", "surrounded by three red blocks and a cube"."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from grounding.graded.enclosure import Part, amid
from grounding.lexicon import colour, degrees
from grounding.meaning.nouns import Noun, read_noun
from grounding.world import Array

if TYPE_CHECKING:
    from grounding.graded.reader import Reader


def between(reader: Reader, noun: Noun) -> Array:
    """How well every object lies between two, or amid several, shape (n,)."""
    return amid(reader.scene, _parts(reader, noun), surrounding=False)


def surrounded(reader: Reader, noun: Noun) -> Array:
    """How well every object is surrounded by what a noun means, by anything where it means nothing, shape (n,)."""
    parts = _parts(reader, noun)
    if not any(part.weights.any() for part in parts):
        parts = [Part(np.ones(reader.scene.n), noun.number)]
    return amid(reader.scene, parts, surrounding=True)


def _parts(reader: Reader, noun: Noun) -> list[Part]:
    """What encloses, part by part: "two green blocks and the blue one"; any of those that a plural may mean counts."""
    if noun.conjoined:
        return [part for phrase in noun.conjoined for part in _parts(reader, read_noun(phrase))]
    if len(noun.counted) > 1:
        return [Part(colour.truth(reader.scene, (color,)), number) for number, color in noun.counted]
    selected = noun.ordinals or noun.distance or noun.directions or noun.head != "block"
    value = reader.noun(noun if selected else replace(noun, plural=False, number=None, universal=False))
    several = noun.plural or noun.head != "block"
    return [Part(value.weights / degrees.peak(value.weights), noun.number or (None if several else 1))]
