"""Readings of a modifier by what it relates to: people, places, sets and objects.

Each tells what the modifier does, or None where it is not of its kind; the first that does is taken.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from grounding.graded.modifiers.enclosing import between
from grounding.graded.modifiers.heard import Heard
from grounding.graded.people import before, distance_from
from grounding.graded.place_phrases import noun_of_whole
from grounding.graded.places import located, off_middle
from grounding.graded.relations import along, distance_to, measured, near, vertical
from grounding.graded.values import Effect, Membership, Rank, Restriction, Value
from grounding.lexicon import degrees
from grounding.lexicon import words as w
from grounding.meaning.nouns import Noun
from grounding.world.scene import ROBOT

if TYPE_CHECKING:
    from grounding.graded.reader import Reader

    ReferenceReading = Callable[[Reader, Heard, Noun, Value], list[Effect] | None]

BESIDE = 0.8
"""What is so many edges away is next to something to one half."""
TOUCHING = 0.22
"""What is so many edges away touches it to one half."""
_THINGS = ("objects", "sets")
_NEARLY = frozenset("nearly almost about".split())
_RAISED = 0.3  # who says "on the table" may mean all that is there


def _middle_of(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """In the middle of several: the middle one of them, or what lies between them."""
    if noun.head != "place" or not noun.middle or noun.directions or value.kind != "objects":
        return None
    whole = noun_of_whole(noun)
    return [Restriction(value.weights if whole is None else np.maximum(value.weights, between(reader, whole)))]


def _outside(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "outside the row", "outside of the circle", within which something may lie that is no part of it."""
    if "outside" not in heard.texts or value.kind not in _THINGS or not value.weights.any():
        return None
    if value.kind == "objects":
        return [Restriction(1.0 - value.weights / degrees.peak(value.weights))]
    chances = [chance for _, chance in value.sets]
    held = [_held(reader, mask, value.kinds) for mask, _ in value.sets]
    return [Restriction(1.0 - np.average(held, axis=0, weights=chances))] if held else None


def _held(reader: Reader, mask: np.ndarray, kinds: tuple[str, ...]) -> np.ndarray:
    """What is part of a set, or within a ring."""
    if "circle" not in kinds:
        return mask
    radii = np.linalg.norm(reader.scene.xy - reader.scene.xy[mask].mean(axis=0), axis=1)
    return np.asarray(mask | (radii < radii[mask].mean()))


def _apart(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "separated from the others"."""
    if not w.is_apart(heard.texts) or value.kind not in _THINGS or not value.weights.any():
        return None
    scene = reader.scene
    inside = value.weights / degrees.peak(value.weights) if value.kind == "sets" else np.zeros(scene.n)
    apart = 1.0 - np.maximum(near(scene, value, 1.0), inside)  # nothing is apart from what it belongs to
    return [Restriction(apart), Rank(np.where(inside > 0.5, 0.0, distance_to(scene, value)), None, scene.edge)]


def _by_somebody(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "in front of you", "near me"."""
    if value.kind != "agent":
        return None
    scene, agent = reader.scene, value.agent or ROBOT
    names = heard.directions()
    if names:
        return [before(scene, agent, names)]
    return [Rank(-distance_from(scene, agent), heard.ordinal, scene.edge)] if heard.said.distance else []


def _toward(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "behind the tower", "two blocks left of the tower"."""
    names = heard.directions()
    if not names:
        return None
    if heard.measure is not None and value.kind in (*_THINGS, "place"):
        return [Restriction(measured(reader.scene, value, names, reader.view, heard.measure, counting=heard.counting))]
    if value.kind in _THINGS:
        return [along(reader.scene, value, names, reader.view, heard.strict)]
    if value.place is not None and value.place.middle and not value.place.directions and value.kind == "place":
        return [Restriction(off_middle(reader.scene, names, reader.view, heard.strict))]
    return None


def _touching(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "touching the tower"."""
    if value.kind not in _THINGS or not any(w.is_touching(text) for text in heard.texts):
        return None
    nearly = not _NEARLY.isdisjoint(heard.texts)
    return [Restriction(near(reader.scene, value, BESIDE if nearly else TOUCHING))]


def _beside(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "next to the tower"."""
    if value.kind not in _THINGS or not any(w.is_beside(text) for text in heard.texts):
        return None
    return [Restriction(near(reader.scene, value, BESIDE))]


def _in_place(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "on the left side"; "at the end of the row" means objects already."""
    if value.kind == "place":
        return located(reader.scene, value, heard.base)
    if value.kind == "objects" and value.place is not None:
        return [Restriction(value.weights)]
    return None


def _on_table(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "on the table", where others stand on blocks."""
    if value.kind != "table" or heard.last != "on" or not reader.scene.raised.any():
        return None
    return [Restriction(np.where(reader.scene.raised, _RAISED, 1.0))]


def _in_set(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "in the row"."""
    if value.kind != "sets":
        return None
    return [Membership(value.sets, value.kinds)] if value.sets else []


def _on(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "on the red block"."""
    if value.kind != "objects" or heard.last not in ("on", "onto", "atop", "upon"):
        return None
    return [Restriction(vertical(reader.scene, value, 1.0))]


def _among(reader: Reader, heard: Heard, noun: Noun, value: Value) -> list[Effect] | None:
    """For example "of the red one"."""
    if value.kind != "objects" or heard.last not in ("of", "from", "in", "among"):
        return None
    return [Membership(((value.weights > 0.3 * value.weights.max(initial=1e-9), 1.0),))]


BY_REFERENCE: tuple[ReferenceReading, ...] = (
    _middle_of,
    _outside,
    _apart,
    _by_somebody,
    _toward,
    _touching,
    _beside,
    _in_place,
    _on_table,
    _in_set,
    _on,
    _among,
)
