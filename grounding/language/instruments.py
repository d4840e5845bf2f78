"""With which hand something is to be done: said beside the command, and no description of what is handled."""

from __future__ import annotations

import re
from typing import NamedTuple

from grounding.lexicon.vocabulary import vocabulary

SIDES = ("left", "right")
_OWN = r"(?:(?:your|the|its|baxter's|robot's)\s+)*"


class Instrumental(NamedTuple):
    """A text and the hands that it names.

    Attributes:
        text: without the words for hands.
        arms: "left" or "right", in the order in which they were named.
    """

    text: str
    arms: tuple[str, ...]


def without_hands(text: str) -> Instrumental:
    """Take the hands out of a text with which it asks to act: "with your left hand", "use the right arm to ...".

    "On your left hand" and "the left hand side" tell where something is, and stay.

    Args:
        text: the instruction.
    """
    hands = "|".join(sorted(vocabulary().words("instrument", "hand")))
    command = _pattern(hands)
    arms: list[str] = []

    def took(match: re.Match[str]) -> str:
        arms.append((match["with"] or match["use"] or match["first"]).lower())
        return " "

    kept = command.sub(took, text).strip(" ,")
    return Instrumental(kept, tuple(arms)) if arms and re.search(r"\w", kept) else Instrumental(text, ())


def _pattern(hands: str) -> re.Pattern[str]:
    def side(name: str) -> str:
        return rf"{_OWN}(?P<{name}>{'|'.join(SIDES)})[\s-]+(?:{hands})\b(?!\s*-?\s*side)"

    return re.compile(
        rf"\s*,?\s*\b(?:with|by|in|via)\s+{side('with')}(?:\s*,)?\s*"
        rf"|\s*,?\s*\b(?:use|using|employing)\s+{side('use')}(?:\s*,)?(?:\s+(?:to|and)\b)?\s*"
        rf"|^\s*{side('first')}\s*[:,]\s*",
        re.IGNORECASE,
    )
