"""Words that found no place in their sentence are put back into its tree where they stood, tagged as such."""

from __future__ import annotations

from collections.abc import Iterable

from grounding.language.tree import Phrase, Word

SKIPPED = "X"


def restore(tree: Phrase, words: Iterable[Word]) -> Phrase:
    """A tree with words that were left out of it.

    Args:
        tree: over the other words, which keep their places in the sentence.
        words: each becomes a word of the smallest phrase around its place.
    """
    for word in words:
        tree = _insert(tree, Word(word.text, SKIPPED, word.index))
    return tree


def _insert(phrase: Phrase, word: Word) -> Phrase:
    children: list[Word | Phrase] = []
    placed = False
    for child in phrase.children:
        first, last = (child.index, child.index) if isinstance(child, Word) else _span(child)
        if not placed and word.index < last:
            placed = True
            if isinstance(child, Phrase) and first < word.index:
                children.append(_insert(child, word))
                continue
            children.append(word)
        children.append(child)
    return Phrase(phrase.tag, tuple(children if placed else [*children, word]))


def _span(phrase: Phrase) -> tuple[int, int]:
    return phrase.leaves[0].index, phrase.leaves[-1].index
