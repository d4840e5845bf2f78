"""The tables of a grammar: its counts by the contexts that choices depend on."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from grounding.language.contexts import (
    Contexts,
    head_contexts,
    label_contexts,
    object_contexts,
    of_event,
    shape_contexts,
    tag_contexts,
)
from grounding.language.estimates import BackOff
from grounding.language.events import OBJECT, STOP, Child, Head, split_label

NOVELTIES: Mapping[str, float] = {"heads": 2.0, "tags": 0.5, "labels": 3.0, "objects": 3.0, "label_tags": 3.0}
"""Weights of the general against the specific context, chosen by parsing held-out parts of treebanks."""


@dataclass(frozen=True, eq=False)
class Tables:
    """What was seen in which context.

    Attributes:
        heads: of heads, in `head_contexts`.
        tags: of the tags of children, or of their being complete, in `tag_contexts`.
        labels: of the labels of children, in `label_contexts`.
        objects: of the labels of prepositions' objects, in `object_contexts`, and of their tags, in `shape_contexts`.
        label_tags: of the tags in labels, by the tag of the child or `OBJECT`.
        label_words: tag -> how many labels have it.
        sides: (phrase tag, side) -> the tags of the children seen there; only sides that have any.
    """

    heads: BackOff
    tags: BackOff
    labels: BackOff
    objects: BackOff
    label_tags: BackOff
    label_words: Mapping[str, int]
    sides: Mapping[tuple[str, str], frozenset[str]]

    @classmethod
    def count(cls, heads: Mapping[Head, int], children: Mapping[Child, int]) -> Tables:
        """Count events."""
        labels = sorted({part for event in children for part in split_label(event.child_label) if part})
        events = {
            "heads": ((head_contexts(event.tag, event.label), event.child_tag, n) for event, n in heads.items()),
            "tags": ((tag_contexts(of_event(event)), _tag(event), n) for event, n in children.items()),
            "labels": _label_events(children),
            "objects": _object_events(children),
            "label_tags": _label_tag_events(children),
        }
        return cls(
            **{name: BackOff.count(events[name], novelty) for name, novelty in NOVELTIES.items()},
            label_words=Counter(label.partition(":")[0] for label in labels),
            sides=_sides(children),
        )


_Events = Iterator[tuple[Contexts, str, float]]


def _tag(event: Child) -> str:
    return "NP" if event.child_label.startswith(OBJECT) else event.child_tag


def _label_events(children: Mapping[Child, int]) -> _Events:
    for event, count in children.items():
        if event.child_tag != STOP and not event.child_label.startswith(OBJECT):
            yield label_contexts(of_event(event), event.child_tag), split_label(event.child_label)[0], count


def _object_events(children: Mapping[Child, int]) -> _Events:
    for event, count in children.items():
        label, object_label = split_label(event.child_label)
        if event.child_label.startswith(OBJECT):
            yield shape_contexts(event.label, object_label), event.child_tag, count
        elif object_label:
            yield object_contexts(of_event(event), label), object_label, count


def _label_tag_events(children: Mapping[Child, int]) -> _Events:
    for event, count in children.items():
        label, object_label = split_label(event.child_label)
        if label:
            yield (event.child_tag,), label.partition(":")[0], count
        if object_label:
            yield (OBJECT,), object_label.partition(":")[0], count


def _sides(children: Iterable[Child]) -> dict[tuple[str, str], frozenset[str]]:
    table: dict[tuple[str, str], set[str]] = {}
    for event in children:
        if event.child_tag != STOP:
            table.setdefault((event.tag, event.side), set()).add(event.child_tag)
    return {key: frozenset(tags) for key, tags in table.items()}
