"""Numbers in words, as people read them."""

from __future__ import annotations

from collections.abc import Sequence

_WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
_ORDINALS = ("", "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
             "eleventh", "twelfth")  # fmt: skip


def spelled(count: int) -> str:
    """A number up to twelve as a word, a larger one in digits."""
    return _WORDS[count] if 0 <= count < len(_WORDS) else str(count)


def counted(count: int) -> str:
    """How many there are, as a clause: "there is only one", "there are three"."""
    return "there is only one" if count == 1 else f"there are {spelled(count)}"


def ranked(rank: int) -> str:
    """A rank up to the twelfth as a word, a later one in digits."""
    if 0 < rank < len(_ORDINALS):
        return _ORDINALS[rank]
    ending = "th" if rank % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(rank % 10, "th")
    return f"{rank}{ending}"


def listed(words: Sequence[str], joint: str = "and") -> str:
    """Words in a row: "red, green and blue"."""
    if not words:
        return "nothing"
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} {joint} {words[-1]}"
