"""Misspellings: which known words an unknown word may have been meant to be, and how probable each is.

The distance is that of F. Damerau, "A technique for computer detection and correction of spelling errors" (CACM 7(3),
1964): insertions, deletions, substitutions and transpositions of neighbours, each letter touched once. The parser
decides between the candidates, so that frequency and context count, and a word may also stay what it is.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from grounding.language.english import COMMON

_MOST_CANDIDATES = 3
_PER_EDIT = -3.0
_OTHER_BEGINNING = -2.0
_LONG = 8
"""Letters from which on a word may have suffered two edits."""
_ENDINGS = ("s", "es", "ed", "ing", "er")


class Spelling(NamedTuple):
    """A word that may have been meant."""

    word: str
    log_probability: float
    """Of what was written, when this was meant."""


class Speller:
    """Finds candidates among known words."""

    def __init__(self, words: Iterable[str]) -> None:
        """Know words.

        Args:
            words: in lower case; those with anything but letters are not meant by any misspelling.
        """
        self._known = frozenset(words := tuple(words))
        self._words = tuple((word, _letters(word)) for word in sorted(set(words)) if word.isalpha() and len(word) > 2)

    def candidates(self, written: str) -> tuple[Spelling, ...]:
        """What may have been meant by a word nobody knows, the likeliest first; nothing for a common English word."""
        allowed = _allowed(written)
        if not allowed or _is_english(written) or self._is_participle(written):
            return ()
        letters = _letters(written)
        found: list[tuple[float, str]] = []
        for word, own in self._words:
            if abs(len(word) - len(written)) > allowed or (letters ^ own).bit_count() > 2 * allowed:
                continue
            edits = distance(written, word)
            if edits > min(allowed, _allowed(word)) or _differs_in_number(written, word):
                continue
            cost = _PER_EDIT * edits + (0.0 if word[0] == written[0] else _OTHER_BEGINNING)
            if word[0] != written[0] and (len(written) < 5 or edits > 1) and not _transposed(written, word):
                continue
            found.append((cost, word))
        found.sort(key=lambda item: (-item[0], item[1]))
        best = [(cost, word) for cost, word in found if cost >= found[0][0] - abs(_PER_EDIT)]
        return tuple(Spelling(word, cost) for cost, word in best[:_MOST_CANDIDATES])

    def _is_participle(self, word: str) -> bool:
        """Whether a word is the -ing form of a known one: "taking" is no misspelling of "making"."""
        stem = word.removesuffix("ing")
        forms = {stem, stem + "e"} | ({stem[:-1]} if stem[-1:] == stem[-2:-1] else set())
        return stem != word and len(stem) > 2 and bool(forms & self._known)


def distance(one: str, other: str) -> int:
    """How many edits lead from one word to another."""
    before: list[int] = []
    row = list(range(len(other) + 1))
    for i, a in enumerate(one, start=1):
        row, before, last = [i], row, before
        for j, b in enumerate(other, start=1):
            steps = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (a != b))
            if i > 1 and j > 1 and a == other[j - 2] and b == one[i - 2]:
                steps = min(steps, last[j - 2] + 1)
            row.append(steps)
    return row[-1]


def _allowed(word: str) -> int:
    """How many edits a word of this length may have suffered."""
    if not word.isalpha() or len(word) < 3:
        return 0
    return 1 if len(word) < _LONG else 2


def _is_english(word: str) -> bool:
    """Whether a word is a common one, or a form of one."""
    stems = [word[: -len(ending)] for ending in _ENDINGS if word.endswith(ending)]
    stems += [stem + "e" for stem in stems] + [stem[:-1] for stem in stems if stem[-1:] == stem[-2:-1]]
    return word in COMMON or any(stem in COMMON for stem in stems if len(stem) > 2)


def _letters(word: str) -> int:
    """The letters of a word as bits."""
    bits = 0
    for letter in word:
        bits |= 1 << (ord(letter) % 64)
    return bits


def _transposed(one: str, other: str) -> bool:
    return len(one) == len(other) and sorted(one) == sorted(other)


def _differs_in_number(one: str, other: str) -> bool:
    """Whether two words differ in the s of the plural only: these are forms, not misspellings."""
    return one + "s" == other or other + "s" == one
