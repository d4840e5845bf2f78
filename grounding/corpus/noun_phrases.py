"""Composes the meanings of noun phrases: a head and what modifies it."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.meaning import Meaning, NotAnnotatable, is_empty, passed
from grounding.corpus.selector import Selector
from grounding.geometry.layout import UPRIGHT, Layout
from grounding.geometry.masks import single
from grounding.language.tree import Phrase
from grounding.symbols import Container, ContainerAttribute, ObjectAttribute, Region, Symbol

MOST_REFERENCES = 8  # so many objects a reference may leave possible


class NounPhrases:
    """Noun phrases in one world."""

    def __init__(self, layout: Layout, arrangements: tuple[tuple[str, int], ...]) -> None:
        self.layout = layout
        self.arrangements = arrangements
        self.select = Selector(layout)

    def compose(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        """The meaning of a noun phrase from its children's.

        Raises:
            NotAnnotatable: not true, not clear or not covered.
        """
        if phrase.words:
            if [word.text for word in phrase.words] == ["and"] and len(children) == 2:
                return self._both(phrase, children)
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        if len(children) != 2:
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        head, modifier = children
        if modifier.unclear:
            raise NotAnnotatable(f"{modifier.sort} in {phrase.text!r}: too close to call")
        if "nothing" in (head.sort, modifier.sort) or is_empty(modifier):
            return Meaning("nothing")
        if head.sort == "one":
            return self._one(phrase, head, modifier)
        if head.sort == "many":
            return self._many(phrase, head, modifier)
        if head.sort == "container":
            return self._container(phrase, head, modifier)
        if head.sort == "direction":
            return self._place(phrase, head, modifier)
        if head.sort == "table" and modifier.sort == "region":
            return replace(modifier, symbols=passed(modifier), preposition="")
        raise NotAnnotatable(f"NP {phrase.text!r}: a {head.sort} with a {modifier.sort} is not covered")

    def _both(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        chosen = 0
        for child in children:
            if not child.chosen or child.sort not in ("one", "container"):
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' are not determined")
            if child.chosen & chosen:
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' overlap")
            chosen |= child.chosen
        symbols = frozenset().union(*(passed(child) for child in children))
        return Meaning("many", symbols, pool=chosen, chosen=chosen, reference=self.layout.names(chosen),
                       definite=True, number=len(children))  # fmt: skip

    def _one(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        layout, pool, relation, index = self.layout, head.pool, head.relation, head.index
        kind = modifier.reference_kind
        carried: frozenset[Symbol] = frozenset()
        nearest_to: tuple[str, ...] = ()
        member = False
        if modifier.sort == "direction":
            index = modifier.index or index
            said = modifier.relation
            if said is None:
                raise NotAnnotatable(f"{phrase.text!r}: no direction")
            if relation in (None, said) or (relation in ("near", "far") and modifier.preposition == "to"):
                relation = said
            elif modifier.preposition in ("on", "at", "in"):
                pool = self.select.half(phrase, pool, said)
            else:
                raise NotAnnotatable(f"{phrase.text!r}: two directions")
        elif modifier.sort == "robot":
            if relation not in ("near", "far"):
                raise NotAnnotatable(f"{phrase.text!r}: what about the robot?")
        elif modifier.sort in ("container", "many", "one"):
            if not modifier.chosen:
                raise NotAnnotatable(f"{phrase.text!r}: {modifier.sort} is not determined")
            if relation in ("near", "far") and modifier.preposition in ("to", "from"):
                if relation == "far":
                    raise NotAnnotatable(f"{phrase.text!r}: far from a thing is not covered")
                nearest_to, relation = modifier.reference, None
            else:
                pool &= modifier.chosen
                carried = frozenset(s for s in modifier.symbols if isinstance(s, Container))
        elif modifier.sort == "region" and modifier.region is not None:
            if modifier.region.relation == "near" and "closest" in modifier.preposition.split():
                nearest_to = modifier.region.objects
            elif relation is None and index is None and _means_member(modifier):
                pool &= layout.mask(modifier.region.objects)
                relation, kind = modifier.region.relation, modifier.region.kind
                member = True
            elif modifier.region.kind != "robot":
                pool &= layout.within(modifier.region)
            carried = frozenset({modifier.region})
        elif modifier.sort == "table":
            pass
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of a block")
        ranked = relation or ""
        if kind != "tower" and not layout.stacked(pool):
            ranked = UPRIGHT.get(ranked, ranked)
        crowded = modifier.sort == "region" and modifier.region is not None and not member and pool.bit_count() > 1
        if crowded and not nearest_to and relation is None and index is None and modifier.region is not None:
            chosen = self.select.first_met(pool, modifier.region)
        elif nearest_to:
            chosen = self.select.closest(phrase, pool & ~layout.mask(nearest_to), nearest_to)
        elif relation == "center" and modifier.sort == "direction":
            chosen = layout.central(pool)
        elif relation is not None:
            chosen = self.select.rank(phrase, pool, ranked, index or 1, kind if modifier.chosen or member else "")
        else:
            chosen = pool if single(pool) and index is None else 0
        said_relation = head.relation if member else relation
        attribute = ObjectAttribute(
            head.object_type, head.color, said_relation, index or (1 if said_relation else None)
        )
        found = self.select.objects(chosen)
        if modifier.sort in ("direction", "robot"):
            symbols = found | {attribute}
        else:
            symbols = found if chosen else carried | {attribute}
        return replace(head, symbols=symbols, relation=relation, index=index, pool=pool, chosen=chosen, unclear=False,
                       reference=layout.names(chosen), reference_kind="object")  # fmt: skip

    def _many(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        layout, pool, number, relation = self.layout, head.pool, head.number, head.relation
        kind = "group"
        chosen = 0
        if modifier.sort == "direction" and modifier.relation:
            chosen, kind = self._many_at(phrase, head, modifier.relation)
        elif modifier.sort == "robot":
            chosen = head.chosen
        elif modifier.sort in ("container", "many"):
            if not modifier.chosen:
                cands = [a for a in modifier.arrangements if number in (None, a[1].bit_count()) and not a[1] & ~pool]
                if modifier.sort != "container" or len(cands) != 1:
                    raise NotAnnotatable(f"{phrase.text!r}: {modifier.sort} is not determined")
                (kind, chosen), pool = cands[0], cands[0][1]
            else:
                pool &= modifier.chosen
                chosen = self.select.count(phrase, pool, number, relation)
                if chosen == modifier.chosen and modifier.sort == "container":
                    kind = modifier.reference_kind
        elif modifier.sort == "region" and modifier.region is not None:
            if modifier.region.kind != "robot":
                pool &= layout.within(modifier.region)
            chosen = self.select.count(phrase, pool, number, relation)
        elif modifier.sort == "table":
            chosen = self.select.count(phrase, pool, number, relation)
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of blocks")
        attribute = ContainerAttribute(head.object_type, head.color, relation, number)
        symbols: frozenset[Symbol]
        symbols = self.select.contained(kind, chosen) if chosen else frozenset({attribute})
        return replace(head, symbols=symbols, pool=pool, chosen=chosen, reference=layout.names(chosen),
                       reference_kind=kind)  # fmt: skip

    def _many_at(self, phrase: Phrase, head: Meaning, direction: str) -> tuple[int, str]:
        if head.relation is not None:
            return self.select.count(
                phrase, self.select.half(phrase, head.pool, direction), head.number, head.relation
            ), "group"
        if head.number is None:
            return self.select.half(phrase, head.pool, direction, clear=True), "group"
        fitting = [a for a in self.arrangements if a[1].bit_count() == head.number and not a[1] & ~head.pool]
        if fitting:
            best = self.select.extreme_arrangement(phrase, fitting, direction, 1)
            if self.layout.extent(best[1], direction).mean() > self.select.middle(direction):
                return best[1], best[0]
        return self.select.count(phrase, head.pool, head.number, direction), "group"

    def _container(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        cands = list(head.arrangements)
        carried: set[Symbol] = {s for s in head.symbols if isinstance(s, Container) and not s.objects}
        number, relation = head.number, head.relation
        if modifier.sort == "many":
            pool = modifier.pool if not modifier.chosen else modifier.chosen
            number = modifier.number or number
            wanted = self.layout.matching(modifier.object_type, modifier.color)
            if modifier.chosen and any(a[1] == modifier.chosen for a in cands):
                cands = [a for a in cands if a[1] == modifier.chosen]
            else:
                cands = [a for a in cands if not a[1] & ~(wanted if not modifier.chosen else pool | wanted)]
                if number:
                    cands = [a for a in cands if a[1].bit_count() == number]
            carried |= {s for s in modifier.symbols if isinstance(s, ContainerAttribute)}
        elif modifier.sort == "direction" and modifier.relation:
            relation = modifier.relation
        elif modifier.sort == "region" and modifier.region is not None:
            if "closest" in modifier.preposition.split():
                raise NotAnnotatable(f"{phrase.text!r}: not covered")
            if modifier.region.kind != "robot":
                inside = self.layout.within(modifier.region)
                cands = [a for a in cands if not a[1] & ~inside]
            carried |= {modifier.region}
        elif modifier.sort == "robot":
            if head.relation not in ("near", "far"):
                raise NotAnnotatable(f"{phrase.text!r}: not covered")
        elif modifier.sort != "table":
            raise NotAnnotatable(f"{phrase.text!r}: a container with a {modifier.sort} is not covered")
        chosen = None
        if len(cands) == 1:
            chosen = cands[0]
        elif cands and relation:
            chosen = self.select.extreme_arrangement(phrase, cands, relation, head.index or 1)
        elif cands and head.size:
            chosen = self.select.largest(phrase, cands, head.size)
        if chosen is None:
            return replace(head, symbols=frozenset(carried), arrangements=tuple(cands), number=number, chosen=0)
        return replace(head, symbols=self.select.contained(*chosen), arrangements=(chosen,), number=number,
                       chosen=chosen[1], pool=chosen[1], reference=self.layout.names(chosen[1]),
                       reference_kind=chosen[0])  # fmt: skip

    def _place(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        if modifier.sort == "robot":
            region = Region(str(head.relation), "robot", ())
        elif modifier.sort == "one" and not modifier.reference and 0 < modifier.pool.bit_count() <= MOST_REFERENCES:
            region = Region(str(head.relation), "object", self.layout.names(modifier.pool))
        elif modifier.sort in ("table", "one", "container", "many") and modifier.reference:
            region = Region(str(head.relation), modifier.reference_kind, modifier.reference)
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a place needs something that is determined")
        return Meaning("region", frozenset({region}), region=region, relation=head.relation)


def _means_member(modifier: Meaning) -> bool:
    """Whether a place names a member: the top of a tower, the middle of a row, what is at its end."""
    region = modifier.region
    if region is None or region.kind in ("object", "robot"):
        return False
    if region.relation in ("left", "right", "front", "back"):
        return modifier.preposition == "at"
    return region.relation == "center" or (region.relation == "top" and region.kind == "tower")
