"""Colours and kinds that nothing has."""

from __future__ import annotations

from grounding.lexicon import kind
from grounding.literal.reading import ReadsLiterally
from grounding.literal.values import FIRM, Missing, Unread
from grounding.meaning.nouns import Noun
from grounding.numbers import listed
from grounding.world.scene import Scene


def without(
    scene: Scene, kinds: tuple[str, ...], colors: tuple[str, ...], called: tuple[str, ...] = ()
) -> str:
    """A sentence for people: that nothing is of some kinds and colours, and what there is.

    Args:
        scene: the world.
        kinds: that were asked for.
        colors: that were asked for.
        called: the words for the kinds.
    """
    layout = scene.layout
    there = sorted({item.color for item in layout.things if item.color != "unknown"})
    if not layout.things:
        return "there is nothing on the table"
    if not kind.truth(scene, kinds).any():
        return f"there is no {listed(called or kinds, 'or')} here; the world has: {', '.join(sorted(layout.kinds))}"
    what = listed(kinds, "or") if kinds else "block" if len(layout.kinds) > 1 else next(iter(layout.kinds))
    return f"there is no {listed(colors, 'or')} {what}" + (f"; what is here is {listed(there)}" if there else "")


def lacking(reader: ReadsLiterally, kinds: tuple[str, ...], colors: tuple[str, ...]) -> Missing | Unread:
    """What is to be said of kinds and colours that nothing has: they are missing, unless others are taken for them."""
    scene = reader.scene
    if kind.fitting(scene, kinds, colors).any():
        return Unread(" ".join((*colors, *kinds)))
    told = without(scene, kinds, colors)
    return Missing(told, FIRM, Noun(head="block", types=kinds, colors=colors, text=told))
