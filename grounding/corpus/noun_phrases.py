"""Composes the meanings of noun phrases: a head and what modifies it."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.clusters import clusters
from grounding.corpus.meaning import Meaning, NotAnnotatable, is_empty, passed
from grounding.corpus.prepositions import MOST_REFERENCES, lies_directly
from grounding.corpus.selector import Selector
from grounding.geometry.masks import indices_of, single
from grounding.language.tree import Phrase
from grounding.symbols import Container, ContainerAttribute, ObjectAttribute, Region, SpatialReference, Symbol

__all__ = ["MOST_REFERENCES", "NounPhrases"]
_RESTRICTING = ("half", "part", "section", "area", "portion", "region", "quadrant", "zone")
_SIDES = ("left", "right", "front", "back")
_SILENT = ("view", "table", "empty")


class NounPhrases:
    """Noun phrases in one world."""

    def __init__(self, select: Selector, arrangements: tuple[tuple[str, int], ...]) -> None:
        self.layout = select.layout
        self.arrangements = arrangements
        self.select = select

    def compose(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        """The meaning of a noun phrase from its children's.

        Raises:
            NotAnnotatable: not true, not clear or not covered.
        """
        texts = [word.text for word in phrase.words if word.tag != "UH"]
        if "and" in texts and len(children) == 2 and set(texts) <= {"and", "both"}:
            return self._both(phrase, children)
        if "and" in texts and len(children) == 3 and texts == ["and"]:
            inner = self.modified(phrase, children[0], children[1])
            return self.modified(phrase, inner, children[2])
        told = [child for child in children if child.sort != "empty"]
        if [text for text in texts if text != "please"]:
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        if len(told) == 1:
            return told[0]
        if len(told) != 2:
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        return self.modified(phrase, *told)

    def modified(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        """A head with one modifier.

        Args:
            phrase: for messages.
            head: what is modified.
            modifier: a place, a direction, a set that it is of, a relative clause.

        Raises:
            NotAnnotatable: not true, not clear or not covered.
        """
        predicate = modifier.sort == "one" and not modifier.preposition
        if modifier.unclear and not predicate:
            raise NotAnnotatable(f"{modifier.sort} in {phrase.text!r}: too close to call")
        if modifier.sort in ("several", "predicate") and modifier.parts:
            for part in modifier.parts:
                head = self.modified(phrase, head, part)
            return head
        if "nothing" in (head.sort, modifier.sort) or is_empty(modifier):
            return Meaning("nothing")
        if modifier.measured:
            raise NotAnnotatable(f"NP {phrase.text!r}: a measured distance says nothing of what is there")
        if modifier.sort == "pronoun":
            raise NotAnnotatable(f"NP {phrase.text!r}: what was spoken of is not known here")
        if head.sort == "one":
            return self._one(phrase, head, modifier)
        if head.sort == "many":
            return self._many(phrase, head, modifier)
        if head.sort == "container":
            return self._container(phrase, head, modifier)
        if head.sort == "direction":
            return self._place(phrase, head, modifier)
        if head.sort == "view":
            return head
        if head.sort == "table" and modifier.sort == "region":
            return replace(modifier, symbols=passed(modifier), preposition="")
        raise NotAnnotatable(f"NP {phrase.text!r}: a {head.sort} with a {modifier.sort} is not covered")

    def _both(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        chosen = 0
        if all(c.sort == "one" and not c.unclear and (c.chosen or c.indefinite) and c.pool for c in children) and any(
            not c.chosen for c in children
        ):
            symbols = frozenset().union(*(passed(child) for child in children))
            pool = children[0].pool | children[1].pool
            return Meaning("many", symbols, pool=pool, number=2, parts=tuple(children))
        for child in children:
            if child.sort == "nothing":
                return Meaning("nothing")
            if child.unclear or not child.chosen or child.sort not in ("one", "container", "many"):
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' are not determined")
            if child.chosen & chosen:
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' overlap")
            chosen |= child.chosen
        symbols = frozenset().union(*(passed(child) for child in children))
        return Meaning("many", symbols, pool=chosen, chosen=chosen, reference=self.layout.names(chosen),
                       definite=True, number=len(children))  # fmt: skip

    def _one(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        new, kind, upright = self._narrowed(phrase, head, modifier)
        chosen, unclear = 0, False
        try:
            chosen = self._chosen(phrase, new, modifier, kind, upright)
        except NotAnnotatable as error:
            if "too close to call" not in str(error) or not new.ranks:
                raise
            unclear = True  # fine while something around it decides
        if modifier.sort == "direction" and head.relation is None:
            self._lies_there(phrase, chosen, modifier)
        member = bool(kind) and modifier.sort == "region"
        said = None if new.nearest_to or new.corner else head.relation if member else new.relation
        attribute = ObjectAttribute(head.object_type, head.color, said, new.index or (1 if said else None))
        found = self.select.objects(chosen)
        if modifier.sort in ("direction", "robot", "speaker") and not new.corner:
            symbols: frozenset[Symbol] = found | {attribute} | (frozenset() if chosen else new.carried)
        else:
            symbols = found if chosen else new.carried | {attribute}
        return replace(new, symbols=symbols, chosen=chosen, unclear=unclear, reference=self.layout.names(chosen),
                       reference_kind="object")  # fmt: skip

    def _lies_there(self, phrase: Phrase, mask: int, place: Meaning) -> None:
        """Refuse what is clearly on the other half: the leftmost of all is not "on the left" there."""
        direction = {"top": "back", "bottom": "front"}.get(str(place.relation), str(place.relation))
        if place.preposition not in ("on", "at", "in", "to") or place.index or direction not in _SIDES or not mask:
            return
        if float(self.layout.extent(mask, direction).mean()) < self.select.middle(direction) - 0.03:
            raise NotAnnotatable(f"{phrase.text!r}: it is on the other side")

    def _narrowed(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> tuple[Meaning, str, bool]:
        """The head with a smaller pool or a way to choose; of which kind of arrangement; whether up is up there."""
        layout, pool = self.layout, head.pool
        if modifier.sort == "direction":
            return self._directed(phrase, head, modifier), "", False
        if modifier.sort in ("robot", "speaker"):
            if head.relation not in ("near", "far"):
                raise NotAnnotatable(f"{phrase.text!r}: what about the robot?")
            if modifier.sort == "speaker":
                relation = "far" if head.relation == "near" else "near"
                return replace(head, relation=relation, by_speaker=True), "", False
            return head, "", False
        if modifier.sort in ("container", "many", "one"):
            if modifier.sort == "one" and not modifier.preposition:
                return self._predicated(phrase, head, modifier), "", False
            modifier = self._resolved(phrase, head, modifier)
            if head.relation in ("near", "far") and modifier.preposition in ("to", "from"):
                return replace(head, nearest_to=modifier.reference, away=head.relation == "far", relation=None,
                               index=head.index), "", False  # fmt: skip
            carried = frozenset(s for s in modifier.symbols if isinstance(s, Container))
            kind = modifier.reference_kind
            return replace(head, pool=pool & modifier.chosen, carried=head.carried | carried), kind, kind == "tower"
        if modifier.sort == "region" and modifier.region is not None:
            return self._placed(phrase, head, modifier)
        if modifier.sort == "lone":
            return replace(head, pool=self.select.alone(phrase, pool)), "", False
        if modifier.sort == "moved":
            return replace(head, pool=pool & modifier.chosen), "", False
        if modifier.sort == "color":
            return replace(head, pool=pool & layout.matching(None, modifier.color), color=modifier.color), "", False
        if modifier.sort in _SILENT:
            return head, "", False
        raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of a block")

    def _resolved(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        """Of the three: of the only set of three that can be seen."""
        if modifier.chosen:
            return modifier
        pool = modifier.pool
        cands = [a for a in self.arrangements if a[1].bit_count() == modifier.number and not a[1] & ~pool]
        if modifier.sort != "many" or len(cands) != 1 or modifier.preposition not in ("of", "in", "from"):
            raise NotAnnotatable(f"{phrase.text!r}: {modifier.sort} is not determined")
        return replace(modifier, chosen=cands[0][1], reference=self.layout.names(cands[0][1]),
                       reference_kind=cands[0][0])  # fmt: skip

    def _directed(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        pool, said, index = head.pool, modifier.relation, modifier.index or head.index
        corner = modifier.corner
        if modifier.comparative:
            head = replace(head, comparative=True)
        if modifier.place in _RESTRICTING:
            table = self._table()
            regions = [Region(name, "object", table) for name in (corner or (str(said),))]
            for name in corner or (str(said),):
                pool &= self.select.half(phrase, pool, name, clear=True)
            return replace(head, pool=pool, carried=head.carried | frozenset(regions))
        if corner:
            return self._agreeing(phrase, head, modifier) if head.ranks else replace(head, corner=corner, index=index)
        if said is None:
            raise NotAnnotatable(f"{phrase.text!r}: no direction")
        flat = {"top": "back", "bottom": "front"}.get(said, said)
        if head.relation in (None, said) and not head.nearest_to and not head.corner:
            return replace(head, relation=said, index=index, by_speaker=modifier.by_speaker)
        if head.relation in ("near", "far") and modifier.preposition == "to":
            return replace(head, relation=said, index=index)
        if modifier.preposition in ("on", "at", "in", "to") and flat in ("left", "right", "front", "back"):
            return replace(head, pool=self.select.half(phrase, pool, flat, clear=True))
        return self._agreeing(phrase, head, modifier)

    def _agreeing(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        """Two ways to choose, which have to choose the same: "the closest one, farthest to the left"."""
        one, other = (self.select.choose(phrase, head.pool, how) for how in (head, modifier))
        if not one or one != other:
            raise NotAnnotatable(f"{phrase.text!r}: two directions")
        return head

    def _predicated(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        """A block that is the closest one: chosen as the predicate says, among the heads."""
        if head.ranks and modifier.ranks:
            return self._agreeing(phrase, head, modifier)
        pool = head.pool & modifier.pool
        if not modifier.ranks:
            return replace(head, pool=pool if modifier.definite else head.pool & modifier.pool)
        return replace(head, pool=pool, relation=modifier.relation, index=modifier.index, corner=modifier.corner,
                       nearest_to=modifier.nearest_to, away=modifier.away, by_speaker=modifier.by_speaker,
                       comparative=modifier.comparative)  # fmt: skip

    def _placed(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> tuple[Meaning, str, bool]:
        region = modifier.region
        assert region is not None
        pool, carried = head.pool, head.carried | {region} | frozenset(modifier.regions)
        if modifier.nearest_to:
            if head.ranks and head.relation not in ("near", "far"):
                return self._agreeing(phrase, head, modifier), "", False
            return replace(head, nearest_to=modifier.nearest_to, away=modifier.away, relation=None,
                           index=modifier.index or head.index, carried=carried), "", False  # fmt: skip
        if not head.ranks and head.index is None and _means_member(modifier):
            pool &= self.layout.mask(region.objects)
            relation = region.relation
            if region.kind != "tower":
                relation = {"top": "back", "bottom": "front"}.get(relation, relation)
            return replace(head, pool=pool, relation=relation, carried=carried), region.kind, region.kind == "tower"
        if region.kind == "robot":
            if region.relation in ("left", "right") and not head.ranks:
                return replace(head, relation=region.relation, carried=carried), "", False
            return replace(head, carried=carried), "", False
        return replace(head, pool=pool & self.within(modifier), carried=carried), "", False

    def within(self, modifier: Meaning) -> int:
        """The things in the region, or regions, that a modifier speaks of."""
        assert modifier.region is not None
        inside = self.layout.within(modifier.region) if modifier.restricts is None else modifier.restricts
        for region in modifier.regions:
            inside &= self.layout.within(region)
        return inside

    def _chosen(self, phrase: Phrase, new: Meaning, modifier: Meaning, kind: str, upright: bool) -> int:
        pool, region = new.pool, modifier.region
        crowded = modifier.sort == "region" and region is not None and not kind and not new.ranks
        if crowded and region is not None and new.index is None and pool:
            if modifier.strict:
                return self._direct(phrase, pool, region)
            if not single(pool) and modifier.restricts is None and not modifier.regions:
                return self.select.first_met(pool, region)
        if new.relation == "center" and modifier.sort == "direction":
            return self.layout.central(pool)
        return self.select.choose(phrase, pool, new, kind if modifier.chosen or kind else "", upright)

    def _direct(self, phrase: Phrase, pool: int, region: Region) -> int:
        """What is directly there: the first that comes, if it lies straight in that direction."""
        if region.kind == "robot" and region.relation in ("front", "back") and not single(pool):
            nearest = "near" if region.relation == "front" else "far"  # of the speaker across the table, the farthest
            return self.select.rank(phrase, pool, nearest, 1, "")
        if region.kind == "robot" or self._table() == region.objects:
            return pool if single(pool) else 0
        chosen = pool if single(pool) else self.select.first_met(pool, region)
        references = list(indices_of(self.layout.mask(region.objects)))
        if not chosen or not references:
            return chosen
        index = next(indices_of(chosen))
        if not lies_directly(self.layout.positions, self.layout.edges, index, references, region.relation):
            raise NotAnnotatable(f"{phrase.text!r}: not directly there")
        return chosen

    def _table(self) -> tuple[str, ...]:
        return tuple(item.id for item in self.layout.world.objects if item.type == "table")[:1]

    def _many(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        layout, pool, number, relation = self.layout, head.pool, head.number, head.relation
        kind, chosen, carried = "group", 0, head.carried
        if modifier.sort == "direction" and modifier.place in _RESTRICTING:
            new = self._directed(phrase, head, modifier)
            pool, carried = new.pool, new.carried
            chosen = self.select.count(phrase, pool, number, relation)
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
        elif modifier.sort in _SILENT:
            chosen = self.select.count(phrase, pool, number, relation)
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of blocks")
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
        elif modifier.sort not in _SILENT:
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
        return cands, frozenset(s for s in modifier.symbols if isinstance(s, ContainerAttribute))

    def _place(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        relation = head.relation
        if head.comparative:
            raise NotAnnotatable(f"{phrase.text!r}: construction not covered")
        if head.corner or relation in ("near", "far"):
            return self._point(phrase, head, modifier)
        if modifier.sort in ("robot", "speaker"):
            name = str(relation)
            if modifier.sort == "speaker":
                name = {"front": "back", "back": "front", "left": "right", "right": "left"}.get(name, name)
            region = Region(name, "robot", ())
        elif modifier.sort == "one" and not modifier.reference and 0 < modifier.pool.bit_count() <= MOST_REFERENCES:
            region = Region(str(relation), "object", self.layout.names(modifier.pool))
        elif modifier.sort in ("table", "one", "container", "many") and modifier.reference:
            if modifier.sort == "table" and head.definite and relation in ("top", "bottom"):
                relation = {"top": "back", "bottom": "front"}[relation]
            region = Region(str(relation), modifier.reference_kind, modifier.reference)
        elif modifier.sort == "direction" and modifier.place and relation == "center":
            if modifier.relation in (None, "center", "between"):
                raise NotAnnotatable(f"{phrase.text!r}: the middle of what?")
            return replace(modifier, relation=None, corner=_middle_of(str(modifier.relation)), place="edge",
                           symbols=modifier.symbols | {SpatialReference("center")})  # fmt: skip
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a place needs something that is determined")
        return Meaning("region", frozenset({region}), region=region, relation=relation, definite=head.definite)

    def _point(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        """The corner of the table; the closest to you; the farthest from the tower."""
        symbols = frozenset(s for s in head.symbols if isinstance(s, SpatialReference))
        if modifier.sort == "table" and (head.corner or head.place):
            return replace(head, symbols=symbols)
        if head.corner:
            if head.place or modifier.sort not in ("one", "container") or not modifier.reference:
                raise NotAnnotatable(f"{phrase.text!r}: a corner of what?")
            first, second = ({"top": "back", "bottom": "front"}.get(name, name) for name in head.corner)
            regions = [Region(name, modifier.reference_kind, modifier.reference) for name in (first, second)]
            return Meaning("region", frozenset(regions), region=regions[0], regions=(regions[1],))
        if head.place and modifier.sort in ("table", "container") and modifier.reference and head.relation:
            region = Region(head.relation, modifier.reference_kind, modifier.reference)
            flat = Region("back" if head.relation == "far" else "front", region.kind, region.objects)
            return Meaning("region", frozenset({region}), region=region, restricts=self.layout.within(flat))
        if modifier.sort == "robot":
            return replace(head, symbols=symbols)
        if modifier.sort == "speaker":
            name = "far" if head.relation == "near" else "near"
            return replace(head, symbols=frozenset({SpatialReference(name)}), relation=name, by_speaker=True)
        if modifier.sort == "direction" and modifier.relation and modifier.preposition in ("to", "on"):
            return modifier
        if (
            modifier.sort in ("one", "container", "many")
            and modifier.reference
            and modifier.preposition
            in (
                "to",
                "from",
            )
        ):
            region = Region(str(head.relation), modifier.reference_kind, modifier.reference)
            return Meaning("region", frozenset({region}), region=region, nearest_to=modifier.reference,
                           away=head.relation == "far", index=head.index)  # fmt: skip
        raise NotAnnotatable(f"{phrase.text!r}: construction not covered")


def _middle_of(side: str) -> tuple[str, str]:
    return (side, "center") if side in ("front", "back", "top", "bottom", "near", "far") else ("center", side)


def _means_member(modifier: Meaning) -> bool:
    """Whether a place names a member: the top of a tower, the middle of a row, what is at its end."""
    region = modifier.region
    if region is None or region.kind in ("object", "robot") or modifier.regions:
        return False
    if region.relation in ("left", "right", "front", "back", "near", "far"):
        return modifier.preposition == "at"
    if region.relation in ("top", "bottom"):
        return region.kind == "tower" or (modifier.preposition in ("at", "in") and region.kind in ("row", "column"))
    return region.relation == "center"
