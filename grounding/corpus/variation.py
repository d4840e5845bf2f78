"""Variants of gold trees: closed-class words exchanged for others of their class, modifiers attached elsewhere.

"the second red block from the left" teaches little about "the fifth blue cube from the right" by itself; its variants
do. What is exchanged keeps its part of speech, so that the tree stays a gold tree.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from grounding.language.tree import Phrase, Word

_CLASSES: tuple[tuple[str, ...], ...] = (
    ("NN", "block", "box", "cube", "brick", "block"),
    ("NNS", "blocks", "boxes", "cubes", "bricks", "blocks"),
    ("JJ", "red", "blue", "green", "yellow", "purple", "orange", "red", "blue"),
    ("CD", "two", "three", "four", "five", "six", "seven", "eight", "nine", "3", "4", "5"),
    ("JJ", "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "second", "third"),
    ("JJ", "leftmost", "rightmost"),
    ("JJS", "nearest", "closest", "farthest", "furthest"),
    ("JJ", "middle", "center", "central"),
    ("JJ", "left", "right"),
    ("NN", "left", "right"),
    ("JJ", "front", "back"),
    ("NN", "row", "column", "line", "row", "column"),
    ("NN", "group", "cluster"),
    ("NN", "circle", "ring"),
    ("NN", "tower", "stack", "pile"),
    ("NN", "center", "middle", "centre"),
    ("VB", "take", "grab", "lift", "get", "select"),
    ("VB", "put", "place", "set", "move"),
    ("VB", "clear", "remove"),
    ("IN", "behind", "beside", "near"),
)
_CLASS_OF: Mapping[tuple[str, str], tuple[str, ...]] = {
    (words[0], word): words[1:] for words in _CLASSES for word in words[1:]
}


def vary(tree: Phrase, rng: np.random.Generator, share: float = 0.7) -> Phrase:
    """A variant of a gold tree.

    Args:
        tree: the gold tree.
        rng: the only source of chance.
        share: how likely each exchangeable word is exchanged.
    """
    varied = _exchange(tree, rng, share)
    return _reattached(varied) if rng.random() < 0.4 else varied


def _exchange(phrase: Phrase, rng: np.random.Generator, share: float) -> Phrase:
    children: list[Word | Phrase] = []
    for child in phrase.children:
        if isinstance(child, Phrase):
            children.append(_exchange(child, rng, share))
            continue
        words = _CLASS_OF.get((child.tag, child.text))
        if words is None or rng.random() > share or _fixed(phrase, child):
            children.append(child)
        else:
            children.append(Word(words[int(rng.integers(len(words)))], child.tag, child.index))
    return Phrase(phrase.tag, tuple(children))


def _fixed(phrase: Phrase, word: Word) -> bool:
    """Whether a word is part of a fixed expression: "take away", "in front of", "the two" of "between"."""
    if word.text == "take" and any(w.text == "away" for child in phrase.phrases for w in child.words):
        return True
    return word.tag == "CD" and phrase.tag == "NP" and len(phrase.words) == 2 and word.text == "two"


def _reattached(phrase: Phrase) -> Phrase:
    """Attach "on the right" to "five" instead of to "the row of five", wherever such phrases occur."""
    children = tuple(_reattached(c) if isinstance(c, Phrase) else c for c in phrase.children)
    phrase = Phrase(phrase.tag, children)
    if phrase.tag != "NP" or phrase.words or [c.tag for c in phrase.phrases] != ["NP", "PP"]:
        return phrase
    head, place = phrase.phrases
    if head.words or [c.tag for c in head.phrases] != ["NP", "PP"] or place.leaves[0].text not in ("on", "in", "at"):
        return phrase
    noun, of = head.phrases
    plain = len(of.phrases) == 1 and not of.phrases[0].phrases and of.phrases[0].tag == "NP"
    if [w.text for w in of.words] != ["of"] or not plain or not _many(of.phrases[0]):
        return phrase
    lower = Phrase("NP", (of.phrases[0], place))
    return Phrase("NP", (noun, Phrase("PP", (*of.words, lower))))


def _many(phrase: Phrase) -> bool:
    return any(word.tag in ("NNS", "CD") for word in phrase.words)
