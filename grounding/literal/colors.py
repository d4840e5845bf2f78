"""Colours that nothing has."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.geometry.layout import Layout
from grounding.lexicon import colour
from grounding.literal.reading import ReadsLiterally
from grounding.literal.values import FIRM, Missing, Unread
from grounding.meaning.nouns import Noun
from grounding.numbers import listed


def without(colors: Sequence[str], layout: Layout) -> str:
    """A sentence for people: that nothing has one of some colours, and which there are."""
    there = sorted({item.color for item in layout.things if item.color != "unknown"})
    if not layout.things:
        return "there is nothing on the table"
    return f"there is no {listed(colors, 'or')} block" + (f"; what is here is {listed(there)}" if there else "")


def lacking(reader: ReadsLiterally, colors: tuple[str, ...]) -> Missing | Unread:
    """What is to be said of colours that nothing has: that they are missing, unless another one is taken for them."""
    scene = reader.scene
    if not colors or colour.truth(scene, colors).any():
        return Unread(" ".join(colors))
    told = without(colors, scene.layout)
    return Missing(told, FIRM, Noun(head="block", colors=colors, text=told))
