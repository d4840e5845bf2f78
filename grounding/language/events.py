"""What a grammar counts in a tree: which phrase has which head, and which children on each side of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from grounding.language.classes import word_class
from grounding.language.heads import head_index, refined_tag
from grounding.language.tags import TagModel
from grounding.language.tree import Phrase, Word

ROOT = "ROOT"
STOP = ""
OBJECT = ">"


class Child(NamedTuple):
    """A counted event: a phrase got this child."""

    tag: str
    label: str
    side: str
    previous: str
    child_tag: str
    """The child's tag, or `STOP` when the side was complete."""
    child_label: str
    """The child's label; with `OBJECT` before it for the object of a preposition, which the phrase's label tells."""


class Head(NamedTuple):
    """A counted event: a phrase got this head child."""

    tag: str
    label: str
    child_tag: str
    only: int
    """1 where the head stayed the only child and is a phrase, else 0."""


def label_of(word: str, tag: str, words: TagModel) -> str:
    """The label of a word with a tag: "NN:block"; for a rare word its class, "NN:~Container", or "NN:" without one."""
    if not words.is_rare(word, tag):
        return f"{tag}:{word}"
    name = word_class(word)
    return f"{tag}:~{name}" if name else f"{tag}:"


def label_class(label: str) -> str:
    """The tag and the class of a label's word: "NN:*ObjectType"."""
    tag, _, word = label.partition(":")
    return f"{tag}:*{word[1:] if word.startswith('~') else word_class(word)}"


def join_label(label: str, object_label: str) -> str:
    """The label of a prepositional phrase as its parent sees it, with its object: "IN:in>NN:row"."""
    return f"{label}{OBJECT}{object_label}" if object_label else label


def split_label(label: str) -> tuple[str, str]:
    """The two parts of such a label; the second is "" for labels without object."""
    first, _, second = label.partition(OBJECT)
    return first, second


def tree_events(tree: Phrase, words: TagModel) -> Iterator[Head | Child]:
    """All events of a tree, its being a whole sentence included."""
    yield Child(ROOT, "", "R", "^", refined_tag(tree), _outer_label(tree, words))
    for phrase in tree.preorder():
        yield from _phrase_events(phrase, words)


def _label(node: Phrase | Word, words: TagModel) -> str:
    while isinstance(node, Phrase):
        node = node.children[head_index(node.tag, node.children)]
    return label_of(node.text, node.tag, words)


def _refined(node: Phrase | Word) -> str:
    return refined_tag(node) if isinstance(node, Phrase) else node.tag


def _outer_label(node: Phrase | Word, words: TagModel) -> str:
    """A node's label as its parent sees it."""
    label = _label(node, words)
    if isinstance(node, Phrase) and node.tag == "PP":
        rest = node.children[head_index("PP", node.children) + 1 :]
        objects = [child for child in rest if child.tag == "NP"]
        return join_label(label, _label(objects[0], words) if objects else "")
    return label


def _phrase_events(phrase: Phrase, words: TagModel) -> Iterator[Head | Child]:
    tag, label, index = refined_tag(phrase), _label(phrase, words), head_index(phrase.tag, phrase.children)
    head = phrase.children[index]
    only = len(phrase.children) == 1 and isinstance(head, Phrase)
    yield Head(tag, label, _refined(head), int(only))
    awaits_object = tag == "PP"
    for side, outwards in (("R", phrase.children[index + 1 :]), ("L", phrase.children[:index][::-1])):
        previous = "^" + _refined(head)
        for child in outwards:
            child_label = _outer_label(child, words)
            if awaits_object and side == "R" and child.tag == "NP":
                child_label, awaits_object = OBJECT + child_label, False
            yield Child(tag, label, side, previous, _refined(child), child_label)
            previous = _refined(child)
        yield Child(tag, label, side, previous, STOP, "")
