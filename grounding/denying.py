"""Taking back: "not that one" and "no, the other one" after something was done, with no question open."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from grounding.answers import FILLING, NO, words_of
from grounding.geometry.layout import Layout
from grounding.model.belief import Option

LEFT = 0.05  # once what was done is denied, options that are so much less likely than the best are left
_OTHER = frozenset(("other", "another"))
_WRONG = "wrong"


def denies(text: str) -> bool:
    """Whether a text takes back what was just done and says no more than that another one is meant: "not that one"."""
    words = words_of(text)
    told = set(words) - FILLING
    return bool(told) and told <= NO | _OTHER and (words[0] in NO or _WRONG in told)


def others_than(options: Sequence[Option], denied: Iterable[str], layout: Layout) -> tuple[Option, ...]:
    """What else may be meant, the likeliest first: what looks like the thing that was denied before anything else.

    Args:
        options: all that a text may speak of, the likeliest first; at least one.
        denied: ids of what is not meant.
        layout: the world, measured.
    """
    wrong = frozenset(denied)
    rest = [option for option in options if not wrong & set(option.objects)]
    alike = [option for option in rest if _colors(option.objects, layout) == _colors(wrong, layout)]
    if not alike and len(wrong) == 1:
        alike = [_alone(name, options[0]) for name in _same(next(iter(wrong)), layout)]
    found = alike or rest
    return tuple(option for option in found if option.probability >= LEFT * found[0].probability)


def _same(name: str, layout: Layout) -> list[str]:
    """Others of the type and the colour of a thing."""
    item = layout.world[name]
    return [other for other in layout.names(layout.matching(item.type, item.color)) if other != name]


def _alone(name: str, like: Option) -> Option:
    return Option((name,), like.probability, like.kinds)


def points_at_other(text: str, options: Sequence[Option], denied: Iterable[str], layout: Layout) -> bool:
    """Whether a text that denies tells which one is meant: "the other one", where one more is of the same colour."""
    alone = len(options) == 1 and _colors(options[0].objects, layout) == _colors(denied, layout)
    return alone and not _OTHER.isdisjoint(words_of(text))


def _colors(names: Iterable[str], layout: Layout) -> frozenset[str]:
    return frozenset(layout.world[name].color for name in names)
