"""The grammar: how often which phrase has which children, counted in a treebank, and the probabilities that follow.

It is a weighted context-free grammar in the lexicalised, markovised form of Collins (2003). A symbol is a tag with a label: the head
word that the phrase comes down to ("NN:block" for "the second red block", "IN:of" for "of the row"), or the head word's tag alone where
the word is rare. A phrase makes its head child, then its children to the right of the head, outwards, then those to the left; each
child depends on the phrase, the label, the side and the child before it. Rules that were never seen whole are therefore possible, at a
price, and attachment depends on words: "put" wants a place, "front" wants an "of".
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from grounding.language.estimates import BackOff
from grounding.language.heads import head_index, refined_tag
from grounding.language.tags import RARE, TagModel
from grounding.language.tree import Phrase, Word

ROOT = "ROOT"
STOP = ""
START_TAGS = ("NP", "NPB", "S", "SQ", "VP")
_NOVELTY = 1.0


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
    side: str
    """"R" while it takes children to the right of what it has, then "L"."""
    previous: str
    """The tag of the child before on this side, or "^" and the tag of the head."""
    bare: bool
    """Whether it has no child but the head so far, and that is a phrase."""


class Child(NamedTuple):
    """A counted event: a phrase got this child."""

    tag: str
    label: str
    side: str
    previous: str
    child_tag: str
    """The child's tag, or `STOP` when the side was complete."""
    child_label: str


class Head(NamedTuple):
    """A counted event: a phrase got this head child."""

    tag: str
    label: str
    child_tag: str
    only: int
    """1 where the head stayed the only child and is a phrase, else 0."""


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
            top, label = refined_tag(tree), _label(tree, words)
            children[Child(ROOT, "", "R", "^", top, label)] += 1
            for phrase in tree.preorder():
                for event in _events(phrase, words):
                    if isinstance(event, Head):
                        heads[event] += 1
                    else:
                        children[event] += 1
        return cls(words, dict(sorted(heads.items())), dict(sorted(children.items())))

    @cached_property
    def phrase_tags(self) -> tuple[str, ...]:
        """The phrase types, in alphabetical order."""
        return tuple(sorted({event.tag for event in self.heads}))

    @cached_property
    def sides(self) -> frozenset[tuple[str, str]]:
        """(phrase tag, side) of every side on which some phrase has children."""
        return frozenset((event.tag, event.side) for event in self.children if event.child_tag != STOP)

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
        return f"{tag}:" if self.words.is_rare(word, tag) else f"{tag}:{word}"

    def head_probability(self, tag: str, label: str, child_tag: str) -> float:
        """P(head child | phrase)."""
        return self._heads.probability(_head_contexts(tag, label), child_tag)

    def child_probability(self, state: State, child: Symbol) -> float:
        """P(next child | phrase under construction); 0 where the phrase never has such a child on this side."""
        if state.tag == ROOT and child.tag not in START_TAGS:
            return 0.0
        chance = self._tags.probability(_tag_contexts(state), child.tag, 0.02 if state.tag == ROOT else 0.0)
        if chance == 0.0:
            return 0.0
        return chance * self._labels.probability(_label_contexts(state, child.tag), child.label, self._base(child))

    def stop_probability(self, state: State) -> float:
        """P(no further child on this side | phrase under construction)."""
        return self._tags.probability(_tag_contexts(state), STOP)

    def share(self, symbol: Symbol) -> float:
        """How common a constituent is among all constituents with its kind of tag; for pruning."""
        return self._labels.probability(((symbol.tag,),), symbol.label, self._base(symbol)) * self._tag_share[symbol.tag]

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
        kinds = {(event.child_tag, event.child_label) for event in self.children}
        return Counter(tag for tag, _ in sorted(kinds))

    @cached_property
    def _heads(self) -> BackOff:
        return BackOff(
            ((_head_contexts(event.tag, event.label), event.child_tag, count) for event, count in self.heads.items()),
            _NOVELTY,
        )

    @cached_property
    def _tags(self) -> BackOff:
        return BackOff(
            ((_tag_contexts(_state(event)), event.child_tag, count) for event, count in self.children.items()), _NOVELTY
        )

    @cached_property
    def _labels(self) -> BackOff:
        events = (
            (_label_contexts(_state(event), event.child_tag), event.child_label, float(count))
            for event, count in self.children.items()
            if event.child_tag != STOP
        )
        return BackOff(events, _NOVELTY)


def _state(event: Child) -> State:
    return State(event.tag, event.label, event.side, event.previous, False)


def _head_contexts(tag: str, label: str) -> tuple[tuple[str, ...], ...]:
    return ((tag,), (tag, _kind(label)), (tag, label))


def _tag_contexts(state: State) -> tuple[tuple[str, ...], ...]:
    tag, label, side, previous, _ = state
    return ((tag, side), (tag, side, previous), (tag, side, previous, _kind(label)), (tag, side, previous, label))


def _label_contexts(state: State, child_tag: str) -> tuple[tuple[str, ...], ...]:
    tag, label, side, _, _ = state
    return ((child_tag,), (child_tag, tag, side), (child_tag, tag, side, label))


def _kind(label: str) -> str:
    """The tag of a label's word, marked as such."""
    return label.partition(":")[0] + ":*"


def _label(node: Phrase | Word, words: TagModel) -> str:
    while isinstance(node, Phrase):
        node = node.children[head_index(node.tag, node.children)]
    return f"{node.tag}:" if words.is_rare(node.text, node.tag) else f"{node.tag}:{node.text}"


def _refined(node: Phrase | Word) -> str:
    return refined_tag(node) if isinstance(node, Phrase) else node.tag


def _events(phrase: Phrase, words: TagModel) -> Iterator[Head | Child]:
    tag, label, index = refined_tag(phrase), _label(phrase, words), head_index(phrase.tag, phrase.children)
    head = phrase.children[index]
    only = len(phrase.children) == 1 and isinstance(head, Phrase)
    yield Head(tag, label, _refined(head), int(only))
    for side, outwards in (("R", phrase.children[index + 1 :]), ("L", phrase.children[:index][::-1])):
        previous = "^" + _refined(head)
        for child in outwards:
            yield Child(tag, label, side, previous, _refined(child), _label(child, words))
            previous = _refined(child)
        yield Child(tag, label, side, previous, STOP, "")


def _reaches(chains: set[tuple[str, str]], start: str, goal: str) -> bool:
    return start == goal or any(_reaches(chains, lower, goal) for upper, lower in sorted(chains) if upper == start)
