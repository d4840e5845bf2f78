"""Taking back: "not that one" and "no, the other one" after something was done, with no question open."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from grounding.answers import FILLING, NO, words_of
from grounding.geometry.layout import Layout
from grounding.pooling import Pooled

LEFT = 0.05  # once what was done is denied, options that are so much less likely than the best are left
_OTHER = frozenset(("other", "another"))
_WRONG = "wrong"


def denies(text: str) -> bool:
    """Whether a text takes back what was just done and says no more than that another one is meant: "not that one"."""
    words = words_of(text)
    told = set(words) - FILLING
    return bool(told) and told <= NO | _OTHER and (words[0] in NO or _WRONG in told)


def others_than(options: Sequence[Pooled], denied: Iterable[str], layout: Layout) -> tuple[Pooled, ...]:
    """What else may be meant, the likeliest first; where something has the colour of what was denied, only that.

    Args:
        options: all that a text may speak of, the likeliest first.
        denied: ids of what is not meant.
        layout: the world, measured.
    """
    wrong = set(denied)
    rest = [option for option in options if not wrong & set(option.objects)]
    alike = [option for option in rest if _colors(option.objects, layout) == _colors(wrong, layout)] or rest
    return tuple(option for option in alike if option.probability >= LEFT * alike[0].probability)


def points_at_other(text: str, options: Sequence[Pooled], denied: Iterable[str], layout: Layout) -> bool:
    """Whether a text that denies tells which one is meant: "the other one", where one more is of the same colour."""
    alone = len(options) == 1 and _colors(options[0].objects, layout) == _colors(denied, layout)
    return alone and not _OTHER.isdisjoint(words_of(text))


def _colors(names: Iterable[str], layout: Layout) -> frozenset[str]:
    return frozenset(layout.world[name].color for name in names)
