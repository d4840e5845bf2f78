"""What reading a phrase needs of its surroundings: what was spoken of before, and the reader of phrases within."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from grounding.language.tree import Phrase
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
    """

    mentioned: Referent | None = None
    several: bool = False
    handled: bool = False
    sizes: bool = False


class Reads(Protocol):
    """A reader of noun phrases and modifiers, given to those that read the phrases around them."""

    context: Context

    def refer(self, noun: Noun) -> Referent:
        """What a noun speaks of."""

    def conditions(self, phrase: Phrase, head: Noun) -> list[Condition]:
        """What a modifier says of what a noun speaks of."""
