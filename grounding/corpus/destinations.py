"""Where something is to be placed: the regions that the phrases of a destination mean."""

from __future__ import annotations

from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.noun_phrases import NounPhrases
from grounding.corpus.prepositions import Prepositions
from grounding.language.tree import Phrase
from grounding.symbols import Region, Symbol

_FLAT = {"top": "back", "bottom": "front", "near": "front", "far": "back"}


class Destinations:
    """Destinations in one world."""

    def __init__(self, noun_phrases: NounPhrases) -> None:
        self.layout = noun_phrases.layout
        self.prepositions = Prepositions(noun_phrases.select)

    def regions(
        self, phrase: Phrase, places: tuple[Meaning, ...], moved: int
    ) -> tuple[list[Region], frozenset[Symbol]]:
        """The region of an action, or several where it is open which one, and further regions that hold as well.

        Args:
            phrase: for messages.
            places: what was said of where it goes.
            moved: what is moved, a mask.

        Raises:
            NotAnnotatable: no destination, or one that is not covered.
        """
        parts = [part for place in places for part in parts_of(place)]
        if not parts:
            raise NotAnnotatable(f"VP {phrase.text!r}: no destination")
        found = [self._region(phrase, part, moved) for part in parts]
        first = found[0]
        if len(found) == 1 and _alternative(parts[0]):
            return first, frozenset()  # one of them, whichever
        if any(_alternative(part) for part in parts):
            raise NotAnnotatable(f"VP {phrase.text!r}: it is open which of several places is meant")
        every = [region for regions in found for region in regions]
        every = list(dict.fromkeys(every))
        return [every[0]], frozenset(every[1:])

    def _region(self, phrase: Phrase, place: Meaning, moved: int) -> list[Region]:
        region = place.region
        if place.nearest_to:
            raise NotAnnotatable(f"VP {phrase.text!r}: the destination is not covered")
        if place.sort == "region" and region is not None and region.kind != "robot":
            if place.regions:
                return [region, *place.regions]
            if place.restricts is not None and not place.contact:
                raise NotAnnotatable(f"VP {phrase.text!r}: the destination is not covered")
            if region.kind == "object" and len(region.objects) > 1 and region.relation != "between":
                return [Region(region.relation, "object", (name,)) for name in region.objects]
            return [region]
        if place.sort == "direction" and (place.relation or place.corner):
            return self._towards(phrase, place, moved)
        if place.sort in ("one", "container") and place.preposition == "to" and place.reference:
            return [Region("near", place.reference_kind, place.reference)]
        if place.sort == "container" and place.preposition == "in" and place.chosen:
            return [Region("near", place.reference_kind, place.reference)]
        raise NotAnnotatable(f"VP {phrase.text!r}: the destination is not covered")

    def _towards(self, phrase: Phrase, place: Meaning, moved: int) -> list[Region]:
        """To the left: of itself. To the left side, the corner, the back: of the table."""
        names = [_FLAT.get(name, name) for name in place.corner or (str(place.relation),)]
        names = [name for name in names if name != "center"] or ["center"]
        table = tuple(item.id for item in self.layout.world.objects if item.type == "table")[:1]
        sideways = not place.corner and names[0] in ("left", "right") and not place.place
        if place.place == "path" or (sideways and (place.preposition == "to" or place.measured)):
            if "center" in names:
                raise NotAnnotatable(f"VP {phrase.text!r}: the destination is not covered")
            return [Region(name, "object", self.layout.names(moved)) for name in names]
        if not table:
            raise NotAnnotatable(f"VP {phrase.text!r}: the destination is not covered")
        return [Region(name, "object", table) for name in names]


def _alternative(place: Meaning) -> bool:
    """Whether a place is that of one of several things."""
    region = place.region
    return (
        region is not None
        and region.kind == "object"
        and len(region.objects) > 1
        and (region.relation != "between" and not place.regions)
    )


def parts_of(place: Meaning) -> tuple[Meaning, ...]:
    """What is said of a place, one by one: "so that it is behind it and on the left"."""
    if place.sort not in ("several", "predicate"):
        return (place,)
    return tuple(found for part in place.parts for found in parts_of(part))
