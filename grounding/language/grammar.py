"""The grammar: how often which phrase has which children, counted in a treebank, and the probabilities that follow.

It is a weighted context-free grammar in the lexicalised, markovised form of Collins (2003). A symbol is a tag with a
label: the head word that the phrase comes down to ("NN:block" for "the second red block", "IN:of" for "of the row"), or
the head word's tag alone where the word is rare. A phrase makes its head child, then its children to the right of the
head, outwards, then those to the left; each child depends on the phrase, the label, the side and the child before it.
Rules that were never seen whole are therefore possible, at a price, and attachment depends on words: "put" wants a
place, "front" wants an "of".
"""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from grounding.errors import ModelError
from grounding.language.estimates import BackOff
from grounding.language.events import OBJECT, ROOT, STOP, Child, Head, label_of, split_label, tree_events
from grounding.language.tags import TagModel
from grounding.language.tree import Phrase

START_TAGS = ("NP", "NPB", "S", "SQ", "VP")
_HEAD_NOVELTY = 1.0
_TAG_NOVELTY = 1.0
_LABEL_NOVELTY = 1.0
_OBJECT_NOVELTY = 1.0
_FORMAT = "grounding grammar"
_VERSION = 1


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


@dataclass(frozen=True)
class Grammar:
    """Counts of a treebank. Values: nothing is precomputed until asked for.

    Attributes:
        words: tag counts of the words.
        heads: how often each head was seen.
        children: how often each child was seen.
    """

    words: TagModel
    heads: Mapping[Head, int]
    children: Mapping[Child, int]

    @classmethod
    def learn(cls, trees: Iterable[Phrase]) -> Grammar:
        """Count a treebank.

        Args:
            trees: phrase trees without punctuation; at least one for the grammar to be of any use.
        """
        treebank = tuple(trees)
        words = TagModel.learn(treebank)
        heads: Counter[Head] = Counter()
        children: Counter[Child] = Counter()
        for tree in treebank:
            for event in tree_events(tree, words):
                if isinstance(event, Head):
                    heads[event] += 1
                else:
                    children[event] += 1
        return cls(words, dict(sorted(heads.items())), dict(sorted(children.items())))

    def to_json(self) -> str:
        """The grammar as text: the same bytes for the same counts."""
        content = {
            "words": {word: dict(row) for word, row in self.words.counts.items()},
            "heads": [[*event, count] for event, count in self.heads.items()],
            "children": [[*event, count] for event, count in self.children.items()],
        }
        body = json.dumps(content, ensure_ascii=True, separators=(",", ":"))
        opening = {"format": _FORMAT, "version": _VERSION, "sha256": hashlib.sha256(body.encode()).hexdigest()}
        return json.dumps(opening)[:-1] + ',\n"content": ' + body.replace('],["', '],\n["') + "}\n"

    @classmethod
    def from_json(cls, text: str) -> Grammar:
        """Read what `to_json` wrote.

        Raises:
            ModelError: the text is damaged, or of another version.
        """
        try:
            document = json.loads(text)
        except ValueError as error:
            raise ModelError(f"the grammar is not JSON: {error}") from error
        if not isinstance(document, dict) or document.get("format") != _FORMAT:
            raise ModelError(f"expected a grammar with format {_FORMAT!r} and found something else")
        if document.get("version") != _VERSION:
            raise ModelError(f"expected a grammar of version {_VERSION} and found {document.get('version')!r}")
        body = json.dumps(document.get("content"), ensure_ascii=True, separators=(",", ":"))
        if hashlib.sha256(body.encode()).hexdigest() != document.get("sha256"):
            raise ModelError("the grammar is damaged: its checksum does not fit its content")
        try:
            content = document["content"]
            return cls(
                TagModel(
                    {str(word): {str(tag): int(n) for tag, n in row.items()} for word, row in content["words"].items()}
                ),
                {Head(*event): int(count) for *event, count in content["heads"]},
                {Child(*event): int(count) for *event, count in content["children"]},
            )
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise ModelError(f"the grammar's content is not as expected: {error!r}") from error

    @classmethod
    def read(cls, path: Path) -> Grammar:
        """Read a grammar file.

        Raises:
            ModelError: the file is missing, damaged, or of another version; names the file.
        """
        try:
            return cls.from_json(path.read_text(encoding="utf-8"))
        except OSError as error:
            raise ModelError(f"the grammar {path} cannot be read: {error.strerror}") from error
        except (ModelError, UnicodeDecodeError) as error:
            raise ModelError(f"the grammar {path} cannot be used: {error}") from error

    @cached_property
    def phrase_tags(self) -> tuple[str, ...]:
        """The phrase types, in alphabetical order."""
        return tuple(sorted({event.tag for event in self.heads}))

    @cached_property
    def sides(self) -> Mapping[tuple[str, str], frozenset[str]]:
        """(phrase tag, side) -> the tags of the children seen there; only sides that have any."""
        table: dict[tuple[str, str], set[str]] = {}
        for event in self.children:
            if event.child_tag != STOP:
                table.setdefault((event.tag, event.side), set()).add(event.child_tag)
        return {key: frozenset(tags) for key, tags in table.items()}

    @cached_property
    def mothers(self) -> Mapping[str, tuple[str, ...]]:
        """Child tag -> the phrase tags that it can be the head of."""
        table: dict[str, set[str]] = {}
        for event in self.heads:
            table.setdefault(event.child_tag, set()).add(event.tag)
        return {tag: tuple(sorted(table[tag])) for tag in sorted(table)}

    @cached_property
    def chains(self) -> frozenset[tuple[str, str]]:
        """(phrase tag, tag of its only child, a phrase), without circles."""
        counts: Counter[tuple[str, str]] = Counter()
        for event, count in self.heads.items():
            if event.only and event.tag != event.child_tag:
                counts[event.tag, event.child_tag] += count
        kept: set[tuple[str, str]] = set()
        for (upper, lower), _ in sorted(counts.items(), key=lambda item: (-item[1], item[0])):
            if not _reaches(kept, lower, upper):
                kept.add((upper, lower))
        return frozenset(kept)

    def label(self, word: str, tag: str) -> str:
        """The label of a word with a tag."""
        return label_of(word, tag, self.words)

    def head_probability(self, tag: str, label: str, child_tag: str) -> float:
        """P(head child | phrase)."""
        return self._heads.probability(_head_contexts(tag, label), child_tag)

    def child_probability(self, state: State, child: Symbol) -> float:
        """P(next child | phrase under construction); 0 where the phrase never has such a child on this side."""
        if state.tag == ROOT and child.tag not in START_TAGS:
            return 0.0
        takes_object = awaits_object(state, child.tag)
        outcome = "NP" if takes_object else child.tag
        chance = self._tags.probability(_tag_contexts(state), outcome, 0.02 if state.tag == ROOT else 0.0)
        if chance == 0.0:
            return 0.0
        if takes_object:
            return chance * self._objects.probability(_shape_contexts(state.label, child.label), child.tag, 0.5)
        return chance * self._label_probability(state, child)

    def _label_probability(self, state: State, child: Symbol) -> float:
        label, object_label = split_label(child.label)
        chance = self._labels.probability(_label_contexts(state, child.tag), label, self._base(child))
        if object_label:
            contexts = _object_contexts(state, label)
            chance *= self._objects.probability(contexts, object_label, self._base(Symbol(OBJECT, "")))
        return chance

    def stop_probability(self, state: State) -> float:
        """P(no further child on this side | phrase under construction)."""
        return self._tags.probability(_tag_contexts(state), STOP)

    def share(self, symbol: Symbol) -> float:
        """How common a constituent is among all constituents with its kind of tag; for pruning."""
        label, object_label = split_label(symbol.label)
        chance = self._labels.probability(((symbol.tag,),), label, self._base(symbol)) * self._tag_share[symbol.tag]
        if object_label:
            chance *= self._objects.probability(((OBJECT,),), object_label, self._base(Symbol(OBJECT, "")))
        return chance

    def _base(self, symbol: Symbol) -> float:
        return 1.0 / (1.0 + self._label_kinds.get(symbol.tag, 0))

    @cached_property
    def _tag_share(self) -> Mapping[str, float]:
        counts: Counter[str] = Counter()
        for event, count in self.heads.items():
            counts[event.tag] += count
        for row in self.words.counts.values():
            counts.update(row)
        most = max(counts.values(), default=1)
        tags = {*counts, *self.words.rare_mass}
        return {tag: (counts[tag] + 0.5) / (most + 0.5) for tag in sorted(tags)}

    @cached_property
    def _label_kinds(self) -> Mapping[str, int]:
        kinds = set()
        for event in self.children:
            label, object_label = split_label(event.child_label)
            kinds.add((event.child_tag, label))
            kinds.add((OBJECT, object_label))
        return Counter(tag for tag, _ in sorted(kinds))

    @cached_property
    def _heads(self) -> BackOff:
        return BackOff(
            ((_head_contexts(event.tag, event.label), event.child_tag, count) for event, count in self.heads.items()),
            _HEAD_NOVELTY,
        )

    @cached_property
    def _tags(self) -> BackOff:
        return BackOff(
            (
                (_tag_contexts(_state(event)), "NP" if event.child_label.startswith(OBJECT) else event.child_tag, count)
                for event, count in self.children.items()
            ),
            _TAG_NOVELTY,
        )

    @cached_property
    def _labels(self) -> BackOff:
        events = (
            (_label_contexts(_state(event), event.child_tag), split_label(event.child_label)[0], float(count))
            for event, count in self.children.items()
            if event.child_tag != STOP and not event.child_label.startswith(OBJECT)
        )
        return BackOff(events, _LABEL_NOVELTY)

    @cached_property
    def _objects(self) -> BackOff:
        return BackOff(self._object_events(), _OBJECT_NOVELTY)

    def _object_events(self) -> Iterator[tuple[tuple[tuple[str, ...], ...], str, float]]:
        for event, count in self.children.items():
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


def _shape_contexts(label: str, object_label: str) -> tuple[tuple[str, ...], ...]:
    """Of an object's having phrases of its own."""
    return (("shape",), ("shape", _kind(object_label)), ("shape", object_label), ("shape", label, object_label))


def _object_contexts(state: State, label: str) -> tuple[tuple[str, ...], ...]:
    """Of which object a preposition has."""
    return ((OBJECT,), (OBJECT, label), (OBJECT, label, state.tag), (OBJECT, label, state.tag, state.label))


def _head_contexts(tag: str, label: str) -> tuple[tuple[str, ...], ...]:
    return ((tag,), (tag, _kind(label)), (tag, label))


def _tag_contexts(state: State) -> tuple[tuple[str, ...], ...]:
    tag, label, _, side, previous, *_ = state
    return ((tag, side), (tag, side, previous), (tag, side, previous, _kind(label)), (tag, side, previous, label))


def _label_contexts(state: State, child_tag: str) -> tuple[tuple[str, ...], ...]:
    tag, label, _, side, *_ = state
    return ((child_tag,), (child_tag, tag, side), (child_tag, tag, side, label))


def _kind(label: str) -> str:
    """The tag of a label's word, marked as such."""
    return label.partition(":")[0] + ":*"


def _reaches(chains: set[tuple[str, str]], start: str, goal: str) -> bool:
    return start == goal or any(_reaches(chains, lower, goal) for upper, lower in sorted(chains) if upper == start)
