"""Trees as people in a hurry would have said them: without articles."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from grounding.language.lexicon import is_colour
from grounding.language.tree import Phrase, Word
from grounding.lexicon.words import is_block

_ARTICLES = frozenset("the a an".split())
_EVERY = 4
"""One tree in so many is learned from in both ways."""


def with_terse(trees: Iterable[Phrase]) -> Iterator[Phrase]:
    """Trees, and of some of them, after all, what is left without articles.

    Args:
        trees: phrase trees without punctuation.
    """
    seen = []
    for place, tree in enumerate(trees):
        yield tree
        if place % _EVERY == 0:
            seen.append(tree)
    for place, tree in enumerate(seen):
        short = terse(tree, bare=place % 2 == 1)
        if len(short.leaves) < len(tree.leaves):
            yield short


def terse(tree: Phrase, *, bare: bool = False) -> Phrase:
    """A tree without the articles of noun phrases that have a noun or a number of their own, or a phrase.

    Args:
        tree: a phrase tree.
        bare: whether what has a colour is called by that alone: "take yellow next to the tower".
    """
    return _renumbered(_shortened(tree, bare=bare), iter(range(len(tree.leaves))))


def _shortened(phrase: Phrase, *, bare: bool) -> Phrase:
    children = tuple(_shortened(child, bare=bare) if isinstance(child, Phrase) else child for child in phrase.children)
    if phrase.tag == "NP":
        words = [child for child in children if isinstance(child, Word)]
        if bare and len(words) > 1 and len(words) == len(children) and _is_coloured_thing(words):
            return Phrase("NP", tuple(word for word in words[:-1] if word.tag != "DT"))
        kept = tuple(c for c in children if isinstance(c, Phrase) or c.tag != "DT" or c.text not in _ARTICLES)
        if any(isinstance(child, Phrase) or child.tag[:2] in ("NN", "CD") for child in kept):
            children = kept
    return Phrase(phrase.tag, children)


def _is_coloured_thing(words: list[Word]) -> bool:
    """Whether a noun phrase ends in a colour and a word for a thing."""
    colour, noun = words[-2], words[-1]
    return noun.tag == "NN" and is_block(noun.text) and is_colour(colour.text)


def _renumbered(phrase: Phrase, numbers: Iterator[int]) -> Phrase:
    return Phrase(phrase.tag, tuple(
        _renumbered(child, numbers) if isinstance(child, Phrase) else Word(child.text, child.tag, next(numbers))
        for child in phrase.children
    ))  # fmt: skip
