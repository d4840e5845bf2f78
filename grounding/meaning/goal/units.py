"""Distances in metric units, said in blocks: people say "10 cm", and the clues count spaces."""

from __future__ import annotations

from itertools import pairwise

from grounding.language.tree import Phrase, Word

_METRES = {
    **dict.fromkeys("cm cms centimeter centimeters centimetre centimetres".split(), 0.01),
    **dict.fromkeys("mm millimeter millimeters millimetre millimetres".split(), 0.001),
    **dict.fromkeys("m meter meters metre metres".split(), 1.0),
    **dict.fromkeys("inch inches".split(), 0.0254),
}
_SPACE = 1.19
"""How far a space leads from where something stands [edges], as the maps of destinations have it."""


def in_spaces(phrase: Phrase, edge: float) -> Phrase:
    """A phrase whose metric distances are told in spaces.

    Args:
        phrase: of a destination.
        edge: of a block [m].
    """
    leaves = phrase.leaves
    changed: dict[int, Word] = {}
    for number, unit in pairwise(leaves):
        value = _value(number.text)
        if value is not None and unit.text in _METRES:
            steps = value * _METRES[unit.text] / (_SPACE * edge)
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
