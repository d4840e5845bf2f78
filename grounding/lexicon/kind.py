"""Kinds of things: which objects a noun may call by its name. A word for a kind always restricts, "object" never."""

from __future__ import annotations

import numpy as np

from grounding.lexicon import colour
from grounding.lexicon.parameters import value
from grounding.lexicon.vocabulary import vocabulary
from grounding.world import Array
from grounding.world.scene import Scene

_ENDINGS = ("s", "es")


def truth(scene: Scene, kinds: tuple[str, ...]) -> Array:
    """How well every object is of one of some kinds, shape (n,); all are where no kind was said.

    Args:
        scene: the world.
        kinds: values of the family of words, such as "pyramid".
    """
    found = [1.0 if not kinds or kind_of(item.type) in (None, *kinds) else 0.0 for item in scene.layout.things]
    return np.array(found, dtype=float)


def fitting(scene: Scene, kinds: tuple[str, ...], colours: tuple[str, ...]) -> Array:
    """How well every object is of one of some kinds and has one of some colours, shape (n,)."""
    return np.asarray(truth(scene, kinds) * colour.truth(scene, colours))


def called(scene: Scene, noun: str) -> Array:
    """How well every object is what a noun means that the table of words lacks, shape (n,): a type of the world's own.

    Args:
        scene: the world.
        noun: in lower case, also in the plural.
    """
    strange = value("kind.strange")
    found = [1.0 if is_type(noun, item.type) else strange for item in scene.layout.things]
    return np.array(found, dtype=float)


def is_type(noun: str, of: str) -> bool:
    """Whether a noun is the name of a type, or its plural."""
    name = of.lower()
    return noun == name or any(noun == name + ending for ending in _ENDINGS)


def kind_of(name: str) -> str | None:
    """The kind that a world means by its name for a type, "block" by "cube"; None where that leaves it open."""
    table, word = vocabulary(), name.lower()
    return None if table.has("thing", word) else table.value("kind", word) or word
