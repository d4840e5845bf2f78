"""Noun phrases of blocks, read literally: what restricts comes before what selects."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from grounding.geometry.masks import indices_of, mask_of, single
from grounding.lexicon import kind
from grounding.literal.choosing import (
    alone,
    along,
    first,
    first_met,
    from_reference,
    half,
    nth,
    side_of_all,
    straight,
    to_center,
    toward,
)
from grounding.literal.colors import lacking
from grounding.literal.places import OPPOSITE, names_of, says_unknown
from grounding.literal.reading import ReadsLiterally
from grounding.literal.values import (
    FAINT,
    FIRM,
    PLAIN,
    Effect,
    Meant,
    Member,
    Missing,
    Narrow,
    Order,
    Sided,
    Unread,
    Viewed,
)
from grounding.meaning.nouns import Noun
from grounding.numbers import counted, ranked, spelled
from grounding.symbols import LAST

WITHIN = 3.0  # what is at most so many edges away may be called near where nothing is nearer
_SOME = frozenset("the those these both all".split())  # "three red ones" are any three
_OWN = ("its", "their")
_LINES = ("row", "column", "tower")


@dataclass
class _Said:
    """What a noun and its modifiers say, sorted."""

    pool: int
    orders: list[Order] = field(default_factory=list)
    sides: list[Sided] = field(default_factory=list)
    narrows: list[Narrow] = field(default_factory=list)
    members: list[Member] = field(default_factory=list)

    @property
    def kind(self) -> str:
        """Of which kind of arrangement things are chosen, or ""."""
        return self.members[-1].kind if self.members else ""


def mean_things(reader: ReadsLiterally, noun: Noun, base: int | None = None) -> Meant:
    """What a noun of blocks means.

    Raises:
        Unread: it is beyond what is read literally, or too close to call.
        Missing: there is nothing of the kind.
    """
    bare = noun.head == "other" and not (noun.modifiers or noun.colors)
    owned = noun.text.split(" ", 1)[0] in _OWN  # "its nearest block" is near to what was spoken of
    if bare or owned or noun.strange or says_unknown(noun) or noun.size:
        raise Unread(noun.text)
    if noun.plural and noun.number is None and "both" in noun.text.split():
        noun = replace(noun, number=2)
    layout = reader.layout
    pool = mask_of(int(i) for i in np.flatnonzero(kind.fitting(reader.scene, noun.types, noun.colors) > 0.5))
    if not pool:
        raise lacking(reader, noun.types, noun.colors)
    if base is not None:
        pool &= base
    if noun.lone:
        pool = alone(reader.scene, pool)
    said = _Said(pool)
    names = names_of(noun)
    owner = reader.person(noun.agent) if noun.agent else None
    effects: list[Effect] = []
    for modifier in noun.modifiers:
        effects += reader.modify(modifier, noun, pool)
    viewed = next((e for e in effects if isinstance(e, Viewed)), None)
    if viewed is not None or owner == "speaker":
        if viewed is not None and names not in (("near",), ("far",)):
            raise Unread(noun.text)
        if owner == "speaker" or (viewed is not None and viewed.agent == "speaker"):
            names = tuple(OPPOSITE.get(name, name) for name in names)
    nearest = next((e for e in effects if isinstance(e, Member) and names in (("near",), ("far",)) and e.to), None)
    if nearest is not None:
        effects = [effect for effect in effects if effect is not nearest]
        key = from_reference(layout, layout.names(nearest.mask), names == ("far",))
        effects.append(Order(key, reference=nearest.mask))
        names = ()
    if names in (("near",), ("far",)) and any(isinstance(e, Order) and e.name == "" and e.reference for e in effects):
        names = ()  # "the closest block closer to the tower"
    own = _own_order(reader, names)
    if own is not None:
        said.orders.append(own)
    for effect in effects:
        match effect:
            case Narrow(mask):
                said.pool &= mask
                said.narrows.append(effect)
            case Member(mask):
                said.pool &= mask
                said.members.append(effect)
            case Order():
                said.orders.append(effect)
                said.pool &= ~effect.reference
            case Sided():
                said.sides.append(effect)
    if not said.pool and _almost(reader, pool, said):
        raise Unread(noun.text)
    if not said.pool:
        raise Missing(f"nothing here is {noun.text!r}", FIRM if noun.plural and noun.colors else FAINT)
    reader.vague |= any(narrow.vague for narrow in said.narrows) or any(s.name == "center" for s in said.sides)
    return _several(reader, noun, said, names) if noun.plural else _one(reader, noun, said)


def _almost(reader: ReadsLiterally, pool: int, said: _Said) -> bool:
    """Whether something is so near to what nothing is beside that people may call it so."""
    scene = reader.scene
    for narrow in said.narrows:
        if narrow.region is not None and narrow.region.relation == "near":
            references = [scene.layout.index[name] for name in narrow.region.objects if name in scene.layout.index]
            others = [i for i in indices_of(pool) if i not in references]
            if references and others and scene.gaps[np.ix_(others, references)].min() < WITHIN * scene.edge:
                return True
    return False


def _own_order(reader: ReadsLiterally, names: tuple[str, ...]) -> Order | None:
    if not names:
        return None
    if len(names) == 1:
        return Order(along(reader.layout, names[0]), None, names[0])
    if len(names) == 2:
        return Order(toward(reader.scene, names), None, "", 0.03)
    raise Unread(" ".join(names))


def _one(reader: ReadsLiterally, noun: Noun, said: _Said) -> Meant:
    scene, layout = reader.scene, reader.layout
    pool, orders = said.pool, list(said.orders)
    index = noun.ordinals[0] if noun.ordinals else None
    if len(noun.ordinals) > 1:
        raise Unread(noun.text)
    if len(said.sides) > 1 and any(side.name == "center" for side in said.sides):
        raise Unread("in the middle, and where?")
    for side in said.sides:
        if side.half:
            pool = half(scene, pool, side.name)
        elif orders and orders[0].name == side.name:
            continue
        elif orders and orders[0].name in ("near", "far") and not side.narrows:
            orders[0] = Order(along(layout, side.name), side.index, side.name)
        elif orders and side.narrows:
            pool = half(scene, pool, side.name)
        elif side.name == "center":
            orders.append(Order(to_center(layout), side.index, "center"))
        else:
            orders.append(Order(along(layout, side.name), side.index, side.name))
    if not pool:
        raise Missing(f"nothing here is {noun.text!r}")
    if noun.only and not single(pool):
        raise Unread("not the only one")
    if noun.other and not single(pool):
        return Meant("things", pool, 0, definite=False)
    if not orders:
        return _unranked(reader, noun, said, pool, index)
    if index == LAST and len(orders) == 1 and orders[0].index is None:
        index = LAST
    chosen = _ranked(reader, said, pool, orders[0], index)
    for other in orders[1:]:
        if _ranked(reader, said, pool, other, None) != chosen:
            raise Unread("two ways to choose")
    if not chosen and any(narrow.chosen for narrow in said.narrows):
        raise Unread("a rank of what is the only one")
    if not chosen:
        rank = orders[0].index or index or 1
        count = "is only one" if single(pool) else f"are {spelled(pool.bit_count())}"
        raise Missing(f"there is no {ranked(abs(rank))} one; there {count}", PLAIN if _by_count(said) else FAINT)
    there = [side for side in said.sides if side.there and not side.half]
    if there and len(orders) == 1 and not index and side_of_all(scene, chosen, there[0].name) < -0.03:
        raise Unread("on the other side")
    return Meant("things", pool, chosen, definite=noun.definite)


def _by_count(said: _Said) -> bool:
    """Whether nothing but colours and whole arrangements told what was counted."""
    return not said.narrows and not any(side.half for side in said.sides) and len(said.sides) + len(said.orders) < 2


def _ranked(reader: ReadsLiterally, said: _Said, pool: int, order: Order, index: int | None) -> int:
    if order.name == "center" and said.kind in _LINES and (order.index or index or 1) == 1:
        middle = reader.layout.median(pool)
        if not middle:
            raise Unread("an even number has no middle")
        return middle
    if said.kind == "tower" and order.name in ("top", "bottom"):
        order = Order(along(reader.layout, order.name, upright=True), order.index, order.name, order.margin)
    chosen = nth(reader.scene, pool, order, index)
    if order.name == "center" and not said.members:
        table = Order(toward(reader.scene, ()), order.index, "center")
        if nth(reader.scene, pool, table, index) != chosen:
            raise Unread("the middle of the table, or of what lies there?")
    return chosen


def _unranked(reader: ReadsLiterally, noun: Noun, said: _Said, pool: int, index: int | None) -> Meant:
    if index is not None:
        if index > pool.bit_count() and any(narrow.chosen for narrow in said.narrows):
            raise Unread("a rank of what is the only one")
        if index > pool.bit_count():
            told = f"there is no {ranked(index)} one; {counted(pool.bit_count())}"
            raise Missing(told, PLAIN if _by_count(said) else FAINT)
        if index == 1 or index == LAST:
            raise Unread("the first from where?")
        return Meant("things", pool, 0, definite=noun.definite)
    regions = [n for n in said.narrows if n.region is not None or n.strict]
    chosen = pool if single(pool) else 0
    if regions and not chosen and len(regions) == 1 and regions[0].region is not None:
        chosen = first_met(reader.scene, pool, regions[0].region)
    for narrow in regions:
        asked = narrow.strict and narrow.region is not None and chosen
        if asked and narrow.region and not straight(reader.scene, chosen.bit_length() - 1, narrow.region):
            raise Unread("not straight there")
    return Meant("things", pool, chosen, definite=noun.definite)


def _several(reader: ReadsLiterally, noun: Noun, said: _Said, names: tuple[str, ...]) -> Meant:
    scene, pool, number = reader.scene, said.pool, noun.number
    if noun.ordinals and noun.ordinals != (1,):
        raise Unread(noun.text)
    orders = list(said.orders)
    for side in said.sides:
        if side.half or orders:
            if orders and not side.half and not side.narrows and orders[0].name == side.name:
                continue
            if orders and not side.narrows:
                raise Unread(noun.text)
            pool = half(scene, pool, side.name)
        elif number is None:
            if side.name in ("near", "far", "center"):
                raise Unread(noun.text)
            pool = half(scene, pool, side.name)
        elif (arranged := _arranged(reader, pool, number, side.name)) is not None:
            return Meant("things", arranged[1], arranged[1], arranged[0], True, number)
        else:
            orders.append(Order(along(reader.layout, side.name), None, side.name))
    if not pool:
        raise Missing(f"nothing here is {noun.text!r}")
    if number is None:
        if orders or noun.other:
            raise Unread(noun.text)
        kind = said.kind if said.members and pool == said.members[-1].mask else "group"
        return Meant("things", pool, pool, kind, True, definite=noun.definite or noun.universal)
    if pool.bit_count() < number:
        raise Missing(f"there are not {spelled(number)} of {noun.text!r}, only {spelled(pool.bit_count())}", FIRM)
    if len(orders) > 1 or noun.other and not orders and pool.bit_count() != number:
        raise Unread(noun.text)
    if orders:
        if names in (("top",), ("bottom",)) and reader.layout.stacked(pool) and said.kind != "tower":
            raise Unread("the top of which tower?")
        chosen = first(scene, pool, orders[0], number)
    else:
        chosen = pool if pool.bit_count() == number else 0
    kind = said.kind if said.members and chosen == said.members[-1].mask else "group"
    definite = noun.definite and not _SOME.isdisjoint(noun.text.split())
    return Meant("things", chosen or pool, chosen, kind, True, number, definite)


def _arranged(reader: ReadsLiterally, pool: int, number: int, name: str) -> tuple[str, int] | None:
    """The arrangement of so many that lies farthest on a side: "the three on the left"."""
    found = [(a.kind, a.mask) for a in reader.layout.evident_of((), pool) if a.mask.bit_count() == number]
    if not found:
        return None
    key = along(reader.layout, name)
    score = sorted(((float(key(mask).mean()), mask, kind) for kind, mask in found), reverse=True)
    if len(score) > 1 and score[0][0] - score[1][0] < 0.05:
        raise Unread("too close to call")
    return (score[0][2], score[0][1]) if side_of_all(reader.scene, score[0][1], name) > 0 else None

