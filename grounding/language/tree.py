"""Phrase trees: words with Penn tags as leaves, phrases (NP, PP, VP, PRT, ...) as inner nodes; their bracketed form.

The bracketed form is that of the Penn treebank, with an optional annotation in braces after a phrase's tag::

    (NP {container(row)} (DT the) (NN row))
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

from grounding.errors import TreeError

_LEXEME = re.compile(r"\s*(\(|\)|\{[^{}]*\}|[^\s(){}]+)")


@dataclass(frozen=True)
class Word:
    """A leaf.

    Attributes:
        text: the word as it is compared: lower case, mended where it was misspelt.
        tag: its Penn part-of-speech tag.
        index: its position in the sentence, from 0.
    """

    text: str
    tag: str
    index: int


@dataclass(frozen=True)
class Phrase:
    """An inner node λ of the parse tree.

    Attributes:
        tag: the phrase type (NP, PP, VP, PRT, ...).
        children: words and phrases, in the order of the sentence.
    """

    tag: str
    children: tuple[Word | Phrase, ...]

    @cached_property
    def words(self) -> tuple[Word, ...]:
        """The words directly below this phrase, not those of its child phrases."""
        return tuple(child for child in self.children if isinstance(child, Word))

    @cached_property
    def phrases(self) -> tuple[Phrase, ...]:
        """The child phrases, whose groundings are the context of this one."""
        return tuple(child for child in self.children if isinstance(child, Phrase))

    @cached_property
    def leaves(self) -> tuple[Word, ...]:
        """All words below this phrase, in the order of the sentence."""
        return tuple(
            leaf for child in self.children for leaf in ((child,) if isinstance(child, Word) else child.leaves)
        )

    @cached_property
    def text(self) -> str:
        """The words below this phrase, joined by blanks."""
        return " ".join(leaf.text for leaf in self.leaves)

    @cached_property
    def span(self) -> tuple[int, int]:
        """The places in the sentence of the first and the last word below this phrase."""
        places = [leaf.index for leaf in self.leaves]
        return min(places), max(places)

    def preorder(self) -> Iterator[Phrase]:
        """This phrase, then everything below it, parents before children."""
        yield self
        for child in self.phrases:
            yield from child.preorder()

    def postorder(self) -> Iterator[Phrase]:
        """Everything below this phrase, children before parents, this phrase last: the order of inference."""
        for child in self.phrases:
            yield from child.postorder()
        yield self

    def __str__(self) -> str:
        return to_brackets(self)


def to_brackets(phrase: Phrase, annotate: Callable[[Phrase], str] | None = None) -> str:
    """Write a tree on one line.

    Args:
        phrase: the root.
        annotate: gives the text to put in braces after a phrase's tag; "" for none.
    """
    parts = [phrase.tag]
    if annotate is not None and (note := annotate(phrase)):
        parts.append("{" + note + "}")
    for child in phrase.children:
        parts.append(f"({child.tag} {child.text})" if isinstance(child, Word) else to_brackets(child, annotate))
    return f"({' '.join(parts)})"


def from_brackets(text: str) -> tuple[Phrase, tuple[str, ...]]:
    """Read a bracketed tree.

    Args:
        text: the tree, on one line or several.

    Returns:
        the root and, for every phrase in preorder, the text in its braces ("" where there is none).

    Raises:
        TreeError: unbalanced brackets, a phrase without children, a leaf without word, or text after the tree.
    """
    lexemes = _lex(text)
    notes: list[str] = []
    position, count = 0, 0

    def take(expected: str | None = None) -> str:
        nonlocal position
        if position == len(lexemes):
            raise TreeError(f"tree ends too early: {text.strip()!r}")
        lexeme = lexemes[position]
        if expected is not None and lexeme != expected:
            raise TreeError(f"expected {expected!r} and found {lexeme!r} in tree {text.strip()!r}")
        position += 1
        return lexeme

    def node() -> Word | Phrase:
        nonlocal count
        take("(")
        tag = take()
        if tag[0] in "(){":
            raise TreeError(f"expected a tag and found {tag!r} in tree {text.strip()!r}")
        if position < len(lexemes) and lexemes[position][0] not in "(){":
            word = Word(take(), tag, count)
            count += 1
            take(")")
            return word
        slot = len(notes)
        notes.append("")
        if position < len(lexemes) and lexemes[position][0] == "{":
            notes[slot] = take()[1:-1].strip()
        children = []
        while position < len(lexemes) and lexemes[position] == "(":
            children.append(node())
        take(")")
        if not children:
            raise TreeError(f"phrase {tag!r} has no children in tree {text.strip()!r}")
        return Phrase(tag, tuple(children))

    root = node()
    if position != len(lexemes):
        raise TreeError(f"text after the tree: {' '.join(lexemes[position:])!r}")
    if isinstance(root, Word):
        raise TreeError(f"a tree is a phrase, not a single word: {text.strip()!r}")
    return root, tuple(notes)


def _lex(text: str) -> list[str]:
    lexemes, position = [], 0
    stripped = text.rstrip()
    while position < len(stripped):
        match = _LEXEME.match(stripped, position)
        if match is None:
            raise TreeError(f"unreadable from {stripped[position : position + 20]!r} in tree {text.strip()!r}")
        lexemes.append(match.group(1))
        position = match.end()
    return lexemes
