"""Single words and what they say in a destination: stacking, alignment, contact to come about, how far."""

from __future__ import annotations

from grounding.lexicon.vocabulary import vocabulary

METRES = {"centimetre": 0.01, "millimetre": 0.001, "metre": 1.0, "inch": 0.0254, "foot": 0.3048, "yard": 0.9144}


def is_stacking(word: str) -> bool:
    """Tells whether a word says that one thing comes on top of another: "stack", "story"."""
    return vocabulary().has("stacking", word)


def is_story(word: str) -> bool:
    """Tells whether a word means one block of a stack: "story"."""
    return vocabulary().has("stacking", word, "story")


def is_tall(word: str) -> bool:
    """Tells whether a word tells that a number is a height: "tall"."""
    return vocabulary().has("tallness", word)


def is_inside(word: str) -> bool:
    """Tells whether a preposition puts something into an arrangement: "in"."""
    return vocabulary().has("containment", word)


def is_aligning(word: str) -> bool:
    """Tells whether a word puts things in one row or column: "aligned"."""
    return vocabulary().has("alignment", word)


def is_linking(word: str) -> bool:
    """Tells whether a word says that things come to touch: "connects"."""
    return vocabulary().has("linking", word)


def is_toward(word: str) -> bool:
    """Tells whether a word leads nearer to something: "toward"."""
    return vocabulary().has("approach", word)


def is_face(word: str) -> bool:
    """Tells whether a noun means an outer part of a block: "edge"."""
    return vocabulary().has("face", word)


def extent(word: str) -> str | None:
    """Either "slightly" or "far" for words that tell how far without a length, None for others."""
    return vocabulary().value("extent", word)


def axis(word: str) -> str | None:
    """Either "row" or "column" for words that tell along what things are aligned, None for others."""
    return vocabulary().value("axis", word)


def leads(word: str) -> str | None:
    """The direction of a preposition that needs something to lead away from: "back" for "above"; None for others."""
    return vocabulary().value("leading", word)


def metres(word: str) -> float | None:
    """The length of a unit such as a centimetre or an inch [m], None for other words."""
    unit = vocabulary().value("unit", word)
    return None if unit is None else METRES[unit]
