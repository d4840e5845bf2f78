"""Composes noun phrases for several blocks and for arrangements, with what modifies them."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.clusters import clusters
from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.narrowing import RESTRICTING, SILENT, Narrowing, noticed
from grounding.geometry.masks import indices_of
from grounding.language.tree import Phrase
from grounding.symbols import Container, ContainerAttribute, Region, Symbol


class SetPhrases(Narrowing):
    """Noun phrases for several blocks, in one world."""

    def _many(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        layout, pool, number, relation = self.layout, head.pool, head.number, head.relation
        kind, chosen, carried = "group", 0, head.carried
        if modifier.sort == "direction" and modifier.place in RESTRICTING:
            new = self._directed(phrase, head, modifier)
            pool, carried = new.pool, new.carried
            chosen = self.select.count(phrase, pool, number, relation)
        elif modifier.sort == "direction" and modifier.relation and modifier.preposition in ("closest", "farthest"):
            chosen = self.select.count(phrase, pool, number, modifier.relation)
        elif modifier.sort == "direction" and modifier.relation and modifier.index is None:
            chosen, kind = self._many_at(phrase, head, modifier.relation)
        elif modifier.sort in ("robot", "speaker"):
            if relation in ("near", "far") and modifier.sort == "speaker":
                relation = "far" if relation == "near" else "near"
                chosen = self.select.count(phrase, pool, number, relation)
                self._agrees_with_speaker(phrase, pool, number, relation, chosen)
            else:
                chosen = head.chosen
        elif modifier.sort in ("container", "many"):
            if not modifier.chosen:
                cands = [a for a in modifier.arrangements if number in (None, a[1].bit_count()) and not a[1] & ~pool]
                if modifier.sort != "container" or len(cands) != 1:
                    raise NotAnnotatable(f"{phrase.text!r}: {modifier.sort} is not determined")
                (kind, chosen), pool = cands[0], cands[0][1]
            elif relation in ("near", "far") and modifier.preposition in ("to", "from") and number:
                chosen = self.select.nearest(
                    phrase, pool, replace(modifier, nearest_to=modifier.reference, away=relation == "far"), number
                )
            else:
                pool &= modifier.chosen
                if modifier.reference_kind != "tower" and not layout.stacked(pool):
                    relation = {"top": "back", "bottom": "front"}.get(relation or "", relation)
                chosen = self.select.count(phrase, pool, number, relation)
                if chosen == modifier.chosen and modifier.sort == "container":
                    kind = modifier.reference_kind
        elif modifier.sort == "region" and modifier.region is not None:
            carried |= {modifier.region} | frozenset(modifier.regions)
            if modifier.nearest_to:
                if not number:
                    raise NotAnnotatable(f"{phrase.text!r}: how many?")
                chosen = self.select.nearest(phrase, pool, modifier, number)
            else:
                if modifier.region.kind != "robot":
                    pool &= self.within(modifier)
                chosen = self.select.count(phrase, pool, number, relation)
        elif modifier.sort == "lone":
            pool = self.select.alone(phrase, pool)
            chosen = self.select.count(phrase, pool, number, relation)
        elif modifier.sort == "color":
            pool &= layout.matching(None, modifier.color)
            chosen = self.select.count(phrase, pool, number, relation)
        elif modifier.sort in SILENT:
            chosen = self.select.count(phrase, pool, number, relation)
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of blocks")
        if number is not None and number > pool.bit_count():
            pool = chosen = 0  # there are not so many
        attribute = ContainerAttribute(head.object_type, head.color, relation, number)
        symbols: frozenset[Symbol]
        symbols = self.select.contained(kind, chosen) if chosen else carried | {attribute}
        return replace(head, symbols=symbols, pool=pool, chosen=chosen, reference=layout.names(chosen), unclear=False,
                       relation=relation, reference_kind=kind, carried=carried)  # fmt: skip

    def _agrees_with_speaker(self, phrase: Phrase, pool: int, number: int | None, relation: str, chosen: int) -> None:
        speaker = self.select.sight.speaker
        if not number or speaker is None:
            raise NotAnnotatable(f"{phrase.text!r}: how many?")
        away = {i: float(((self.layout.positions[i, :2] - speaker) ** 2).sum()) for i in indices_of(pool)}
        order = sorted(away, key=lambda i: away[i] if relation == "far" else -away[i])
        if sum(1 << i for i in order[:number]) != chosen:
            raise NotAnnotatable(f"{phrase.text!r}: near the speaker is not far from the robot")

    def _many_at(self, phrase: Phrase, head: Meaning, direction: str) -> tuple[int, str]:
        direction = {"top": "back", "bottom": "front"}.get(direction, direction)
        if head.relation is not None:
            pool = self.select.half(phrase, head.pool, direction, clear=True)
            return self.select.count(phrase, pool, head.number, head.relation), "group"
        if head.number is None:
            if direction in ("near", "far", "center"):
                raise NotAnnotatable(f"{phrase.text!r}: how many?")
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
        carried |= head.carried
        new, number = head, head.number
        if modifier.sort == "many":
            number = modifier.number or number
            cands, found = self._made_of(head, modifier, number)
            carried |= found
        elif modifier.sort == "direction" and (modifier.relation or modifier.corner) and modifier.index is None:
            relation = {"top": "back", "bottom": "front"}.get(modifier.relation or "", modifier.relation)
            new = replace(head, relation=relation, corner=modifier.corner, nearest_to=())
            if modifier.by_speaker:
                raise NotAnnotatable(f"{phrase.text!r}: not covered")
        elif modifier.sort == "region" and modifier.region is not None:
            carried |= {modifier.region}
            if modifier.nearest_to:
                new = replace(head, nearest_to=modifier.nearest_to, away=modifier.away, relation=None)
            elif modifier.region.kind != "robot":
                inside = self.within(modifier)
                cands = [a for a in cands if not a[1] & ~inside]
        elif modifier.sort in ("robot", "speaker"):
            if head.relation not in ("near", "far") or modifier.sort == "speaker":
                raise NotAnnotatable(f"{phrase.text!r}: not covered")
        elif modifier.sort in ("one", "container") and head.relation in ("near", "far") and modifier.chosen:
            new = replace(head, nearest_to=modifier.reference, away=head.relation == "far", relation=None)
        elif modifier.sort not in SILENT:
            raise NotAnnotatable(f"{phrase.text!r}: a container with a {modifier.sort} is not covered")
        chosen = self.select.arrangement(phrase, cands, new)
        if chosen is not None and modifier.sort == "direction":
            self._lies_there(phrase, chosen[1], modifier)
        regions = frozenset(s for s in carried if isinstance(s, Region))
        if chosen is None:
            return replace(new, symbols=frozenset(carried), arrangements=tuple(cands), number=number, chosen=0, pool=0,
                           reference=(), carried=regions)  # fmt: skip
        return replace(new, symbols=self.select.contained(*chosen), arrangements=(chosen,), number=number,
                       chosen=chosen[1], pool=chosen[1], reference=self.layout.names(chosen[1]), carried=regions,
                       reference_kind=chosen[0])  # fmt: skip

    def _made_of(
        self, head: Meaning, modifier: Meaning, number: int | None
    ) -> tuple[list[tuple[str, int]], frozenset[Symbol]]:
        """The candidates that are made of certain blocks: the row of the five red ones."""
        cands = list(head.arrangements)
        wanted = self.layout.matching(modifier.object_type, modifier.color)
        if modifier.color is not None and "group" in head.kinds:
            cands += clusters(self.layout, wanted, number, cands)
        if modifier.chosen and any(a[1] == modifier.chosen for a in cands):
            cands = [a for a in cands if a[1] == modifier.chosen]
        else:
            pool = modifier.chosen or modifier.pool
            cands = [a for a in cands if not a[1] & ~(wanted if not modifier.chosen else pool | wanted)]
            if number:
                cands = [a for a in cands if a[1].bit_count() == number]
            if not cands and noticed(self.layout, head.kinds, modifier.color, number):
                raise NotAnnotatable("it is hard to say whether there is one")
        return cands, frozenset(s for s in modifier.symbols if isinstance(s, ContainerAttribute))
