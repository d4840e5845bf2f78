"""A memory of what was said of a destination and is not used up yet, and the clues that came of it."""

from __future__ import annotations

from dataclasses import replace

from grounding.meaning.goal.clues import Clue, Offset
from grounding.meaning.goal.steering import LINKS
from grounding.meaning.nouns import Noun


class Memory:
    """Words that wait for what they relate to.

    Attributes:
        clues: so far.
        offsets: directions that nothing was named for yet.
        number: a length before its direction, or None.
        counted_first: whether the last direction came after its length.
        relation: in which what is named next stands, or "".
        axis: of an alignment.
        extent: "slightly" or "far", of the next direction.
        strict: whether "directly" was said.
        tower: whether a stack comes about.
        height: of that stack, 0 where it is not said.
        surface: whether the table itself was named.
        table: of several, the one that was named, or None.
        rank: the last ordinal, for what follows it ("the third" "story").
        owner: whose direction is next.
        face: directions of a side of what is moved.
        since: words since the last direction or thing.
        waiting: the first of two between which something lies.
    """

    def __init__(self) -> None:
        self.clues: list[Clue] = []
        self.offsets: list[Offset] = []
        self.number: float | None = None
        self.counted_first = False
        self.relation = ""
        self.axis = ""
        self.extent = ""
        self.strict = False
        self.tower = False
        self.height = 0
        self.surface = False
        self.table: Noun | None = None
        self.rank = 0
        self.owner: str | None = None
        self.face: tuple[str, ...] = ()
        self.since: list[str] = []
        self.waiting: tuple[Noun, ...] = ()

    def measured(self) -> bool:
        """Tells whether the last direction has its length."""
        return bool(self.offsets) and self.offsets[-1].steps is not None

    def lead_from(self, noun: Noun, strict: bool) -> None:
        """Let directions lead from a thing: those from one belong together, also where it is named twice."""
        start = _restart(self.offsets)
        bound, self.offsets = self.offsets[start:], self.offsets[:start]
        self.flush()
        offsets = tuple(bound)
        last = self.clues[-1] if self.clues else None
        if last is not None and last.relation == "offset" and last.nouns[0].text == noun.text:
            self.clues[-1] = replace(last, offsets=(*last.offsets, *offsets), strict=strict or last.strict)
        else:
            self.clues.append(Clue("offset", (noun,), offsets, strict=strict))

    def binds(self) -> bool:
        """Tells whether directions that were named lead from what is named now."""
        if not self.offsets:
            return False
        return set(self.since) <= LINKS and (bool({"of", "from", "than"} & set(self.since)) or self.offsets[-1].binding)

    def named_last(self) -> Noun | None:
        """The noun that was named last, not a place of the table."""
        nouns = [clue.nouns[-1] for clue in self.clues if clue.nouns and clue.nouns[-1].head != "place"]
        return nouns[-1] if nouns else None

    def forget(self) -> None:
        """Begin anew after something was named."""
        self.relation, self.number, self.axis, self.extent = "", None, "", ""
        self.strict, self.owner, self.face, self.since = False, None, (), []

    def flush(self) -> None:
        """Let directions that nothing followed go on from what was said before, or from where it stands."""
        if not self.offsets:
            return
        offsets, self.offsets = tuple(self.offsets), []
        self.counted_first = False
        last = self.clues[-1] if self.clues else None
        if last is None or last.relation in ("make", "toward", "tower"):
            self.clues.append(Clue("own", (), offsets))
        elif last.relation in ("own", "offset", "place"):
            offsets = tuple(replace(offset, counted="way") for offset in offsets)
            self.clues[-1] = last.going(*offsets)
        elif last.relation in ("near", "touch"):
            self.clues[-1] = replace(
                last, relation="offset", offsets=offsets, strict=last.relation == "touch" or last.strict
            )
        elif last.relation == "on":
            if any(offset.steps for offset in offsets) and not all(set(o.names) <= {"up"} for o in offsets):
                self.clues[-1] = replace(last, relation="offset", offsets=offsets)
        elif last.nouns:
            self.clues.append(Clue("offset", last.nouns, offsets))

    def finish(self) -> list[Clue]:
        """All clues; nothing is left open."""
        if self.waiting:
            self.clues.append(Clue("near", self.waiting))
        self.flush()
        if self.height > 1 or (self.tower and not any(clue.relation == "on" for clue in self.clues)):
            self.clues.append(Clue("tower", height=self.height))
        if self.surface and not self.clues:
            self.clues.append(Clue("surface", () if self.table is None else (self.table,)))
        elif self.table is not None:
            self.clues.append(Clue("surface", (self.table,)))
        return self.clues


def _restart(offsets: list[Offset]) -> int:
    """The place where directions begin anew: "down and to the left, half a space right of X" is two ways."""
    for place in range(len(offsets) - 1, 0, -1):
        later = {_AXIS[name] for offset in offsets[place:] for name in offset.names}
        if later & {_AXIS[name] for name in offsets[place - 1].names}:
            return place
    return 0


_AXIS = {"left": 0, "right": 0, "front": 1, "back": 1, "up": 1, "down": 1}
