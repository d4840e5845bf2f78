"""Composes noun phrases that name a place: the left of something, its corner, the middle of an edge."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.prepositions import MOST_REFERENCES
from grounding.corpus.set_phrases import SetPhrases
from grounding.language.tree import Phrase
from grounding.symbols import Region, SpatialReference


class PlacePhrases(SetPhrases):
    """Noun phrases for places, in one world."""

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
        return Meaning("region", frozenset({region}), region=region, relation=relation, definite=head.definite,
                       indefinite=modifier.indefinite and not modifier.reference)  # fmt: skip

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
