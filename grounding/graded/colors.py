"""Which objects have a colour that was said; where none has, a colour that people call by that name."""

from __future__ import annotations

import numpy as np

from grounding.world import Array
from grounding.world.scene import Scene

_ALIASES = {"purple": ("blue",), "gray": ("white", "black"), "brown": ("orange",), "pink": ("red", "purple")}
"""The basic colours are not taken for others: "red" where nothing is red means something that is not there."""


def taken_for(scene: Scene, color: str) -> str | None:
    """The colour that is there and that a word which nothing here has is taken for, or None."""
    if color in scene.layout.colors:
        return None
    return next((alias for alias in _ALIASES.get(color, ()) if alias in scene.layout.colors), None)


def colored(scene: Scene, colors: tuple[str, ...]) -> Array:
    """One for every object of one of some colours, else zero, shape (n,); all are one where no colour was said."""
    if not colors:
        return np.ones(scene.n)
    wanted = set(colors)
    if not wanted & scene.layout.colors:
        wanted |= {alias for color in colors for alias in _ALIASES.get(color, ())}
    has = np.array([item.color in wanted or item.color == "unknown" for item in scene.layout.things])
    return np.where(has, 1.0, 0.0)
