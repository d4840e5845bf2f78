"""Manners of speaking that touch a whole text: articles dropped, hesitation, a word said twice."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from grounding.language.tree import Phrase, Word

_DROPPED = 0.05
_HESITATION = 0.03
_VOWEL = re.compile("[aeio](?!ne)|up")
_ADVERBS = ("UH", "RB")
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


def settle_adverbs(phrase: Phrase) -> Phrase:
    """Make "please", "then" and the like words of the verb phrase that they stand next to, not phrases around it."""
    children = tuple(settle_adverbs(child) if isinstance(child, Phrase) else child for child in phrase.children)
    words = [child for child in children if isinstance(child, Word)]
    if phrase.tag == "VP" and words and len(words) == len(children) - 1 and all(w.tag in _ADVERBS for w in words):
        place = next(index for index, child in enumerate(children) if isinstance(child, Phrase))
        inner = children[place]
        assert isinstance(inner, Phrase)
        if inner.tag == "VP":
            return _embrace(children[:place], inner, children[place + 1 :])
    return Phrase(phrase.tag, children)


def _embrace(before: tuple[Word | Phrase, ...], inner: Phrase, after: tuple[Word | Phrase, ...]) -> Phrase:
    """A verb phrase with words before and after it; where it joins several, in the first and in the last of them."""
    if inner.words and inner.words[0].tag != "CC":
        return Phrase("VP", (*before, *inner.children, *after))
    first, *middle, last = inner.children
    assert isinstance(first, Phrase)
    assert isinstance(last, Phrase)
    return Phrase("VP", (_embrace(before, first, ()), *middle, _embrace((), last, after)))


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
    named = any(isinstance(child, Word) and child.tag in ("NN", "NNS") for child in kept)
    return Phrase(phrase.tag, kept) if phrase.tag == "NP" and named else phrase


def mend_articles(phrase: Phrase) -> Phrase:
    """Say "an" before vowels, in a tree whose words are numbered."""
    following = dict(pairwise(phrase.leaves))
    return _map(
        phrase,
        lambda part: Phrase(
            part.tag,
            tuple(
                Word("an", child.tag, child.index)
                if isinstance(child, Word) and child.text == "a" and _VOWEL.match(following[child].text)
                else child
                for child in part.children
            ),
        ),
    )


def _after_first_word(phrase: Phrase, filler: Word) -> Phrase:
    return Phrase(phrase.tag, (phrase.children[0], filler, *phrase.children[1:]))
