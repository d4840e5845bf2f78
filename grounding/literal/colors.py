"""Colours that nothing has."""

from __future__ import annotations

from typing import TYPE_CHECKING

from grounding.graded.colors import colored
from grounding.graded.nouns import Noun
from grounding.literal.values import FIRM, Missing, Unread
from grounding.numbers import listed

if TYPE_CHECKING:
    from grounding.literal.reader import LiteralReader


def lacking(reader: LiteralReader, colors: tuple[str, ...]) -> Missing | Unread:
    """What is to be said of colours that nothing has: that they are missing, unless another one is taken for them."""
    scene = reader.scene
    if not colors or colored(scene, colors).any():
        return Unread(" ".join(colors))
    there = sorted({item.color for item in scene.layout.things if item.color != "unknown"})
    told = f"there is no {listed(colors, 'or')} block; what is here is {listed(there)}"
    return Missing(told, FIRM, Noun(head="block", colors=colors, text=told))
