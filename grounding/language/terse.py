"""Trees as people in a hurry would have said them: without articles."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from grounding.language.tree import Phrase, Word

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
    for tree in seen:
        short = terse(tree)
        if len(short.leaves) < len(tree.leaves):
            yield short


def terse(tree: Phrase) -> Phrase:
    """A tree without the articles of noun phrases that have a noun or a number of their own, or a phrase."""
    return _renumbered(_shortened(tree), iter(range(len(tree.leaves))))


def _shortened(phrase: Phrase) -> Phrase:
    children = tuple(_shortened(child) if isinstance(child, Phrase) else child for child in phrase.children)
    if phrase.tag == "NP":
        kept = tuple(c for c in children if isinstance(c, Phrase) or c.tag != "DT" or c.text not in _ARTICLES)
        if any(isinstance(child, Phrase) or child.tag[:2] in ("NN", "CD") for child in kept):
            children = kept
    return Phrase(phrase.tag, children)


def _renumbered(phrase: Phrase, numbers: Iterator[int]) -> Phrase:
    return Phrase(phrase.tag, tuple(
        _renumbered(child, numbers) if isinstance(child, Phrase) else Word(child.text, child.tag, next(numbers))
        for child in phrase.children
    ))  # fmt: skip
