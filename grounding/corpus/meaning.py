"""What a phrase of an annotated example means: the value that annotation passes upward through a gold tree."""

from __future__ import annotations

from dataclasses import dataclass, field

from grounding.errors import CorpusError
from grounding.symbols import Container, ContainerAttribute, ObjectAttribute, ObjectSymbol, Region, Symbol


class NotAnnotatable(CorpusError):
    """A sentence that is not true, not clear or not covered in a world; says which phrase and why."""


@dataclass(frozen=True)
class Meaning:
    """The denotation of one phrase.

    Attributes:
        sort: what the phrase speaks of: "one" (a single object), "many" (several objects), "container", "direction",
            "region", "robot", "speaker", "table", "action", "measure" (a distance), "pronoun" (what was spoken of
            before), "predicate" (what is said of it), "several" (modifiers joined by "and"), "lone", "color", "view",
            "moved", "nothing" (what is not there or not known), "empty" (particles).
        symbols: the symbols that are true of the phrase.
        object_type: label, or None.
        color: label, or None.
        relation: direction of ranking, or None.
        index: rank, or None.
        number: count, or None.
        definite: whether all that match are meant ("the blocks", "all").
        pool: objects that are still possible, a mask.
        chosen: the objects that are meant, a mask; 0 while undetermined.
        kinds: container kinds that the noun allows.
        arrangements: possible arrangements, as (kind, mask).
        reference: ids of what a region can be built on.
        reference_kind: "object" or the kind of the container that `reference` is.
        region: the region, or None.
        preposition: of a PP, its words.
        unclear: whether `chosen` is too close to call; fine while something around it decides.
        size: 1 for "tallest", -1 for "shortest", 0 else.
        corner: directions that name a point together ("top left"); objects are ranked by how near it they are.
        nearest_to: ids that objects are ranked by their distance to.
        away: whether the farthest from `nearest_to` comes first.
        by_speaker: whether `relation`, near or far, is as the speaker sees it.
        comparative: whether one of two is meant ("the closer one").
        indefinite: whether any will do ("a green block").
        place: of a direction, the noun that made it a place ("half", "corner", "side"), or "".
        carried: symbols that restrict `pool` and stay with the phrase while it is undetermined.
        regions: further regions that hold as well ("behind and to the left of").
        contact: whether a region is what touches its reference.
        strict: whether a region asks for what is directly there.
        measured: whether a distance is said.
        verb: kind of an action; of a noun phrase "one" where that is its noun.
        target: what an action is on.
        parts: of "several" and "predicate" what is said; of an action its destinations.
        restricts: of a region, the objects in it where that is not plain from the region, a mask; None where it is.
    """

    sort: str
    symbols: frozenset[Symbol] = frozenset()
    object_type: str | None = None
    color: str | None = None
    relation: str | None = None
    index: int | None = None
    number: int | None = None
    definite: bool = False
    pool: int = 0
    chosen: int = 0
    kinds: tuple[str, ...] = ()
    arrangements: tuple[tuple[str, int], ...] = ()
    reference: tuple[str, ...] = ()
    reference_kind: str = "object"
    region: Region | None = None
    preposition: str = ""
    unclear: bool = False
    size: int = 0
    corner: tuple[str, ...] = ()
    nearest_to: tuple[str, ...] = ()
    away: bool = False
    by_speaker: bool = False
    comparative: bool = False
    indefinite: bool = False
    place: str = ""
    carried: frozenset[Symbol] = field(default_factory=frozenset)
    regions: tuple[Region, ...] = ()
    contact: bool = False
    strict: bool = False
    measured: bool = False
    verb: str = ""
    parts: tuple[Meaning, ...] = ()
    target: Meaning | None = None
    restricts: int | None = None

    @property
    def ranks(self) -> bool:
        """Whether it says which member of a set is meant."""
        return bool(self.relation or self.corner or self.nearest_to)


def is_empty(meaning: Meaning) -> bool:
    """Whether a noun phrase means something that is not there."""
    if meaning.sort == "container":
        return not meaning.chosen and not meaning.arrangements
    return meaning.sort in ("one", "many") and not meaning.chosen and not meaning.pool


def passed(meaning: Meaning) -> frozenset[Symbol]:
    """What a phrase passes on to the one around it: all but the labels and words of the noun phrase itself."""
    if meaning.sort in ("one", "many", "container", "table"):
        kept = (ObjectSymbol, Container, ContainerAttribute, ObjectAttribute)
        return frozenset(s for s in meaning.symbols if isinstance(s, kept))
    return meaning.symbols
