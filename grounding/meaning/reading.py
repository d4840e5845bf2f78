"""What reading a phrase needs of its surroundings: what was spoken of before, and the reader of phrases within."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from grounding.language.tree import Phrase
from grounding.lexicon.kind import is_type
from grounding.meaning.nouns import Noun
from grounding.meaning.referents import Condition, Referent


@dataclass(frozen=True)
class Context:
    """What was spoken of or handled before.

    Attributes:
        mentioned: what was spoken of last, or None.
        several: whether that were several.
        handled: whether something was handled before.
        sizes: whether there are things of different sizes.
        types: the names that the world has for types of things.
    """

    mentioned: Referent | None = None
    several: bool = False
    handled: bool = False
    sizes: bool = False
    types: frozenset[str] = frozenset()

    def knows(self, noun: Noun) -> bool:
        """Whether a noun that the table of words lacks is the name of a type of the world."""
        return noun.strange and any(is_type(noun.unknown[-1], name) for name in self.types)


class Reads(Protocol):
    """A reader of noun phrases and modifiers, given to those that read the phrases around them."""

    context: Context

    def refer(self, noun: Noun) -> Referent:
        """What a noun speaks of."""

    def conditions(self, phrase: Phrase, head: Noun) -> list[Condition]:
        """What a modifier says of what a noun speaks of."""
