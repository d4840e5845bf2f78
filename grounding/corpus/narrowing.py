"""Narrows down which block a noun phrase means: by directions, places, sets that it is of, and predicates."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.selector import Selector
from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase
from grounding.symbols import Container, Region

RESTRICTING = ("half", "part", "section", "area", "portion", "region", "quadrant", "zone")
_SIDES = ("left", "right", "front", "back")
SILENT = ("view", "table", "empty")


class Narrowing:
    """What modifiers leave of a noun phrase's objects, in one world."""

    def __init__(self, select: Selector, arrangements: tuple[tuple[str, int], ...]) -> None:
        self.layout = select.layout
        self.arrangements = arrangements
        self.select = select

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
        if modifier.sort in SILENT:
            return head, "", False
        raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of a block")

    def _lies_there(self, phrase: Phrase, mask: int, place: Meaning) -> None:
        """Refuse what is clearly on the other half: the leftmost of all is not "on the left" there."""
        direction = {"top": "back", "bottom": "front"}.get(str(place.relation), str(place.relation))
        if place.preposition not in ("on", "at", "in", "to") or place.index or direction not in _SIDES or not mask:
            return
        if float(self.layout.extent(mask, direction).mean()) < self.select.middle(direction) - 0.03:
            raise NotAnnotatable(f"{phrase.text!r}: it is on the other side")

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
        if modifier.place in RESTRICTING:
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

    def _table(self) -> tuple[str, ...]:
        return tuple(item.id for item in self.layout.world.objects if item.type == "table")[:1]


def noticed(layout: Layout, kinds: tuple[str, ...], color: str | None, number: int | None) -> bool:
    """Whether something that was not laid, and does not catch the eye, looks a little like an arrangement."""
    counts = frozenset() if number is None else frozenset((number,))
    found = layout.fitting(kinds, layout.matching(None, color), counts)
    return "tower" not in kinds and any(a.noticed for a in found)


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
