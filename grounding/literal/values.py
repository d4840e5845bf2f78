"""Values of literal readings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from grounding.meaning.nouns import Noun
from grounding.symbols import Region
from grounding.world import Array

FAINT = 0.1
"""The limit of what is missing where relations are vague."""
PLAIN = 0.3
"""The limit of what is missing by colours and counts, where eyes differ little."""
FIRM = float("inf")
"""The limit of what is missing for every eye."""


class Unread(Exception):
    """A word or a construction that is not read literally, or something too close to call."""


class Missing(Exception):
    """Something that is spoken of is not there; the message is a sentence for people.

    Args:
        text: the sentence.
        limit: it is believed where the graded reading agrees less with the world than this.
        noun: whose words hold of nothing, the innermost; None where that is not one noun.
        shape: whether nothing here has the shape, wherever it may lie.
    """

    def __init__(self, text: str, limit: float = FAINT, noun: Noun | None = None, *, shape: bool = False) -> None:
        super().__init__(text)
        self.limit = limit
        self.noun = noun
        self.shape = shape


@dataclass(frozen=True, eq=False)
class Order:
    """What ranks things.

    Attributes:
        key: larger first, of a set of things, shape (its size,).
        index: rank from 1, -1 for the last; None where the noun may have one.
        name: of the direction, "" for others; equal ones agree.
        margin: by how much the one that is meant is set apart in [m].
        reference: the things to which distances are measured, which are not meant themselves.
    """

    key: Callable[[int], Array]
    index: int | None = None
    name: str = ""
    margin: float = 0.01
    reference: int = 0


@dataclass(frozen=True)
class Narrow:
    """What restricts things.

    Attributes:
        mask: that it holds of.
        region: whose nearest one is meant where it holds of several, or None.
        strict: whether what is straight there is asked for.
        vague: whether eyes differ on what it holds of.
        chosen: whether it names one by itself: "which is the farthest one".
    """

    mask: int
    region: Region | None = None
    strict: bool = False
    vague: bool = False
    chosen: bool = False


@dataclass(frozen=True)
class Sided:
    """A side of the table: half of it where something else ranks, else what lies farthest there.

    Attributes:
        name: left, right, front, back, top, bottom, near, far or center.
        half: whether a part of the table is named as such.
        index: counted from there, or None.
        narrows: whether it restricts what something else ranks: "on the left", not "closest to the left".
        there: whether it has to lie there: "on the left", not "from the left".
    """

    name: str
    half: bool = False
    index: int | None = None
    narrows: bool = True
    there: bool = False


@dataclass(frozen=True)
class Member:
    """Of which set something is.

    Attributes:
        mask: of the set.
        kind: of arrangement, or "group".
        to: whether it may be what distances are measured to or from.
    """

    mask: int
    kind: str = "group"
    to: bool = False


@dataclass(frozen=True)
class Viewed:
    """Somebody is named, from whom distances are measured.

    Attributes:
        agent: robot or speaker.
        preposition: before them.
    """

    agent: str
    preposition: str = ""


Effect = Order | Narrow | Sided | Member | Viewed


@dataclass(frozen=True)
class Meant:
    """What a noun phrase means.

    Attributes:
        sort: things, place, agent, table.
        pool: of things, what it holds of.
        chosen: what is meant; 0 where it holds of several.
        kind: of what is meant together: object, group, or a kind of arrangement.
        plural: whether several are meant together.
        number: how many, or None.
        definite: False for "a block".
        sets: of arrangements, those that it holds of.
        parts: of two things that are joined, each.
        names: of a place, its directions.
        place: its noun, or "".
        agent: who is meant, or whose place it is.
    """

    sort: str
    pool: int = 0
    chosen: int = 0
    kind: str = "object"
    plural: bool = False
    number: int | None = None
    definite: bool = True
    sets: tuple[tuple[str, int], ...] = ()
    parts: tuple[Meant, ...] = ()
    names: tuple[str, ...] = ()
    place: str = ""
    agent: str | None = None
