"""What is probable according to a grammar: the head of a phrase, each next child, the end of a side.

A symbol is a tag with a label: the head word that the phrase comes down to ("NN:block" for "the second red block",
"IN:of" for "of the row"), or only a class of words where that word is rare. Every choice depends on the phrase, its
label, the side and the child before, and backs off from the word to its class, to its tag, and to any word. Rules that
were never seen whole are therefore possible, at a price, and attachment depends on words: "put" wants a place, "front"
wants an "of".
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Mapping
from functools import cached_property

from grounding.language.contexts import (
    State,
    Symbol,
    awaits_object,
    head_contexts,
    label_contexts,
    object_contexts,
    shape_contexts,
    tag_contexts,
)
from grounding.language.estimates import Chain
from grounding.language.events import OBJECT, ROOT, STOP, split_label
from grounding.language.grammar import Grammar

START_TAGS = ("NP", "NPB", "S", "SQ", "VP")
_UNSEEN_START = 0.02


class Probabilities:
    """The probabilities that a grammar's counts give; what was worked out of contexts is kept."""

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar
        self._tables = grammar.tables
        self._tag_chains: dict[Hashable, Chain] = {}
        self._label_chains: dict[Hashable, Chain] = {}
        self._bases: dict[Symbol, float] = {}

    def head_probability(self, tag: str, label: str, child_tag: str) -> float:
        """P(head child | phrase)."""
        return self._tables.heads.probability(head_contexts(tag, label), child_tag)

    def child_probability(self, state: State, child: Symbol) -> float:
        """P(next child | phrase under construction); 0 where the phrase never has such a child on this side."""
        if state.tag == ROOT and child.tag not in START_TAGS:
            return 0.0
        takes_object = awaits_object(state, child.tag)
        outcome = "NP" if takes_object else child.tag
        chance = self._tags_of(state).probability(outcome, _UNSEEN_START if state.tag == ROOT else 0.0)
        if chance == 0.0:
            return 0.0
        if takes_object:
            contexts = shape_contexts(state.label, child.label)
            return chance * self._tables.objects.probability(contexts, child.tag, 0.5)
        return chance * self._label_probability(state, child)

    def _label_probability(self, state: State, child: Symbol) -> float:
        label, object_label = split_label(child.label)
        chance = self._labels_of(state, child.tag).probability(label, self._base(Symbol(child.tag, label)))
        if object_label:
            contexts = object_contexts(state, label)
            base = self._base(Symbol(OBJECT, object_label))
            chance *= self._tables.objects.probability(contexts, object_label, base)
        return chance

    def stop_probability(self, state: State) -> float:
        """P(no further child on this side | phrase under construction)."""
        return self._tags_of(state).probability(STOP)

    def share(self, symbol: Symbol) -> float:
        """How common a constituent is among all constituents with its kind of tag; for pruning."""
        label, object_label = split_label(symbol.label)
        chance = (
            self._tables.labels.probability((symbol.tag,), label, self._base(Symbol(symbol.tag, label)))
            * self._tag_share[symbol.tag]
        )
        if object_label:
            base = self._base(Symbol(OBJECT, object_label))
            chance *= self._tables.objects.probability((OBJECT,), object_label, base)
        return chance

    def _tags_of(self, state: State) -> Chain:
        key = (state.tag, state.label, state.side, state.previous)
        chain = self._tag_chains.get(key)
        if chain is None:
            chain = self._tag_chains[key] = self._tables.tags.chain(tag_contexts(state))
        return chain

    def _labels_of(self, state: State, child_tag: str) -> Chain:
        key = (state.tag, state.label, state.side, child_tag)
        chain = self._label_chains.get(key)
        if chain is None:
            chain = self._label_chains[key] = self._tables.labels.chain(label_contexts(state, child_tag))
        return chain

    def _base(self, symbol: Symbol) -> float:
        """P(label | tag) before labels are counted: the tag of the label's word, then that word or its being rare."""
        if symbol not in self._bases:
            label_tag, _, word = symbol.label.partition(":")
            kinds = self._tables.label_words.get(label_tag, 0)
            unseen = 1.0 / (1.0 + len(self._tables.label_words))
            chance = self._tables.label_tags.probability((symbol.tag,), label_tag, unseen)
            if word and not word.startswith("~"):
                self._bases[symbol] = chance / (1.0 + kinds)
            else:
                self._bases[symbol] = chance * self._rare_share.get(label_tag, 1.0 / (1.0 + kinds))
        return self._bases[symbol]

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
