"""Colours: which objects have one that was said; where none has, one that people call by that name."""

from __future__ import annotations

import numpy as np

from grounding.lexicon.parameters import value
from grounding.world import Array
from grounding.world.scene import Scene

_ALIASES = {"purple": ("blue",), "gray": ("white", "black"), "brown": ("orange",), "pink": ("red", "purple")}
"""The basic colours are not taken for others: "red" where nothing is red means something that is not there."""


def taken_for(scene: Scene, colour: str) -> str | None:
    """The colour that is there and that a word which nothing here has is taken for, or None."""
    if colour in scene.layout.colors:
        return None
    return next((alias for alias in _ALIASES.get(colour, ()) if alias in scene.layout.colors), None)


def truth(scene: Scene, colours: tuple[str, ...]) -> Array:
    """How well every object has one of some colours, shape (n,); all have where no colour was said."""
    if not colours:
        return np.ones(scene.n)
    wanted = set(colours)
    if not wanted & scene.layout.colors:
        wanted |= {alias for colour in colours for alias in _ALIASES.get(colour, ())}
    unknown = value("colour.unknown")
    degrees = [1.0 if item.color in wanted else unknown if item.color == "unknown" else 0.0
               for item in scene.layout.things]  # fmt: skip
    return np.array(degrees, dtype=float)
