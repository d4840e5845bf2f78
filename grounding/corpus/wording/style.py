"""Manners of speaking that touch a whole text: articles dropped, hesitation, a word said twice."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from grounding.language.tree import Phrase, Word

_DROPPED = 0.05
_HESITATION = 0.03
_FILLERS = ("um", "uh", "er")


def speak(tree: Phrase, rng: np.random.Generator) -> tuple[Phrase, tuple[str, ...]]:
    """A tree as a careless speaker would say it, and the names of what was done to it, often nothing."""
    manners: list[str] = []
    if rng.random() < _DROPPED:
        tree = _map(tree, lambda phrase: _without_articles(phrase, rng))
        manners.append("style.articles_dropped")
    if rng.random() < _HESITATION:
        nouns = [phrase for phrase in tree.preorder() if phrase.tag == "NP" and len(phrase.words) > 1]
        if nouns:
            chosen = nouns[int(rng.integers(len(nouns)))]
            filler = Word(_FILLERS[int(rng.integers(len(_FILLERS)))], "UH", 0)
            tree = _map(tree, lambda phrase: _after_first_word(phrase, filler) if phrase is chosen else phrase)
            manners.append("style.hesitation")
    return tree, tuple(manners)


def _map(phrase: Phrase, change: Callable[[Phrase], Phrase]) -> Phrase:
    """Change every phrase, those above before those below."""
    changed = change(phrase)
    children = tuple(_map(child, change) if isinstance(child, Phrase) else child for child in changed.children)
    return Phrase(changed.tag, children)


def _without_articles(phrase: Phrase, rng: np.random.Generator) -> Phrase:
    kept = tuple(
        child
        for child in phrase.children
        if not (isinstance(child, Word) and child.text in ("the", "a", "an") and rng.random() < 0.85)
    )
    return Phrase(phrase.tag, kept) if phrase.tag == "NP" and kept else phrase


def _after_first_word(phrase: Phrase, filler: Word) -> Phrase:
    return Phrase(phrase.tag, (phrase.children[0], filler, *phrase.children[1:]))
