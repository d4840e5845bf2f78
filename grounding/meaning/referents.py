"""Referents and conditions: what a text speaks of, and what it says of it.

A referent is something spoken of: objects, sets of them, a place, a person. A condition is a concept of the lexicon
that is said of it, with the other referents to which it relates. Conditions restrict ("red", "left of x"), choose a
set of which something is a member ("in the row"), or rank ("nearest to x", "third"). Referents are told apart by
identity: one that is mentioned twice is one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

OBJECTS, SETS, PLACE, PERSON, TABLE, NOTHING = "objects", "sets", "place", "person", "table", "nothing"
RESTRICTING = frozenset(
    "colour kind toward off_middle measured stepped beside touching apart between surrounded at part on on_table alone "
    "before same other recalled outside with_others apart_others strange centre relation".split()
)
CHOOSING = frozenset("member among those".split())
RANKING = frozenset("nearest farthest extreme ordinal middle size".split())


@dataclass(frozen=True)
class Region:
    """A part of the table or of something, by its words.

    Attributes:
        names: of the directions that lead to it; none for the middle.
        middle: whether it is the middle, along what the directions leave free.
        corner: whether a corner is meant.
        rim: whether it is an edge, an end or a corner.
        bare: whether only directions were named ("the left"), without a noun of place.
        owner: whose side it is, or None for whoever looks.
        table: whether it is said to be the table's.
    """

    names: tuple[str, ...] = ()
    middle: bool = False
    corner: bool = False
    rim: bool = False
    bare: bool = False
    owner: str | None = None
    table: bool = False


@dataclass(frozen=True, eq=False)
class Condition:
    """A concept that is said of a referent.

    Attributes:
        concept: its name, one of `RESTRICTING`, `CHOOSING` and `RANKING`.
        of: the referents to which it relates.
        words: colours or directions that it names.
        region: the place that it names.
        owner: whose directions are meant, or None for whoever looks.
        number: an amount in blocks; 1 or -1 for the largest and the smallest.
        ways: directions with amounts, where there are several.
        rank: the place in an order, from 1, -1 for the last; None where another word may tell it.
        strict: "directly", "exactly".
        nearly: "almost".
        counting: whether blocks are counted and not lengths.
        negated: whether it is denied.
        said: the word that says it, for weights that know single words.
        metric: whether `number` is a length in metres and not in blocks.
    """

    concept: str
    of: tuple[Referent, ...] = ()
    words: tuple[str, ...] = ()
    region: Region | None = None
    owner: str | None = None
    number: float | None = None
    ways: tuple[tuple[tuple[str, ...], float], ...] = ()
    rank: int | None = None
    strict: bool = False
    nearly: bool = False
    counting: bool = False
    negated: bool = False
    said: str = ""
    metric: bool = False

    @property
    def restricts(self) -> bool:
        """Whether it holds of each object by itself; what is denied always does."""
        return self.concept in RESTRICTING or self.negated

    @property
    def chooses(self) -> bool:
        """Whether it names a set from which is chosen."""
        return self.concept in CHOOSING and not self.negated

    @property
    def ranks(self) -> bool:
        """Whether it orders what the others leave."""
        return self.concept in RANKING and not self.negated


@dataclass(frozen=True, eq=False)
class Referent:
    """Something that a text speaks of.

    Attributes:
        sort: objects, sets, place, person, table or nothing.
        conditions: what is said of it, in the order of the words.
        kinds: of arrangement, of a set; one of them.
        number: how many, or None.
        plural: whether several are meant.
        definite: False after "a", "some".
        universal: "all", "both".
        only: whether it is the only one.
        like: whether it is of the kind of what it modifies: "of the three".
        parts: what is joined with "and".
        crossing: whether the parts are lines and it is where they meet.
        region: of a place.
        person: "robot" or "speaker".
        text: its words.
    """

    sort: str
    conditions: tuple[Condition, ...] = ()
    kinds: tuple[str, ...] = ()
    number: int | None = None
    plural: bool = False
    definite: bool = True
    universal: bool = False
    only: bool = False
    like: bool = False
    parts: tuple[Referent, ...] = ()
    crossing: bool = False
    region: Region | None = None
    person: str | None = None
    text: str = ""

    def having(self, *conditions: Condition) -> Referent:
        """The same with further conditions."""
        return replace(self, conditions=(*self.conditions, *conditions))

    def all(self) -> Iterator[Referent]:
        """It and everything that it relates to, each as often as it is named, inner ones first."""
        for inner in (*self.parts, *(r for condition in self.conditions for r in condition.of)):
            yield from inner.all()
        yield self


def again(referent: Referent, *conditions: Condition) -> Referent:
    """What a referent means, with conditions that hold of what was chosen, not of what is chosen from."""
    return Referent(OBJECTS, (Condition("same", (referent,)), *conditions), text=referent.text)
