"""Clues of the point that a destination means: relations to something, with directions and lengths."""

from __future__ import annotations

from dataclasses import dataclass, replace

from grounding.meaning.nouns import Noun

RELATION = "relation."
"""Before the name of a relation that is a module of the lexicon."""


@dataclass(frozen=True)
class Offset:
    """One direction with its length.

    Attributes:
        names: directions; "up" and "down" are away and near on a table that is looked down on.
        steps: how many blocks far, or None where nothing is said.
        extent: of what is unsaid: "slightly", "far", or "".
        owner: whose directions, or None where nobody is named.
        binding: whether the word needs something that it is a direction from ("above", "behind").
        counted: "sides" where the length may lie between the sides ("two spaces left of X"), "way" where it is one
            that is gone after something was reached ("above X, up two").
    """

    names: tuple[str, ...]
    steps: float | None = None
    extent: str = ""
    owner: str | None = None
    binding: bool = False
    counted: str = "sides"


@dataclass(frozen=True)
class Clue:
    """One thing that is said about where something is to go.

    Attributes:
        relation: "own", from where it stands; "offset", from the references; "on" one of them; "near"; "touch";
            "between"; "align", in a row or column with them; "in" a set of them; "toward"; "apart" from them; "place",
            of the table; "surface", on the table; "tower", on anything; "make", so that an arrangement comes about; or
            `RELATION` with the name of a relation.
        nouns: what it relates to; none for what stands by itself.
        offsets: directions and lengths from there.
        axis: "row" or "column" of what is aligned, or "" where either may be.
        strict: whether "directly" is said.
        height: of the tower that comes about, in blocks, or 0 where that is not said.
    """

    relation: str
    nouns: tuple[Noun, ...] = ()
    offsets: tuple[Offset, ...] = ()
    axis: str = ""
    strict: bool = False
    height: int = 0

    def going(self, *offsets: Offset) -> Clue:
        """The same with further offsets."""
        return replace(self, offsets=(*self.offsets, *offsets))
