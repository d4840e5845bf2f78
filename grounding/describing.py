"""Describes objects for people: what tells one from the others, and what is missing in a world."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.geometry.layout import Layout
from grounding.geometry.masks import single
from grounding.numbers import listed, spelled

_EXTREMES = {
    "left": "leftmost", "right": "rightmost", "near": "nearest", "far": "farthest", "center": "middle",
}  # fmt: skip
_APART = 0.5  # sets whose middles are less apart are not told by where they lie [edges]
_RANKS = ("", "", "second ", "third ", "fourth ", "fifth ", "sixth ")


def name_object(layout: Layout, object_id: str, among: Sequence[str] = ()) -> str:
    """A phrase that tells an object from others.

    Args:
        layout: the world.
        object_id: which one.
        among: ids of what it could be confused with; all things of its type by default.
    """
    if object_id not in layout.index:
        return f"the {layout.world[object_id].type}"
    index = layout.index[object_id]
    item = layout.things[index]
    if among:  # what holds among all things is better to say than what holds among those in question
        name = name_object(layout, object_id)
        if not name.endswith(object_id):
            return name
    rivals = layout.mask(among) | 1 << index if among else layout.matching(item.type, None)
    noun = item.type
    if item.color != "unknown":
        same = rivals & layout.matching(item.type, item.color)
        coloured = f"{item.color} {noun}"
        if single(same):
            return f"the {coloured}"
        if same != rivals:
            rivals, noun = same, coloured
    for rank in range(1, len(_RANKS)):
        for direction, word in _EXTREMES.items():
            if direction == "center" and rank > 1:
                continue  # nobody counts outward from the middle
            if layout.nth(rivals, direction, rank) == 1 << index:
                return f"the {_RANKS[rank]}{word} {noun}"
    return f"the {noun} {object_id}"


def told_by_side(layout: Layout, sets: Sequence[Sequence[str]]) -> tuple[str, ...]:
    """Words that tell sets of objects apart by where their middles lie as the robot sees them: "leftmost", "nearest".

    Args:
        layout: the world.
        sets: ids of each, at least two.

    Returns:
        a word for each set; none where their middles coincide.
    """
    best: tuple[float, tuple[str, ...]] = (_APART * layout.edge, ())
    for first, last in (("left", "right"), ("near", "far")):
        middles = np.array([layout.mean_extent(layout.mask(names), first) for names in sets])
        order = np.argsort(-middles, kind="stable")
        gap = float(-np.diff(middles[order]).max())  # of those that are closest to each other
        if gap > best[0]:
            words = [_EXTREMES[first], *_RANKS[2:], _EXTREMES[last]]
            best = (gap, tuple(_side(int(place), len(sets), words) for place in np.argsort(order, kind="stable")))
    return best[1]


def _side(place: int, count: int, words: Sequence[str]) -> str:
    """The word for one of several that are ordered along a direction."""
    if place in (0, count - 1):
        return words[0] if place == 0 else words[-1]
    return "middle" if count == 3 else f"{words[place]}{words[0]}"


def name_objects(layout: Layout, ids: Sequence[str], among: Sequence[str] = ()) -> str:
    """A phrase for several objects."""
    if len(ids) == 1:
        return name_object(layout, ids[0], among)
    mask = layout.mask(ids)
    for arrangement in layout.arrangements:
        if arrangement.mask == mask and arrangement.kind != "group":
            return f"the {arrangement.kind} of {spelled(len(ids))}"
    if len(ids) > 3:
        ends = [layout.nth(mask, direction, 1) for direction in ("left", "right")]
        first, last = (name_object(layout, layout.names(end)[0]) for end in ends)
        return f"the {spelled(len(ids))} from {first} to {last}"
    return listed([name_object(layout, i) for i in ids])
