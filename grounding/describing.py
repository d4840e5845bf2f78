"""Describes objects for people: what tells one from the others, and what is missing in a world."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.geometry.layout import Layout
from grounding.geometry.masks import single
from grounding.symbols import Container, ContainerAttribute, ObjectAttribute, Symbol, symbol_key

_EXTREMES = {
    "left": "leftmost", "right": "rightmost", "near": "nearest", "far": "farthest", "center": "middle",
}  # fmt: skip
_RANKS = ("", "", "second ", "third ", "fourth ", "fifth ", "sixth ")
_KIND_NAMES = {"group": "group", "row": "row", "column": "column", "circle": "circle", "tower": "tower"}


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


def name_objects(layout: Layout, ids: Sequence[str], among: Sequence[str] = ()) -> str:
    """A phrase for several objects."""
    if len(ids) == 1:
        return name_object(layout, ids[0], among)
    mask = layout.mask(ids)
    for arrangement in layout.arrangements:
        if arrangement.mask == mask and arrangement.kind != "group":
            return f"the {arrangement.kind} of {len(ids)}"
    if len(ids) > 3:
        ends = [layout.nth(mask, direction, 1) for direction in ("left", "right")]
        first, last = (name_object(layout, layout.names(end)[0]) for end in ends)
        return f"the {len(ids)} from {first} to {last}"
    names = [name_object(layout, i) for i in ids]
    return ", ".join(names[:-1]) + f" and {names[-1]}"


def too_few(layout: Layout, symbols: frozenset[Symbol]) -> str | None:
    """Whether a phrase ranks an object beyond what there is; says so, or None."""
    for symbol in sorted(symbols, key=symbol_key):
        if isinstance(symbol, ObjectAttribute) and symbol.index is not None:
            told = " ".join(filter(None, (symbol.color, symbol.object_type or "object")))
            count = layout.matching(symbol.object_type, symbol.color).bit_count()
            if 0 < count < symbol.index:
                return f"there is no {told} number {symbol.index}; there are {count}"
    return None


def whats_missing(layout: Layout, symbols: frozenset[Symbol], child_symbols: frozenset[Symbol]) -> str | None:
    """Why a phrase with these symbols means nothing here; None where nothing is seen to be missing.

    Args:
        layout: the world.
        symbols: of the phrase.
        child_symbols: of its children, all together.
    """
    if not layout.size:
        return "there is nothing on the table"
    for symbol in (*symbols, *child_symbols):
        if isinstance(symbol, ObjectAttribute | ContainerAttribute):
            told = symbol.object_type or "block"
            matching = layout.matching(symbol.object_type, symbol.color)
            if not matching and symbol.color is not None and layout.matching(symbol.object_type, None):
                colors = sorted(item.color for item in layout.things if symbol.object_type in (None, item.type))
                return f"there is no {symbol.color} {told}; what is here is {_listed(sorted(set(colors)))}"
            if not matching:
                return f"there is no {told} here; the world has {_listed(sorted({o.type for o in layout.things}))}"
    few = too_few(layout, symbols | child_symbols)
    if few is not None:
        return few
    kinds = sorted({s.kind for s in symbols | child_symbols if isinstance(s, Container) and not s.objects})
    counts = {s.number for s in symbols | child_symbols if isinstance(s, ContainerAttribute) and s.number}
    for kind in kinds:
        if kind == "robot":
            continue
        known = sorted(
            a.count for a in layout.prominent(a for a in layout.arrangements if a.kind == kind and a.evident)
        )
        name = _KIND_NAMES[kind]
        if not known:
            return f"there is no {name} here"
        if counts and not counts & set(known):
            wanted = min(counts)
            return f"there is no {name} of {wanted}; the largest has {known[-1]}"
    return None


def _listed(words: Sequence[str]) -> str:
    if not words:
        return "nothing"
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + f" and {words[-1]}"
