"""Annotates base noun phrases: those that hold words only ("the second closest red block", "the left", "five")."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.base_words import Said, is_measure, labels, lying_kinds, sort_words
from grounding.corpus.clusters import clusters
from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.narrowing import noticed
from grounding.corpus.selector import Selector
from grounding.geometry.layout import UPRIGHT, Layout
from grounding.geometry.masks import single
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.symbols import (
    LAST,
    Cardinal,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectSymbol,
    ObjectType,
    SpatialReference,
    Symbol,
)

_PRONOUNS = ("it", "them", "they", "itself", "that", "this", "these", "those")
_PEOPLE = ("i", "we", "us", "there")
_CORNER_X, _CORNER_Y = ("front", "back", "top", "bottom"), ("left", "right")


class BasePhrases:
    """Base noun phrases in one world.

    Args:
        select: selections in the world.
        arrangements: (kind, mask) of what is there to be spoken of.
        history: ids of what was moved before, the latest last.
    """

    def __init__(
        self, select: Selector, arrangements: tuple[tuple[str, int], ...], history: tuple[str, ...] = ()
    ) -> None:
        self.layout: Layout = select.layout
        self.arrangements = arrangements
        self.select = select
        self.history = history

    def annotate(self, phrase: Phrase) -> Meaning:
        """Ground a noun phrase without child phrases; the same words are grounded once in a world.

        Raises:
            NotAnnotatable: a word or combination that is not covered.
        """
        key = (self.arrangements, self.history, tuple((word.text, word.tag) for word in phrase.words))
        known = self.select.sight.meanings.get(key)
        if known is None:
            try:
                known = self._ground(phrase)
            except NotAnnotatable as error:
                known = str(error)
            self.select.sight.meanings[key] = known
        if isinstance(known, str):
            raise NotAnnotatable(known)
        return known

    def _ground(self, phrase: Phrase) -> Meaning:
        texts = [word.text for word in phrase.words if word.tag != "UH"]
        if len(texts) == 1 and texts[0] in _PEOPLE:
            return Meaning("empty")
        if texts[-1] in ("target", "goal") and texts[0] in ("the", "your", "my"):
            return Meaning("pronoun", index=1)
        if texts in (["that", "one"], ["this", "one"]) or (len(texts) == 1 and texts[0] in _PRONOUNS):
            return self._pronoun(texts[0])
        if is_measure(phrase):
            return Meaning("measure", frozenset(s for text in texts for s in meanings(text) if isinstance(s, Cardinal)))
        said = sort_words(phrase, self.select.sight.opposite)
        if said.types == ["block"] and len(said.types) == len(texts) - 1 - said.same and said.pointed:
            return self._pointed(said)
        if said.robot or said.speaker:
            return self._person(phrase, said)
        if said.unknown:
            return Meaning("nothing", frozenset(labels(said)))
        if "table" in said.types:
            return self._table(phrase, said)
        if len(said.relations) == 2 and "far" in said.relations and said.place not in ("corner", "quadrant"):
            said.relations.remove("far")  # "the far left" is the left, far out
        said.relations = list(dict.fromkeys(said.relations))
        corner = _corner(said.relations)
        if len(said.colors) == 2 and said.types and not said.relations and not said.indices and self._joins(phrase):
            return self._two_colors(said)
        if (len(said.relations) > 1 and not corner) or any(
            len(values) > 1 for values in (said.colors, said.numbers, said.indices)
        ):
            raise NotAnnotatable(f"NP {phrase.text!r}: two words for the same thing")
        if said.kinds:
            return self._container(phrase, said, corner)
        named = said.types or said.colors or said.numbers or said.plural or said.universal
        if said.indices and not named and not said.relations and not said.place:
            return self._one(phrase, said, corner)  # "the third"
        place = said.place or not named
        if place and not (said.types and corner):
            return self._direction(phrase, said, corner)
        if said.numbers == [1] and not said.types and not said.universal:
            said.numbers, said.indefinite = [], True
            return self._one(phrase, said, corner)  # one of them
        if said.plural or said.universal or said.numbers:
            if said.universal and not said.plural and said.types and not said.numbers:
                said.plural = True  # each block
            return self._many(phrase, said, corner)
        return self._one(phrase, said, corner)

    def _pronoun(self, text: str) -> Meaning:
        if not self.history or text in ("them", "they", "these", "those", "itself"):
            return Meaning("pronoun", index=2 if text in ("them", "they", "these", "those") else 1)
        pool = self.layout.mask(self.history[-1:])
        names = self.layout.names(pool)
        return Meaning("one", self.select.objects(pool), pool=pool, chosen=pool, reference=names)

    def _pointed(self, said: Said) -> Meaning:
        """That block: the one that was spoken of, if any was."""
        if self.history:
            return self._pronoun("it")
        symbols = labels(said) | {ObjectAttribute("block", None, None, None)}
        return Meaning("pronoun", frozenset(symbols), index=1)

    def _joins(self, phrase: Phrase) -> bool:
        return any(word.text == "and" for word in phrase.words)

    def _two_colors(self, said: Said) -> Meaning:
        """The red and the blue block: one of each colour, or all of both."""
        kind = said.types[0]
        pools = [self.layout.matching(kind, color) for color in said.colors]
        pool = pools[0] | pools[1]
        chosen = pool if all(map(single, pools)) or (said.definite and said.plural and not said.numbers) else 0
        chosen = chosen if all(pools) else 0
        symbols = labels(said) | {ContainerAttribute(kind, color, None, None) for color in said.colors}
        parts = tuple(
            Meaning("one", object_type=kind, color=color, pool=p, chosen=p if single(p) else 0, indefinite=True)
            for color, p in zip(said.colors, pools, strict=True)
        )
        if chosen:
            symbols |= self.select.contained("group", chosen)
        return Meaning("many", frozenset(symbols), kind, number=2 if all(map(single, pools)) else None, definite=True,
                       pool=pool if all(pools) else 0, chosen=chosen, reference=self.layout.names(chosen),
                       reference_kind="group", parts=parts)  # fmt: skip

    def _person(self, phrase: Phrase, said: Said) -> Meaning:
        sight = self.select.sight
        if said.speaker and sight.opposite:
            return Meaning("speaker", frozenset({SpatialReference("far")}), relation="far")
        if said.speaker and self.layout.world.speaker is not None and not sight.beside:
            raise NotAnnotatable(f"NP {phrase.text!r}: the speaker looks from the side")
        return Meaning("robot", frozenset({Container("robot")}))

    def _table(self, phrase: Phrase, said: Said) -> Meaning:
        tables = [item.id for item in self.layout.world.objects if item.type == "table"]
        if len(tables) != 1 or said.relations or said.colors:
            raise NotAnnotatable(f"NP {phrase.text!r}: which table?")
        of_table: set[Symbol] = {ObjectSymbol(tables[0]), ObjectType("table")}
        return Meaning("table", frozenset(of_table), reference=tuple(tables))

    def _direction(self, phrase: Phrase, said: Said, corner: tuple[str, ...]) -> Meaning:
        if said.place in ("side", "end") and not said.relations and (said.mine or said.yours):
            far = said.mine and self.select.sight.opposite
            return Meaning("direction", frozenset({SpatialReference("far" if far else "near")}),
                           relation="far" if far else "near", place=said.place, definite=True)  # fmt: skip
        if said.colors or said.types or said.numbers or not said.relations or (said.indices and said.place):
            raise NotAnnotatable(f"NP {phrase.text!r}: no direction and no thing")
        index = said.indices[0] if said.indices else None
        return Meaning("direction", frozenset(labels(said)), relation=None if corner else said.relations[0],
                       index=index, corner=corner, place=said.place, definite=said.definite,
                       comparative=said.comparative)  # fmt: skip

    def _one(self, phrase: Phrase, said: Said, corner: tuple[str, ...]) -> Meaning:
        object_type, color = said.types[0] if said.types else None, said.colors[0] if said.colors else None
        relation = said.relations[0] if said.relations and not corner else None
        index = said.indices[0] if said.indices else None
        if index == LAST and relation is None:
            raise NotAnnotatable(f"NP {phrase.text!r}: 'last' without a direction is not covered")
        pool = self.layout.matching(object_type, color)
        if said.only and not single(pool) and not said.one:
            raise NotAnnotatable(f"NP {phrase.text!r}: not the only one")
        if said.lone:
            pool = self.select.alone(phrase, pool)
        if index is not None and index > pool.bit_count():
            pool = 0  # there are not so many
        head = Meaning("one", frozenset(), object_type, color, relation, index, pool=pool, corner=corner,
                       definite=said.definite, indefinite=said.indefinite, comparative=said.comparative,
                       verb="one" if said.one else "")  # fmt: skip
        chosen, unclear = 0, False
        if not said.other or single(pool):
            try:
                chosen = self.select.choose(phrase, pool, replace(head, comparative=False))
            except NotAnnotatable:
                chosen, unclear = self._closest_call(pool, head)
        if said.comparative and pool.bit_count() != 2:
            chosen, unclear = 0, bool(pool)
        symbols = labels(said)
        ranked = relation or index is not None or corner
        symbols.add(ObjectAttribute(object_type, color, relation, index or (1 if ranked and not corner else None)))
        symbols |= {ObjectSymbol(name) for name in self.layout.names(chosen)}
        return replace(head, symbols=frozenset(symbols), chosen=chosen, unclear=unclear,
                       reference=self.layout.names(chosen))  # fmt: skip

    def _closest_call(self, pool: int, head: Meaning) -> tuple[int, bool]:
        """What seems to be meant, though others are as likely; the top of which tower is decided around it."""
        if head.corner:
            return 0, True
        ranked = head.relation or ""
        if not self.layout.stacked(pool):
            ranked = UPRIGHT.get(ranked, ranked)
        if ranked in UPRIGHT:
            return 0, False
        return self.layout.nth(pool, ranked, head.index or 1), True

    def _many(self, phrase: Phrase, said: Said, corner: tuple[str, ...]) -> Meaning:
        layout = self.layout
        object_type, color = said.types[0] if said.types else None, said.colors[0] if said.colors else None
        relation = said.relations[0] if said.relations and not corner else None
        number = said.numbers[0] if said.numbers else None
        if said.indices and said.indices[0] != 1:
            raise NotAnnotatable(f"NP {phrase.text!r}: an ordinal of several blocks is not covered")
        if object_type is None and number is None and not said.universal:
            raise NotAnnotatable(f"NP {phrase.text!r}: no noun")
        if corner or said.comparative:
            raise NotAnnotatable(f"NP {phrase.text!r}: several blocks in a corner are not covered")
        pool = layout.matching(object_type, color)
        if said.lone:
            pool = self.select.alone(phrase, pool)
        if number is not None and number > pool.bit_count():
            pool = 0  # there are not so many
        chosen, unclear = 0, False
        if relation in ("top", "bottom") and layout.stacked(pool):
            unclear = True  # of which tower is decided around it
        elif relation is not None and number is not None:
            chosen = layout.extreme(pool, UPRIGHT.get(relation, relation), number)
            extent = sorted(layout.extent(pool, UPRIGHT.get(relation, relation)), reverse=True)
            unclear = bool(chosen) and number < len(extent) and extent[number - 1] - extent[number] < 0.01
            chosen = 0 if unclear else chosen
        elif relation is not None:
            unclear = True
        elif number is not None:
            chosen = pool if pool.bit_count() == number and object_type is not None and not said.other else 0
        elif (said.definite or said.universal) and not said.other:
            chosen = pool
        symbols = labels(said)
        symbols.add(ContainerAttribute(object_type, color, relation, number))
        if chosen:
            symbols |= set() if single(chosen) else {Container("group", layout.names(chosen))}
            symbols |= {ObjectSymbol(name) for name in layout.names(chosen)}
        return Meaning("many", frozenset(symbols), object_type, color, relation, None, number,
                       said.definite or said.universal, pool, chosen, reference=layout.names(chosen),
                       reference_kind="group", unclear=unclear, indefinite=said.indefinite)  # fmt: skip

    def _container(self, phrase: Phrase, said: Said, corner: tuple[str, ...]) -> Meaning:
        kinds = lying_kinds(said)
        if (said.types and not said.numbers) or not kinds:
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        if said.several:
            return self._containers(phrase, said)
        relation = said.relations[0] if said.relations and not corner else None
        relation = UPRIGHT.get(relation or "", relation)
        color = said.colors[0] if said.colors else None
        number = said.numbers[0] if said.numbers else None
        index = said.indices[0] if said.indices else None
        found = self.of_kinds(kinds, self.layout.matching(None, color), said.slanted)
        if color is not None and "group" in kinds:
            found += clusters(self.layout, self.layout.matching(None, color), number, found)
        if number is not None:
            found = [a for a in found if a[1].bit_count() == number]
        if not found and noticed(self.layout, kinds, color, number):
            raise NotAnnotatable(f"NP {phrase.text!r}: it is hard to say whether there is one")
        symbols = labels(said) | {Container(kind) for kind in kinds}
        head = Meaning("container", frozenset(), None, color, relation, index, number, said.definite, kinds=kinds,
                       size=said.size, corner=corner, comparative=said.comparative,
                       indefinite=said.indefinite)  # fmt: skip
        if index is not None and index > len(found):
            found = []
        chosen = self.select.arrangement(phrase, found, head) if not said.other or len(found) == 1 else None
        mask = 0
        if chosen is not None:
            mask = chosen[1]
            symbols.add(Container(chosen[0], self.layout.names(mask)))
            symbols |= {ObjectSymbol(name) for name in self.layout.names(mask)}
        return replace(head, symbols=frozenset(symbols), pool=mask, chosen=mask,
                       arrangements=(chosen,) if chosen else tuple(found), reference=self.layout.names(mask),
                       reference_kind=chosen[0] if chosen else "group")  # fmt: skip

    def of_kinds(self, kinds: tuple[str, ...], wanted: int, slanted: bool = False) -> list[tuple[str, int]]:
        """The arrangements of some kinds among wanted objects; a diagonal is neither a row nor a column."""
        sight = self.select.sight
        found = [a for a in self.arrangements if a[0] in kinds and not a[1] & ~wanted]
        if slanted:
            return [a for a in found if sight.slanted(*a)]
        line = "row" in kinds and "column" in kinds
        return [a for a in found if line or a[0] not in ("row", "column") or not sight.slanted(*a)]

    def _containers(self, phrase: Phrase, said: Said) -> Meaning:
        """Several containers, all of their kind: "the two rows"."""
        found = self.of_kinds(said.kinds, self.layout.everything, said.slanted)
        number = said.numbers[0] if said.numbers else None
        if said.relations or said.colors or len(said.kinds) > 1 or len(found) < 2 or number not in (None, len(found)):
            raise NotAnnotatable(f"NP {phrase.text!r}: not all containers of a kind")
        mask = 0
        for _, members in found:
            if mask & members:
                raise NotAnnotatable(f"NP {phrase.text!r}: they share members")
            mask |= members
        symbols = labels(said) | {Container(kind) for kind in said.kinds}
        symbols |= {Container(kind, self.layout.names(members)) for kind, members in found}
        symbols |= {ObjectSymbol(name) for name in self.layout.names(mask)}
        return Meaning("many", frozenset(symbols), pool=mask, chosen=mask, number=len(found), definite=True,
                       kinds=said.kinds, arrangements=tuple(found), reference=self.layout.names(mask),
                       reference_kind=said.kinds[0])  # fmt: skip


def _corner(relations: list[str]) -> tuple[str, ...]:
    """Two directions that name a point together, the one along x first; empty for all others."""
    if len(relations) != 2:
        return ()
    relations = [{"near": "front", "far": "back"}.get(name, name) for name in relations]
    if "center" in relations and relations.count("center") == 1:
        other = next(name for name in relations if name != "center")
        return ("center", other) if other in _CORNER_Y else (other, "center") if other in _CORNER_X else ()
    first, second = sorted(relations, key=lambda name: name in _CORNER_Y)
    along = {*_CORNER_X, "center"}
    if first in along and second in (*_CORNER_Y, "center") and (first, second) != ("center", "center"):
        return (first, second)
    return ()
