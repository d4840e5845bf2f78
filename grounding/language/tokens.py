"""From text to tokens: words, numbers, clitics and punctuation marks, each with its place in the text.

Follows the conventions of the Penn treebank where they matter here: clitics are tokens of their own ("it's" is "it" and
"'s"), words with inner hyphens are not split ("right-hand").
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from itertools import pairwise

from grounding.errors import LanguageError
from grounding.lexicon.vocabulary import vocabulary

SENTENCE_ENDS = frozenset(".!?;…。！？")
_APOSTROPHES = "'’‘ʼ＇`´"
_HYPHENS = "‐‑‒-"
_TOKEN = re.compile(rf"\d+(?:[.,]\d+)+[A-Za-z]*|\w+(?:[{_APOSTROPHES}{_HYPHENS}]\w+)*|\S")
_LENGTH = re.compile(r"(\d+(?:[.,]\d+)*)([A-Za-z]+)")
_CLITIC = re.compile(
    rf"(?P<stem>.+?)(?P<clitic>n[{_APOSTROPHES}]t|[{_APOSTROPHES}](?:s|d|m|ll|re|ve))\Z", re.IGNORECASE
)
_PLAIN = re.compile(r"[\w'.,\-]+\Z")
_FOLD = str.maketrans({**dict.fromkeys(_APOSTROPHES, "'"), **dict.fromkeys(_HYPHENS, "-")})


@dataclass(frozen=True)
class Token:
    """A word, number or mark of a text.

    Attributes:
        text: as it is compared: lower case, with plain apostrophes and hyphens.
        original: as it was written.
        start: offset of its first character in the text.
        end: offset after its last character.
    """

    text: str
    original: str
    start: int
    end: int

    @property
    def is_word(self) -> bool:
        """Whether this is a word or a number, not a punctuation mark."""
        return any(character.isalnum() for character in self.text)

    @property
    def ends_sentence(self) -> bool:
        """Whether this is a mark that ends a sentence."""
        return self.text in SENTENCE_ENDS


def tokenize(text: str) -> tuple[Token, ...]:
    """Split a text into tokens, in order and without overlap.

    Args:
        text: any string.

    Returns:
        at least one token; white space and invisible characters belong to none.

    Raises:
        LanguageError: there is nothing to read in the text.
    """
    tokens: list[Token] = []
    for match in _TOKEN.finditer(text):
        start, end = match.span()
        clitic = _CLITIC.match(match.group())
        cuts = [start, start + clitic.start("clitic"), end] if clitic else [start, end]
        length = _LENGTH.fullmatch(match.group())
        if length and vocabulary().has("unit", length.group(2).lower()):
            cuts = [start, start + length.start(2), end]  # "10cm"
        for first, last in pairwise(cuts):
            original = text[first:last]
            if any(_visible(character) for character in original):
                tokens.append(Token(normal(original), original, first, last))
    if not tokens:
        raise LanguageError(f"expected an instruction and found a text without words: {text[:40]!r}")
    return tuple(tokens)


def _visible(character: str) -> bool:
    return unicodedata.category(character)[0] not in "CZM"


def normal(original: str) -> str:
    """Lower case, plain apostrophes and hyphens, compatibility forms unless these would add blanks or brackets."""
    folded = original.translate(_FOLD).lower()
    compatible = unicodedata.normalize("NFKC", folded)
    return compatible if _PLAIN.match(compatible) else folded
