"""Classes of words that behave alike in a sentence, from the closed-class lexicon."""

from __future__ import annotations

from functools import lru_cache

from grounding.language.lexicon import meanings
from grounding.symbols import Action


@lru_cache(maxsize=4096)
def word_class(word: str) -> str:
    """The class of a word, "" where it has none.

    Args:
        word: lower case.
    """
    names = {f"{meaning.kind}" if isinstance(meaning, Action) else type(meaning).__name__ for meaning in meanings(word)}
    return "+".join(sorted(names))
