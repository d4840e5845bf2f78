"""What a grammar's choices depend on: symbols, phrases under construction, and the contexts that follow from them.

A context is a text, its parts separated by `SEPARATOR`, which no word has. Contexts come in chains, from the most
general to the most specific: from the phrase alone to its word's tag, the word's class and the word itself.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from grounding.language.events import OBJECT, Child, label_class, split_label

SEPARATOR = "\t"
SHAPE = "shape"
"""Marks contexts of an object's having phrases of its own."""

Contexts = tuple[str, ...]


class Symbol(NamedTuple):
    """A constituent of the grammar."""

    tag: str
    """Phrase type or Penn tag; noun phrases without phrases of their own have one to themselves."""
    label: str
    """Tag and text of the head word, "NN:block", or "NN:" for any rare word."""


class State(NamedTuple):
    """A phrase under construction, from its head outwards."""

    tag: str
    """The phrase's tag."""
    label: str
    """The phrase's label."""
    head: str
    """The tag of its head child."""
    side: str
    """"R" while it takes children to the right of what it has, then "L"."""
    previous: str
    """The tag of the child before on this side, or "^" and the tag of the head."""
    bare: bool
    """Whether it has no child but the head so far, and that is a phrase."""
    object: str = ""
    """The label of a preposition's object, once it is there."""

    @classmethod
    def start(cls, tag: str, head: Symbol, is_phrase: bool) -> State:
        """The state of a phrase that has its head only."""
        return cls(tag, split_label(head.label)[0], head.tag, "R", "^" + head.tag, is_phrase)


def awaits_object(state: State, child_tag: str) -> bool:
    """Whether a child becomes the object of a preposition."""
    return state.tag == "PP" and state.side == "R" and not state.object and child_tag in ("NP", "NPB")


def of_event(event: Child) -> State:
    """The state in which a phrase got a child that was counted."""
    return State(event.tag, event.label, "", event.side, event.previous, False)


def shape_contexts(label: str, object_label: str) -> Contexts:
    """Of an object's having phrases of its own."""
    kind, group = _general(object_label)
    return (
        SHAPE,
        f"{SHAPE}\t{kind}",
        f"{SHAPE}\t{group}",
        f"{SHAPE}\t{object_label}",
        f"{SHAPE}\t{label}\t{group}",
        f"{SHAPE}\t{label}\t{object_label}",
    )


def object_contexts(state: State, label: str) -> Contexts:
    """Of which object a preposition has."""
    start = f"{OBJECT}\t{label}"
    return (
        OBJECT,
        start,
        f"{start}\t{state.tag}",
        f"{start}\t{state.tag}\t{_general(state.label)[1]}",
        f"{start}\t{state.tag}\t{state.label}",
    )


def head_contexts(tag: str, label: str) -> Contexts:
    """Of which child is a phrase's head."""
    kind, group = _general(label)
    return tag, f"{tag}\t{kind}", f"{tag}\t{group}", f"{tag}\t{label}"


def tag_contexts(state: State) -> Contexts:
    """Of the next child's tag, or of there being none."""
    side = f"{state.tag}\t{state.side}"
    start = f"{side}\t{state.previous}"
    kind, group = _general(state.label)
    return side, start, f"{start}\t{kind}", f"{start}\t{group}", f"{start}\t{state.label}"


def label_contexts(state: State, child_tag: str) -> Contexts:
    """Of the next child's label."""
    start = f"{child_tag}\t{state.tag}\t{state.side}"
    return child_tag, start, f"{start}\t{_general(state.label)[1]}", f"{start}\t{state.label}"


@lru_cache(maxsize=4096)
def _general(label: str) -> tuple[str, str]:
    """The tag of a label's word, marked as such, and its class."""
    return label.partition(":")[0] + ":*", label_class(label)
