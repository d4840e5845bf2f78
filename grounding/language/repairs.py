"""Slips of the tongue and their repairs: "the red, sorry, the blue one", "take the left one, no wait, the right one".

What was said wrongly begins with the word that its repair begins with (Levelt, "Monitoring and self-repair in speech",
1983: a repair has the form of what it replaces), and it ends where the words of excuse begin.
"""

from __future__ import annotations

from collections.abc import Sequence

from grounding.language.tokens import Token

_EXCUSING = frozenset("sorry no wait oops pardon rather".split())
_BESIDE = frozenset("i mean mean't meant actually oh er make that it's is".split())
"""Words that stand beside those of excuse."""
_LONGEST = 12
"""So many words are replaced at most."""


def without_slips(tokens: Sequence[Token]) -> tuple[Token, ...]:
    """The tokens with what was said wrongly, and the excuse for it, left out.

    Args:
        tokens: of a text.
    """
    kept = list(tokens)
    index = 1
    while index < len(kept):
        end = _excuse(kept, index)
        if end is None:
            index += 1
            continue
        start = _slip(kept, index, kept[end].text)
        if start is None:
            index = end
            continue
        del kept[start:end]
        index = start + 1
    return tuple(kept)


def _excuse(tokens: Sequence[Token], start: int) -> int | None:
    """The index of the repair behind the words of excuse that begin here, with what sets them off before; or None."""
    end, excused, set_off = start, False, False
    while end < len(tokens):
        token = tokens[end]
        if not token.is_word and not _ends(tokens, end):
            set_off = True
        elif token.text in _EXCUSING and set_off:
            excused = True
        elif not (excused or set_off) or token.text not in _BESIDE:
            break
        end += 1
    return end if excused and end < len(tokens) and tokens[end].is_word else None


def _slip(tokens: Sequence[Token], end: int, first: str) -> int | None:
    """The index at which what was said wrongly begins: the nearest word before that is like the repair's first."""
    words = 0
    for index in range(end - 1, -1, -1):
        if _ends(tokens, index) or words == _LONGEST:
            return None
        words += tokens[index].is_word
        if tokens[index].text == first:
            return index
    return None


def _ends(tokens: Sequence[Token], index: int) -> bool:
    """Tells whether a sentence ends there; where somebody trails off ("the left ...") it goes on."""
    beside = tokens[max(index - 1, 0) : index + 2]
    return tokens[index].ends_sentence and sum(token.text == tokens[index].text for token in beside) == 1
