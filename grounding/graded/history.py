"""What was handled before, and how people speak of it: "the block you just moved", "the same block", "another one"."""

from __future__ import annotations

import numpy as np

from grounding.language.tree import Phrase
from grounding.meaning.nouns import Noun, read_noun
from grounding.world import Array

OTHER_KIND = 0.15  # who says "the other one" without a colour mostly means another one of the same colour
_HANDLED = frozenset("moved placed put set stacked picked touched handled taken took grabbed lifted shifted dropped "
                     "used moving positioned".split())  # fmt: skip
_RECENT = frozenset("just you last before earlier previously recently already".split())
_PAST = _RECENT - {"you"}
_SAME = frozenset("same previous previously continues".split())
_POINTING = frozenset("that this those these said".split())
_THINGS = ("block", "container", "place", "table")
_CLAUSES = ("SBAR", "S", "VP", "PP", "ADJP")


def is_recalled(noun: Noun) -> bool:
    """Whether a noun phrase means what was handled before."""
    if noun.head != "block" or noun.plural or noun.other:
        return False
    if _SAME & set(noun.unknown) or tells_of_handling(noun):
        return True
    told = (noun.colors, noun.modifiers, noun.directions, noun.ordinals, noun.distance, noun.middle, noun.lone)
    return noun.text.split(" ", 1)[0] in _POINTING and not any(told)


def tells_of_handling(noun: Noun) -> bool:
    """Whether a noun phrase says that its object was handled: "the block you just moved"."""
    return noun.head == "block" and any(_tells_of_handling(modifier) for modifier in noun.modifiers)


def is_surely_recalled(noun: Noun) -> bool:
    """Whether a noun phrase can mean nothing else than what was handled: "the block you just moved"."""
    texts = {leaf.text for modifier in noun.modifiers for leaf in modifier.leaves}
    return tells_of_handling(noun) and bool(_PAST & texts)


def _tells_of_handling(phrase: Phrase) -> bool:
    """Whether a modifier tells what was done: "you just moved", "that was moved", "from before"; not where it lies."""
    if phrase.tag not in _CLAUSES:
        return False
    texts = {leaf.text for leaf in phrase.leaves}
    if texts <= {"from", "before", "earlier", "previously"}:
        return True
    things = any(p.tag == "NP" and read_noun(p).head in _THINGS for p in phrase.preorder())
    return bool(_HANDLED & texts) and (bool(_RECENT & texts) or (not things and "moved" in texts))


def latest(history: tuple[int, ...], base: Array) -> Array:
    """The object that was handled last among those that a noun's own words allow, weights (n,).

    Args:
        history: indices, the latest last.
        base: how well every object agrees with the noun's words, shape (n,).
    """
    weights = np.zeros(len(base))
    if history:
        weights[next((i for i in reversed(history) if base[i] > 0), history[-1])] = 1.0
    return weights


def others(history: tuple[int, ...], colors: tuple[str, ...], noun: Noun) -> Array:
    """How well every object is "the other one", or "another one", weights (n,).

    Args:
        history: indices, the latest last; at least one.
        colors: of all objects.
        noun: that says so.
    """
    handled = history[-1]
    weights = np.array([1.0 if noun.colors or color == colors[handled] else OTHER_KIND for color in colors])
    if not any(color == colors[handled] for i, color in enumerate(colors) if i != handled):
        weights[:] = 1.0
    weights[handled] = 0.0
    return weights
