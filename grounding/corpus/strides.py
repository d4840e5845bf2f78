"""Whether a way in block lengths leaves the table: "nine spaces up and five to the left" is no place on a small one."""

from __future__ import annotations

import numpy as np

from grounding.corpus.words import LENGTHS, directions
from grounding.geometry.layout import Layout
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.symbols import Action, Cardinal
from grounding.world import Array

_STEPS = {"left": (0, 1), "right": (0, -1), "back": (1, 0), "front": (-1, 0), "top": (1, 0), "bottom": (-1, 0)}
_BLOCKS = frozenset("block blocks box boxes cube cubes brick bricks".split())
_FREE = 1.5  # what is this much longer than the way to the edge leaves the table, however it is measured


def leaves_table(tree: Phrase, layout: Layout, action: Action) -> bool:
    """Whether what is moved by steps from where it is would go beyond the table.

    Args:
        tree: of the text.
        layout: of the world.
        action: that it asks for.
    """
    region = action.destination
    table = next((item for item in layout.world.objects if item.type == "table"), None)
    if region is None or region.objects != action.objects or table is None:
        return False
    moved = [item for item in layout.things if item.id in action.objects]
    edge = float(np.mean([2 * item.half_extents[:2].mean() for item in moved]))
    start = np.mean([item.position[:2] for item in moved], axis=0)
    reach = table.half_extents[:2] + (_FREE - 1) * edge
    end = start + edge * _way(tree)
    return bool((np.abs(end - table.position[:2]) > reach).any())


def _way(tree: Phrase) -> Array:
    """The sum of all measured steps of a text, shape (2,) in block lengths: "up (nine spaces)", "(five) west"."""
    total = np.zeros(2)
    for phrase in tree.preorder():
        lengths = [length for child in phrase.phrases if (length := _length(child)) is not None]
        if phrase.tag == "NP" or len(lengths) != 1:
            continue
        rest = [child for child in phrase.phrases if _length(child) is None]
        named = [name for word in phrase.words for name in directions(word.text)]
        if not named and len(rest) == 1 and rest[0].tag in ("NP", "PP", "ADVP"):
            named = [name for leaf in rest[0].leaves for name in directions(leaf.text)]
        total = total + lengths[0] * np.sum([_STEPS.get(name, (0, 0)) for name in named] or [(0, 0)], axis=0)
    return total


def _length(phrase: Phrase) -> float | None:
    """How many blocks a flat noun phrase measures; None for others."""
    if phrase.tag != "NP" or phrase.phrases or phrase.words[0].text == "the":
        return None
    texts = [word.text for word in phrase.words]
    counted = [float(s.value) for text in texts for s in meanings(text) if isinstance(s, Cardinal)]
    if not counted and "half" not in texts:
        return None
    measures = len(texts) == len(counted) or bool((LENGTHS | _BLOCKS) & set(texts))
    return (sum(counted) + 0.5 * ("half" in texts)) if measures else None
