"""Noun phrases of arrangements, read literally."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from grounding.geometry.layout import UPRIGHT
from grounding.geometry.masks import indices_of, mask_of, single
from grounding.language.tree import Phrase
from grounding.lexicon import kind
from grounding.literal.choosing import side_of_all, toward
from grounding.literal.colors import lacking
from grounding.literal.places import names_of, says_unknown
from grounding.literal.reading import ReadsLiterally
from grounding.literal.values import FAINT, FIRM, Meant, Missing, Narrow, Order, Sided, Unread, Viewed
from grounding.literal.wider import looks_stacked
from grounding.meaning.nouns import Noun, read_noun
from grounding.numbers import counted, spelled
from grounding.symbols import LAST
from grounding.world import Array

SLANTED = 0.45  # a line that deviates from both axes by more is a diagonal [rad]
APART = 1.6  # the nearest other block is so many times farther from a group than its members are from each other
SET_APART = 0.05  # the arrangement that is meant is so much further along than the next [m]
Found = list[tuple[str, int]]
Score = Callable[[int], float]


def mean_arrangement(reader: ReadsLiterally, noun: Noun) -> Meant:
    """What a noun of an arrangement means.

    Raises:
        Unread: it is beyond what is read literally.
        Missing: there is none.
    """
    line = noun.middle and noun.text.endswith(" line")  # of the table, along which nothing need lie
    if says_unknown(noun) or noun.lone or noun.agent or line:
        raise Unread(noun.text)
    number, colors, types, rest = noun.number, noun.colors, noun.types, []
    for modifier in noun.modifiers:
        content = _content(modifier)
        if content is None:
            rest.append(modifier)
            continue
        colors, number = colors or content.colors, number or content.number
        types = types or content.types
        rest += content.modifiers  # "the row of blocks on the left" lies there as a whole
    if noun.plural or len(colors) > 1:
        raise Unread(noun.text)
    fits = kind.fitting(reader.scene, types, colors[:1])
    if not fits.any():
        raise lacking(reader, types, colors)
    stuff = mask_of(int(i) for i in np.flatnonzero(fits > 0.5))
    found = _seen(reader, noun, stuff)
    if number is None and _counts_bands(reader, noun, stuff, found):
        raise Unread("lines are counted across the table, of which one block may be one")
    if number is not None:
        found = [a for a in found if a[1].bit_count() == number]
    if not found:
        found = _faint(reader, noun, stuff, number)
    if not found:
        of = f" of {spelled(number)} blocks" if number else ""
        seen_loosely = {"group", "diagonal", "tower"} & set(noun.kinds[:1])
        text = f"there is no {' '.join((*colors[:1], noun.kinds[0]))}{of} here"
        bare = Noun(head="container", kinds=noun.kinds, colors=colors[:1], number=number, text=noun.text)
        raise Missing(text, FAINT if seen_loosely else FIRM, bare, shape=True)
    return _chosen(reader, noun, found, rest, number)


def size_of(noun: Noun) -> int | None:
    """How many members a noun of a set or of several is said to have, or None."""
    if noun.number is not None or noun.head != "container":
        return noun.number
    contents = (_content(modifier) for modifier in noun.modifiers)
    return next((content.number for content in contents if content is not None and content.number), None)


def _seen(reader: ReadsLiterally, noun: Noun, stuff: int) -> Found:
    layout = reader.layout
    slanted = {(a.kind, a.mask) for a in layout.arrangements if a.kind in ("row", "column") and a.angle > SLANTED}
    found = [(a.kind, a.mask) for a in layout.evident_of((), stuff) if a.kind != "group" or a.separation >= APART]
    diagonals = layout.prominent(
        a for a in layout.arrangements
        if (a.kind, a.mask) in slanted and a.count >= 3 and a.deviation < 0.12 and a.regularity > 0.75
        and a.separation > 0.9
    )  # fmt: skip
    found += [(a.kind, a.mask) for a in diagonals if not a.mask & ~stuff
              and not any((a.mask & mask).bit_count() > 1 for _, mask in found)]  # fmt: skip
    words = noun.text.split()
    kinds: tuple[str, ...] = noun.kinds
    if "diagonal" in kinds and "row" not in kinds or "diagonal" in words:
        return [a for a in found if a in slanted]
    if "horizontal" in words:
        kinds = ("row",)
    if "vertical" in words:
        kinds = ("column", "tower")
    line = "row" in kinds and "column" in kinds
    return [a for a in found if a[0] in kinds and (line or a not in slanted)]


def _counts_bands(reader: ReadsLiterally, noun: Noun, stuff: int, found: Found) -> bool:
    """Whether a rank or an end may be one of all bands, as some blocks stand in no line: "the third row"."""
    if not {"row", "column"} & set(noun.kinds) or "diagonal" in noun.kinds or not (noun.ordinals or names_of(noun)):
        return False
    standing = stuff & reader.layout.everything
    for _, mask in found:
        standing &= ~mask
    index = max(noun.ordinals, default=1)
    return bool(standing) and (not found or index > len(found))


def _faint(reader: ReadsLiterally, noun: Noun, stuff: int, number: int | None) -> Found:
    """What looks a little like an arrangement though it does not catch the eye.

    Raises:
        Unread: it is several things, or towers as one may see them from above.
    """
    if "tower" in noun.kinds and not reader.scene.towers:
        if looks_stacked(reader.scene, replace(noun, number=number)):
            raise Unread("no towers, but what looks like them from above")
        return []
    counts = frozenset((number,)) if number is not None else frozenset()
    found = [(a.kind, a.mask) for a in reader.layout.fitting(noun.kinds, stuff, counts) if a.noticed]
    if len(found) > 1:
        raise Unread("hardly seen")
    return found


def _content(modifier: Phrase) -> Noun | None:
    """The members that an arrangement is said to have: "of five", "of red blocks", "made of four"."""
    words = [word.text for word in modifier.words]
    inner = modifier
    while inner.tag in ("SBAR", "S", "VP") and len([p for p in inner.phrases if p.tag != "WHNP"]) == 1:
        inner = next(p for p in inner.phrases if p.tag != "WHNP")
        words += [word.text for word in inner.words]
    if inner.tag == "NP" and {"has", "have"} & set(words):
        noun = read_noun(inner)
    elif inner.tag == "PP" and words[-1:] in (["of"], ["with"], ["by"]) and len(inner.phrases) == 1:
        noun = read_noun(inner.phrases[0])
    else:
        return None
    plain = not (noun.ordinals or noun.distance or noun.directions or noun.conjoined or noun.middle)
    return noun if noun.head == "block" and plain and (noun.number or noun.plural) else None


def _chosen(reader: ReadsLiterally, noun: Noun, found: Found, rest: list[Phrase], number: int | None) -> Meant:
    layout, scene = reader.layout, reader.scene
    names = names_of(noun)
    key: Score | None = None
    side = ""
    if len(names) == 1:
        key, side = _along(reader, names[0]), names[0]
    elif names:
        key = _by(toward(scene, names))
    index = noun.ordinals[0] if noun.ordinals else None
    everything = Noun(head="block", text=noun.text)
    for modifier in rest:
        for effect in reader.modify(modifier, everything, layout.everything):
            match effect:
                case Narrow(mask):
                    found = [a for a in found if not a[1] & ~mask]
                case Sided(name, _, None):
                    if name in ("near", "far") and not names:
                        raise Unread(noun.text)
                    key, side = _along(reader, name), name
                case Order(told, None):
                    key, side = _by(told), ""
                case Viewed("robot") if names in (("near",), ("far",)):
                    pass
                case _:
                    raise Unread(noun.text)
    if not found:
        raise Missing(f"there is no such {noun.kinds[0]} here")
    if index is not None and index > len(found):
        raise Missing(f"there is no {noun.kinds[0]} number {index} here; {counted(len(found))}")
    if noun.only and len(found) > 1:
        raise Unread("not the only one")
    best = _best(found, key, index, noun)
    if best is not None and side and rest and side_of_all(scene, best[1], side) < -0.03:
        raise Unread("on the other side")
    if best is None:
        return Meant("things", plural=True, number=number, definite=noun.definite, kind=found[0][0], sets=tuple(found))
    kind = "object" if single(best[1]) else best[0]
    return Meant("things", best[1], best[1], kind, True, number, noun.definite, (best,))


def _along(reader: ReadsLiterally, name: str) -> Score:
    layout = reader.layout
    flat = UPRIGHT.get(name, name)
    if flat == "center":
        middle = layout.positions[:, :2].mean(axis=0)
        return lambda mask: -float(np.linalg.norm(layout.positions[list(indices_of(mask)), :2].mean(axis=0) - middle))
    return lambda mask: float(layout.extent(mask, flat).mean())


def _sized(order: int) -> Score:
    return lambda mask: 0.06 * order * mask.bit_count()


def _by(key: Callable[[int], Array]) -> Score:
    return lambda mask: float(key(mask).max())


def _best(found: Found, key: Score | None, index: int | None, noun: Noun) -> tuple[str, int] | None:
    """The one that is meant; None where it is open."""
    if noun.other:
        return found[0] if len(found) == 1 else None
    if len(found) == 1:
        return found[0] if index in (None, 1, LAST) else None
    if key is None and noun.size:
        key = _sized(noun.size)
    if key is None:
        return None
    score = [key(mask) for _, mask in found]
    order = sorted(range(len(found)), key=lambda i: -score[i])
    rank = index or 1
    place = len(order) - 1 if rank == LAST else rank - 1
    for a, b in ((place - 1, place), (place, place + 1)):
        if a >= 0 and b < len(order) and score[order[a]] - score[order[b]] < SET_APART:
            raise Unread("too close to call")
    return found[order[place]]
