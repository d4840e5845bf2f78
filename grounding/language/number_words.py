"""Numbers and ranks beyond twenty in one word: "thirty", "twenty-first", "hundredth"."""

from __future__ import annotations

_ONES = "one two three four five six seven eight nine".split()
_FIRSTS = "first second third fourth fifth sixth seventh eighth ninth".split()
_TENS = "twenty thirty forty fifty sixty seventy eighty ninety".split()


def number_of(word: str) -> tuple[int, bool] | None:
    """The value of a number word above twenty, and whether it is a rank; None for other words.

    Args:
        word: lower case, with a hyphen between tens and ones.
    """
    if word in ("hundred", "hundredth"):
        return 100, word.endswith("th")
    stem, _, rest = word.partition("-")
    if rest:
        if stem not in _TENS:
            return None
        tens = 10 * (_TENS.index(stem) + 2)
        if rest in _ONES:
            return tens + _ONES.index(rest) + 1, False
        return (tens + _FIRSTS.index(rest) + 1, True) if rest in _FIRSTS else None
    if stem in _TENS[1:]:
        return 10 * (_TENS.index(stem) + 2), False
    root = stem.removesuffix("ieth") + "y"
    return (10 * (_TENS.index(root) + 2), True) if stem.endswith("ieth") and root in _TENS[1:] else None
