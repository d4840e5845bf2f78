"""Distances in metric units, said in blocks: people say "10 cm", and the clues count spaces."""

from __future__ import annotations

from itertools import pairwise

from grounding.language.tree import Phrase, Word
from grounding.lexicon.whereto import metres

_SPACE = 1.19
"""The length of a space from where something stands [edges], as the maps of destinations have it."""


def in_spaces(phrase: Phrase, edge: float) -> Phrase:
    """A phrase whose metric distances are told in spaces.

    Args:
        phrase: of a destination.
        edge: of a block [m].
    """
    leaves = phrase.leaves
    changed: dict[int, Word] = {}
    for number, unit in pairwise(leaves):
        value, length = _value(number.text), metres(unit.text)
        if value is not None and length is not None:
            steps = value * length / (_SPACE * edge)
            changed[number.index] = Word(f"{steps:.2f}", "CD", number.index)
            changed[unit.index] = Word("spaces", "NNS", unit.index)
    return _with(phrase, changed) if changed else phrase


def _value(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if 0 < value < 1000 else None


def _with(phrase: Phrase, changed: dict[int, Word]) -> Phrase:
    return Phrase(phrase.tag, tuple(
        _with(child, changed) if isinstance(child, Phrase) else changed.get(child.index, child)
        for child in phrase.children
    ))  # fmt: skip
