"""Modifiers that rank: "closest to X", "farthest from you", "third from the left"."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from grounding.graded.people import distance_from
from grounding.graded.place_phrases import whole_of
from grounding.graded.places import closeness
from grounding.graded.relations import distance_to
from grounding.graded.values import Effect, Membership, Rank
from grounding.meaning.nouns import Noun
from grounding.world.scene import ROBOT

if TYPE_CHECKING:
    from grounding.graded.reader import Reader


def by_distance(reader: Reader, noun: Noun, distance: str, ordinal: int | None, *, away: bool) -> list[Effect]:
    """Ranks by distance: "closest to X", "farthest from X", "furthest to the left".

    Args:
        reader: that reads the noun.
        noun: from which is measured.
        distance: "near" or "far".
        ordinal: the rank asked for, or None.
        away: whether it is measured "from" a place, not "to" it.
    """
    scene = reader.scene
    noise = 0.3 * scene.edge
    value = reader.noun(noun)
    sign = 1.0 if distance == "near" else -1.0
    if value.kind == "agent":
        return [Rank(-sign * distance_from(scene, value.agent or ROBOT), ordinal, noise)]
    if value.kind == "place" and value.place is not None:
        key = closeness(scene, value.place)
        return [Rank(-key if distance == "far" and away else key, ordinal, noise)]
    if value.kind in ("objects", "sets") and value.weights.any():
        return [Rank(-sign * distance_to(scene, value), ordinal, noise)]
    return []


def counted_from(reader: Reader, noun: Noun, ordinal: int | None) -> list[Effect]:
    """Ranks by counting from a place or from somebody: "third from the left"."""
    scene = reader.scene
    noise = 0.3 * scene.edge
    if noun.head == "block" and noun.directions and is_plain(noun):
        noun = replace(noun, head="place")  # "third from the bottom block"
    value = reader.noun(noun)
    if value.kind == "place" and value.place is not None:
        return [Rank(closeness(scene, value.place), ordinal, noise, height=value.place.upright)]
    if value.kind == "agent":
        return [Rank(-distance_from(scene, value.agent or ROBOT), ordinal, noise)]
    whole = whole_of(reader, noun) if noun.head == "place" else None
    if whole is not None and whole.kind == "sets" and whole.sets and value.place is not None:
        rank = Rank(closeness(scene, value.place), ordinal, noise, height=value.place.upright)
        return [Membership(whole.sets, whole.kinds), rank]
    if value.kind == "objects" and value.place is not None and value.weights.any():
        return [Rank(-distance_to(scene, value), ordinal, noise)]
    return []


def is_plain(noun: Noun) -> bool:
    """Whether a noun says nothing but what stands before it: "the bottom block"."""
    return not (noun.modifiers or noun.ordinals or noun.distance or noun.colors)
