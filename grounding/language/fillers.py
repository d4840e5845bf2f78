"""Words that people say while they think: "um, take the, uh, red one", "okay so, there are two rows"."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.language.tokens import Token

_HESITATING = frozenset("um uh er erm hm hmm uhm umm eh ah oh".split())
_OPENING = frozenset("okay ok so well right now hey alright anyway great good listen look see robot baxter hello hi"
                     .split())  # fmt: skip
"""What opens a sentence and says nothing where a comma follows."""


def without_fillers(tokens: Sequence[Token]) -> tuple[Token, ...]:
    """The tokens without hesitation and without what only opens a sentence; all of them where nothing is left.

    Args:
        tokens: of a text.
    """
    kept: list[Token] = []
    index = 0
    while index < len(tokens):
        begins = not any(token.is_word for token in kept) or kept[-1].ends_sentence
        length = _opening(tokens, index) if begins else 0
        if tokens[index].text in _HESITATING:
            length = 1
        if not length:
            kept.append(tokens[index])
            index += 1
            continue
        index += length
        if index < len(tokens) and tokens[index].text == ",":
            index += 1
            if kept and kept[-1].text == ",":
                kept.pop()  # "the, um, red one"
    return tuple(kept) if any(token.is_word for token in kept) else tuple(tokens)


def _opening(tokens: Sequence[Token], start: int) -> int:
    """How many words only open the sentence that begins there."""
    end = start
    while end < len(tokens) and tokens[end].text in _OPENING:
        end += 1
    return end - start if end > start and end < len(tokens) and tokens[end].text == "," else 0
