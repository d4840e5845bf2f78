"""A text followed clause by clause, with what its nouns mean literally in the place of referents."""

from __future__ import annotations

from dataclasses import dataclass, field

from grounding.language.tree import Phrase
from grounding.literal.choosing import half
from grounding.literal.reader import LiteralReader
from grounding.literal.values import FIRM, Meant, Missing, Unread
from grounding.meaning.nouns import Noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import NOTHING, OBJECTS, PERSON, PLACE, SETS, TABLE, Condition, Referent
from grounding.meaning.wholes import region_of
from grounding.model.surroundings import context_in

_SORTS = {"agent": PERSON, "place": PLACE, "table": TABLE}
_PARTS = frozenset("half side part section area".split())
_HALVES = {"up": "back", "down": "front"}


@dataclass(frozen=True, eq=False)
class Named(Referent):
    """A referent with what it means literally.

    Attributes:
        noun: that names it.
        meant: what it means.
    """

    noun: Noun = field(default_factory=Noun)
    meant: Meant = field(default_factory=lambda: Meant("things"))


@dataclass(frozen=True, eq=False)
class Piece(Condition):
    """A phrase that restricts what was named before it, not read yet.

    Attributes:
        phrase: as it was said.
    """

    phrase: Phrase | None = None


class Follower(Reader):
    """Reads nouns literally where a text is followed.

    Args:
        reader: of nouns, literally.
    """

    def __init__(self, reader: LiteralReader) -> None:
        super().__init__(context_in(reader.scene, reader.history))
        self.literal = reader

    def refer(self, noun: Noun) -> Referent:
        """What a noun means literally, as a referent.

        Raises:
            Unread: it is beyond what is read literally.
            Missing: it means nothing that is there.
        """
        mentioned = self.context.mentioned
        self.literal.spoken_of = None if mentioned is None else self.members(mentioned)
        meant = self.literal.meant(noun)
        if meant.sort != "things":
            sort = _SORTS.get(meant.sort, NOTHING)
            region = region_of(noun, None) if sort == PLACE else None
            return Named(sort, person=meant.agent, region=region, text=noun.text, noun=noun, meant=meant)
        if meant.plural and not meant.chosen and not meant.sets:
            raise Unread("which of them?")
        return Named(SETS if meant.plural else OBJECTS, plural=meant.plural, text=noun.text, noun=noun, meant=meant)

    def conditions(self, phrase: Phrase, head: Noun) -> list[Condition]:
        """A phrase as a condition; it is read where it is known of what it is said."""
        return [Piece("same", phrase=phrase)]

    def members(self, referent: Referent) -> int:
        """All that a referent holds of, as bits.

        Raises:
            Unread: something that is said of it is beyond what is read literally.
            Missing: there is nothing of the kind.
        """
        mask = self.literal.layout.everything
        if isinstance(referent, Named):
            mask = referent.meant.chosen or referent.meant.pool
        for condition in referent.conditions:
            mask = self._restricted(mask, referent, condition)
        return mask

    def sets(self, referent: Referent) -> tuple[int, ...]:
        """What several that are spoken of may be together, as bits; none where single things are."""
        if referent.sort != SETS:
            return ()
        if not isinstance(referent, Named):
            return (self.members(referent),)
        meant = referent.meant
        return tuple(m for _, m in meant.sets) if meant.sets and not meant.chosen else (meant.chosen or meant.pool,)

    def _restricted(self, mask: int, referent: Referent, condition: Condition) -> int:
        if isinstance(condition, Piece):
            return self._narrowed(mask, condition)
        match condition.concept:
            case "same":
                inside = self.members(condition.of[0])
                return mask & ~inside if condition.negated else mask & inside
            case "those" if isinstance(referent, Named):
                inside = self.members(condition.of[0])
                return (mask & inside) | self._within(referent.noun, inside)
            case "at" if condition.region is not None and len(condition.region.names) == 1:
                name = condition.region.names[0]
                inside = half(self.literal.scene, mask, _HALVES.get(name, name), clear=not condition.region.table)
                return self._on_side(referent, inside)
        raise Unread(referent.text)

    def _on_side(self, referent: Referent, mask: int) -> int:
        """What lies on a side of the table that is to be cleared."""
        if _PARTS.isdisjoint(referent.text.split()):
            raise Unread(referent.text)
        if not mask:
            raise Missing(f"there is nothing on {referent.text!r}")
        return mask

    def _narrowed(self, mask: int, piece: Piece) -> int:
        """What a phrase leaves of what was named before it."""
        assert piece.phrase is not None
        try:
            meant = self.literal.meant(Noun(head="block", modifiers=(piece.phrase,), text=piece.phrase.text), mask)
        except Missing as missing:
            raise Unread(str(missing)) from missing
        return meant.chosen or meant.pool

    def _within(self, noun: Noun, inside: int) -> int:
        """What a noun means among things that were spoken of."""
        try:
            meant = self.literal.meant(noun, inside)
        except Missing as missing:
            if max(noun.ordinals, default=0) > inside.bit_count() > 0:
                raise Missing(str(missing), FIRM) from missing  # "there is a tower of four. take the fifth"
            return 0
        return meant.chosen or meant.pool
