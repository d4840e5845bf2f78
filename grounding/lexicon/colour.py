"""Colours: which objects have one that was said; where none is called so, those that people see as such.

Colours are seen and not read: "pink" is magenta where that is what comes nearest. But what has a basic term of its own
(`grounding.lexicon.shades`) is not called by another: nobody says "pink" of what is red, so that nothing pink is there.
"""

from __future__ import annotations

import numpy as np

from grounding.lexicon import shades
from grounding.lexicon.degrees import gaussian
from grounding.lexicon.parameters import value
from grounding.world import Array
from grounding.world.scene import Scene

UNKNOWN = "unknown"


def taken_for(scene: Scene, said: str) -> str | None:
    """The colour that is there and that a word which nothing here has is taken for, or None."""
    there = {shades.name_of(colour) for colour in scene.layout.colors} - {UNKNOWN}
    if said in there:
        return None
    basic = shades.colours()
    own = (said, shades.base_of(said))
    may = [colour for colour in sorted(there) if colour in own or not (colour in basic and basic[colour].basic)]
    found = min(may, key=lambda colour: shades.difference(said, colour), default=None)
    if found is None or found in own:
        return found
    return found if shades.difference(said, found) <= value("colour.farthest") else _own(there, own)


def _own(there: set[str], own: tuple[str, ...]) -> str | None:
    return next((colour for colour in own if colour in there), None)


def truth(scene: Scene, said: tuple[str, ...]) -> Array:
    """How well every object has one of some colours, shape (n,); all have where no colour was said.

    Args:
        scene: the world.
        said: names of colours, with "light-" or "dark-" before them where that was said.
    """
    if not said:
        return np.ones(scene.n)
    names = [shades.name_of(item.color) for item in scene.layout.things]
    found = np.zeros(scene.n)
    for colour in said:
        called = shades.name_of(colour)
        wanted = called if called in names else taken_for(scene, called)
        held = np.array([float(name == wanted) for name in names])
        found = np.maximum(found, _nearest(scene, called, held))
    open_to = np.array([name == UNKNOWN for name in names])
    return np.where(open_to, value("colour.unknown"), found)


def _nearest(scene: Scene, said: str, held: Array) -> Array:
    """Of objects with one name but several shades the nearest ones, where a shade was said: "the light blue one"."""
    given = {item.color for item, holds in zip(scene.layout.things, held, strict=True) if holds}
    if shades.base_of(said) == said or len(given) < 2:
        return held
    apart = np.array([shades.difference(said, item.color) if holds else np.inf
                      for item, holds in zip(scene.layout.things, held, strict=True)])  # fmt: skip
    return np.asarray(held * gaussian(apart - apart.min(), value("colour.blur")))
