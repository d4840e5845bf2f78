"""What is probable according to a grammar: the head of a phrase, each next child, the end of a side.

A symbol is a tag with a label: the head word that the phrase comes down to ("NN:block" for "the second red block",
"IN:of" for "of the row"), or only a class of words where that word is rare. Every choice depends on the phrase, its
label, the side and the child before, and backs off from the word to its class, to its tag, and to any word. Rules that
were never seen whole are therefore possible, at a price, and attachment depends on words: "put" wants a place, "front"
wants an "of".
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from grounding.language.estimates import BackOff
from grounding.language.events import OBJECT, ROOT, STOP, Child, label_class, split_label
from grounding.language.grammar import Grammar

START_TAGS = ("NP", "NPB", "S", "SQ", "VP")
_UNSEEN_START = 0.02
# Weight of the general against the specific context, chosen by parsing held-out parts of treebanks.
_HEAD_NOVELTY = 2.0
_TAG_NOVELTY = 0.5
_LABEL_NOVELTY = 3.0
_OBJECT_NOVELTY = 3.0

Context = tuple[str, ...]


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


class Probabilities:
    """The probabilities that a grammar's counts give; tables are filled when first needed."""

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar

    def head_probability(self, tag: str, label: str, child_tag: str) -> float:
        """P(head child | phrase)."""
        return self._heads.probability(_head_contexts(tag, label), child_tag)

    def child_probability(self, state: State, child: Symbol) -> float:
        """P(next child | phrase under construction); 0 where the phrase never has such a child on this side."""
        if state.tag == ROOT and child.tag not in START_TAGS:
            return 0.0
        takes_object = awaits_object(state, child.tag)
        outcome = "NP" if takes_object else child.tag
        chance = self._tags.probability(_tag_contexts(state), outcome, _UNSEEN_START if state.tag == ROOT else 0.0)
        if chance == 0.0:
            return 0.0
        if takes_object:
            return chance * self._objects.probability(_shape_contexts(state.label, child.label), child.tag, 0.5)
        return chance * self._label_probability(state, child)

    def _label_probability(self, state: State, child: Symbol) -> float:
        label, object_label = split_label(child.label)
        chance = self._labels.probability(
            _label_contexts(state, child.tag), label, self._base(Symbol(child.tag, label))
        )
        if object_label:
            contexts = _object_contexts(state, label)
            chance *= self._objects.probability(contexts, object_label, self._base(Symbol(OBJECT, object_label)))
        return chance

    def stop_probability(self, state: State) -> float:
        """P(no further child on this side | phrase under construction)."""
        return self._tags.probability(_tag_contexts(state), STOP)

    def share(self, symbol: Symbol) -> float:
        """How common a constituent is among all constituents with its kind of tag; for pruning."""
        label, object_label = split_label(symbol.label)
        chance = (
            self._labels.probability(((symbol.tag,),), label, self._base(Symbol(symbol.tag, label)))
            * self._tag_share[symbol.tag]
        )
        if object_label:
            chance *= self._objects.probability(((OBJECT,),), object_label, self._base(Symbol(OBJECT, object_label)))
        return chance

    def _base(self, symbol: Symbol) -> float:
        """P(label | tag) before labels are counted: the tag of the label's word, then that word or its being rare."""
        label_tag, _, word = symbol.label.partition(":")
        kinds = self._label_words.get(label_tag, 0)
        chance = self._label_tags.probability(((symbol.tag,),), label_tag, 1.0 / (1.0 + len(self._label_words)))
        if word and not word.startswith("~"):
            return chance / (1.0 + kinds)
        return chance * self._rare_share.get(label_tag, 1.0 / (1.0 + kinds))

    @cached_property
    def _tag_share(self) -> Mapping[str, float]:
        counts: Counter[str] = Counter()
        for event, count in self.grammar.heads.items():
            counts[event.tag] += count
        for row in self.grammar.words.counts.values():
            counts.update(row)
        most = max(counts.values(), default=1)
        tags = {*counts, *self.grammar.words.rare_mass}
        return {tag: (counts[tag] + 0.5) / (most + 0.5) for tag in sorted(tags)}

    @cached_property
    def _rare_share(self) -> Mapping[str, float]:
        """Tag -> which share of its words is rare."""
        counts: Counter[str] = Counter()
        for row in self.grammar.words.counts.values():
            counts.update(row)
        seen = self.grammar.words.words_seen
        return {tag: min(1.0, seen * mass / (counts[tag] + 1)) for tag, mass in self.grammar.words.rare_mass.items()}

    @cached_property
    def _label_words(self) -> Mapping[str, int]:
        """Tag -> how many labels have it."""
        labels = {part for event in self.grammar.children for part in split_label(event.child_label) if part}
        return Counter(label.partition(":")[0] for label in sorted(labels))

    @cached_property
    def _label_tags(self) -> BackOff:
        events = []
        for event, count in self.grammar.children.items():
            label, object_label = split_label(event.child_label)
            if label:
                events.append((((event.child_tag,),), label.partition(":")[0], count))
            if object_label:
                events.append((((OBJECT,),), object_label.partition(":")[0], count))
        return BackOff(events, _LABEL_NOVELTY)

    @cached_property
    def _heads(self) -> BackOff:
        return BackOff(
            (
                (_head_contexts(event.tag, event.label), event.child_tag, count)
                for event, count in self.grammar.heads.items()
            ),
            _HEAD_NOVELTY,
        )

    @cached_property
    def _tags(self) -> BackOff:
        return BackOff(
            (
                (_tag_contexts(_state(event)), "NP" if event.child_label.startswith(OBJECT) else event.child_tag, count)
                for event, count in self.grammar.children.items()
            ),
            _TAG_NOVELTY,
        )

    @cached_property
    def _labels(self) -> BackOff:
        events = (
            (_label_contexts(_state(event), event.child_tag), split_label(event.child_label)[0], float(count))
            for event, count in self.grammar.children.items()
            if event.child_tag != STOP and not event.child_label.startswith(OBJECT)
        )
        return BackOff(events, _LABEL_NOVELTY)

    @cached_property
    def _objects(self) -> BackOff:
        return BackOff(self._object_events(), _OBJECT_NOVELTY)

    def _object_events(self) -> Iterator[tuple[tuple[Context, ...], str, float]]:
        for event, count in self.grammar.children.items():
            label, object_label = split_label(event.child_label)
            if event.child_label.startswith(OBJECT):
                yield _shape_contexts(event.label, object_label), event.child_tag, float(count)
            elif object_label:
                yield _object_contexts(_state(event), label), object_label, float(count)


def awaits_object(state: State, child_tag: str) -> bool:
    """Whether a child becomes the object of a preposition."""
    return state.tag == "PP" and state.side == "R" and not state.object and child_tag in ("NP", "NPB")


def _state(event: Child) -> State:
    return State(event.tag, event.label, "", event.side, event.previous, False)


def _shape_contexts(label: str, object_label: str) -> tuple[Context, ...]:
    """Of an object's having phrases of its own."""
    return (
        ("shape",),
        ("shape", _kind(object_label)),
        ("shape", label_class(object_label)),
        ("shape", object_label),
        ("shape", label, label_class(object_label)),
        ("shape", label, object_label),
    )


def _object_contexts(state: State, label: str) -> tuple[Context, ...]:
    """Of which object a preposition has."""
    return (
        (OBJECT,),
        (OBJECT, label),
        (OBJECT, label, state.tag),
        (OBJECT, label, state.tag, label_class(state.label)),
        (OBJECT, label, state.tag, state.label),
    )


def _head_contexts(tag: str, label: str) -> tuple[Context, ...]:
    return ((tag,), (tag, _kind(label)), (tag, label_class(label)), (tag, label))


def _tag_contexts(state: State) -> tuple[Context, ...]:
    tag, label, _, side, previous, *_ = state
    return (
        (tag, side),
        (tag, side, previous),
        (tag, side, previous, _kind(label)),
        (tag, side, previous, label_class(label)),
        (tag, side, previous, label),
    )


def _label_contexts(state: State, child_tag: str) -> tuple[Context, ...]:
    tag, label, _, side, *_ = state
    return (
        (child_tag,),
        (child_tag, tag, side),
        (child_tag, tag, side, label_class(label)),
        (child_tag, tag, side, label),
    )


def _kind(label: str) -> str:
    """The tag of a label's word, marked as such."""
    return label.partition(":")[0] + ":*"
