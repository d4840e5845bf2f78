"""What a phrase of an annotated example means: the value that annotation passes upward through a gold tree."""

from __future__ import annotations

from dataclasses import dataclass

from grounding.errors import CorpusError
from grounding.symbols import Container, ContainerAttribute, ObjectAttribute, ObjectSymbol, Region, Symbol


class NotAnnotatable(CorpusError):
    """A sentence that is not true, not clear or not covered in a world; says which phrase and why."""


@dataclass(frozen=True)
class Meaning:
    """The denotation of one phrase.

    Attributes:
        sort: what the phrase speaks of: "one" (a single object), "many" (several objects), "container", "direction",
            "region", "robot", "table", "action", "nothing" (what is not there or not known),
            "empty" (particles and pronouns).
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
