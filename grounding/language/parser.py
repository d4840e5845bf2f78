"""From text to its best parses: tokens, tags, chart, trees."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass
from math import exp
from pathlib import Path
from typing import Any

import models
from grounding.errors import LanguageError
from grounding.language.cky import FRAGMENT, Beam, Cover, Lexeme, parse_forest
from grounding.language.compiled import read_grammar
from grounding.language.events import label_of
from grounding.language.fillers import without_fillers
from grounding.language.forest import Node
from grounding.language.grammar import Grammar
from grounding.language.kindred import kindred
from grounding.language.lexicon import known_words, meanings
from grounding.language.possessives import unfold
from grounding.language.repairs import without_slips
from grounding.language.rewriting import rewrite
from grounding.language.rules import Rules
from grounding.language.sentences import part_commands
from grounding.language.skipping import restore
from grounding.language.spelling import Speller
from grounding.language.tokens import Token, normal, tokenize
from grounding.language.tree import Phrase, Word

_TAG_BEAM = 4.0
"""Tags less likely for a word than its best by more than this, as log probability, are not tried."""
_DERIVATIONS = 6
"""Look at up to so many derivations for every tree wanted: some differ in the words' tags only."""

_MOST_KEPT = 4096
_MOST_SKIPPED = 3
"""So many words of a sentence that does not parse whole are tried to be left out, one at a time."""
_SKIPPED = -12.0
"""Log probability of a word that has no place in its sentence."""
_LEXICON = known_words()

_WORKING_OUT = threading.RLock()
"""Parsing works out more of the rules as it goes, for all threads; it is done by one of them at a time."""

Choice = tuple[str, str, str, float]
"""A word as it may be read, its tag, its label, and log P(word | tag, label)."""

Shape = tuple[Any, ...]


@dataclass(frozen=True)
class Parse:
    """One reading of a text.

    Attributes:
        tree: the phrase tree, without punctuation; a phrase 'FRAG' over the pieces where the grammar does not cover the
            text, and over the sentences where there are several. A word that had to be skipped has the tag 'X'. What
            belongs to something stands before it, see `grounding.language.possessives`.
        log_probability: of the tree with its words.
        probability: among the readings returned with this one; they sum to 1.
        unknown_words: words that neither the grammar's treebank nor the lexicon has, in order; mended ones not.
        complete: whether the grammar covers every sentence of the text.
        mended: words that were read as others, in order: (as written, as read). The tree has them as read.
    """

    tree: Phrase
    log_probability: float
    probability: float
    unknown_words: tuple[str, ...]
    complete: bool
    mended: tuple[tuple[str, str], ...] = ()


class Parser:
    """Parses with one grammar; keeps what it has worked out about the rules."""

    def __init__(self, grammar: Grammar, *, beam: Beam | None = None, cover: Cover | None = None) -> None:
        """Parse with a grammar.

        Args:
            grammar: learned from at least one tree.
            beam: how much of the chart is kept.
            cover: weights for texts that do not parse whole.

        Raises:
            LanguageError: the grammar is empty.
        """
        if not grammar.heads:
            raise LanguageError("expected a grammar learned from at least one tree and found an empty one")
        self.grammar = grammar
        self._beam = beam or Beam()
        self._cover = cover or Cover()
        self._rules = Rules(grammar)
        self._choices: dict[str, tuple[Choice, ...]] = {}
        self._speller = Speller((*grammar.words.counts, *_LEXICON))

    @classmethod
    def load(cls, path: Path = models.GRAMMAR) -> Parser:
        """Read the shipped grammar, or another.

        Raises:
            ModelError: the file is missing, damaged or of another version.
        """
        return cls(read_grammar(path))

    def parse(self, text: str, k: int = 4) -> tuple[Parse, ...]:
        """Parse a text.

        Args:
            text: one or several sentences.
            k: how many readings are wanted, at least 1.

        Returns:
            one to k readings that differ in their phrases, best first.

        Raises:
            LanguageError: there is no word in the text.
        """
        if k < 1:
            raise LanguageError(f"expected at least one reading to be asked for and found k={k}")
        with _WORKING_OUT:
            return self._parsed(text, k)

    def _parsed(self, text: str, k: int) -> tuple[Parse, ...]:
        said = without_slips(without_fillers(tokenize(text)))
        sentences = part_commands(rewrite(said, self._is_known), self._is_verb)
        if not sentences:
            raise LanguageError(f"expected an instruction and found a text without words: {text[:40]!r}")
        roots, whole, count = [], True, 0
        skipped: list[Word] = []
        for sentence in sentences:
            lexemes = [self._readings(token.text, count + index) for index, token in enumerate(sentence)]
            count += len(sentence)
            root, complete = parse_forest(self._rules, lexemes, self._beam, self._cover)
            if not complete:
                root, left_out = self._without_a_word(lexemes, root)
                skipped += left_out
            roots.append(root)
            whole &= complete
        trees = [(restore(tree, skipped), score) for tree, score in _best_trees(_join(roots), k)]
        tokens = [token for sentence in sentences for token in sentence]
        total = sum(exp(score - trees[0][1]) for _, score in trees)
        return tuple(
            Parse(unfold(tree), score, exp(score - trees[0][1]) / total, self._unknown(tree), whole,
                  _mended(tokens, tree))
            for tree, score in trees
        )

    def _without_a_word(self, lexemes: list[list[Lexeme]], root: Node) -> tuple[Node, list[Word]]:
        """The sentence without the word that keeps it from parsing whole, and that word; the pieces where none does."""
        (pieces,) = root.children(0)
        assert isinstance(pieces, Phrase)
        found: tuple[Node, list[Word]] = (root, [])
        for word in pieces.words[:_MOST_SKIPPED]:
            rest = [readings for readings in lexemes if readings[0].word.index != word.index]
            if rest:
                other, complete = parse_forest(self._rules, rest, self._beam, self._cover)
                if complete and other.score + _SKIPPED > found[0].score:
                    found = (Node(other.score + _SKIPPED, [(_SKIPPED, other, None)]), [word])
        return found

    def _is_verb(self, word: str) -> bool:
        """Whether a word is mostly a verb, in the treebank or as its kin is."""
        counts = self.grammar.words.counts.get(word) or self.grammar.words.counts.get(kindred(word) or "", {})
        return 2 * sum(n for tag, n in counts.items() if tag.startswith("VB")) > sum(counts.values())

    def _is_known(self, word: str) -> bool:
        known = self.grammar.words.is_known(word) or word in _LEXICON or bool(meanings(word))
        return known or kindred(word) is not None

    def _unknown(self, tree: Phrase) -> tuple[str, ...]:
        return tuple(leaf.text for leaf in tree.leaves if not self._is_known(leaf.text))

    def _readings(self, word: str, index: int) -> list[Lexeme]:
        choices = self._choices.get(word)
        if choices is None:
            choices = self._choices_of(word)
            verb = None if self.grammar.words.is_known(word) else kindred(word)
            if verb is not None and self.grammar.words.is_known(verb):
                choices += tuple((word, tag, label, chance) for _, tag, label, chance in self._choices_of(verb))
            elif not self._is_known(word):
                for spelling in self._speller.candidates(word):
                    choices += tuple(
                        (as_read, tag, label, chance + spelling.log_probability)
                        for as_read, tag, label, chance in self._choices_of(spelling.word)
                    )
            if len(self._choices) < _MOST_KEPT:
                self._choices[word] = choices
        return [Lexeme(Word(as_read, tag, index), label, chance) for as_read, tag, label, chance in choices]

    def _choices_of(self, word: str) -> tuple[Choice, ...]:
        """The tags worth trying for a word."""
        model = self.grammar.words
        chances = model.log_probabilities(word)
        limit = max(chances.values()) - _TAG_BEAM
        choices = []
        for tag, chance in chances.items():
            if chance >= limit:
                emission = model.log_emission(word, tag, chance) if model.is_rare(word, tag) else 0.0
                choices.append((word, tag, label_of(word, tag, model), emission))
        return tuple(choices)


def _mended(tokens: Sequence[Token], tree: Phrase) -> tuple[tuple[str, str], ...]:
    """What was read as something else than its letters."""
    return tuple(
        (token.original, leaf.text)
        for token, leaf in zip(tokens, tree.leaves, strict=True)
        if _bare(token.original) != _bare(leaf.text)
    )


def _bare(text: str) -> str:
    """The letters and digits of a text."""
    return "".join(filter(str.isalnum, normal(text)))


def _join(roots: list[Node]) -> Node:
    """One root over the sentences."""
    if len(roots) == 1:
        return roots[0]
    joined = roots[0]
    for root in roots[1:]:
        joined = Node(joined.score + root.score, [(0.0, joined, root)])
    return Node(joined.score, [(0.0, joined, None)], FRAGMENT)


def _best_trees(root: Node, k: int) -> list[tuple[Phrase, float]]:
    """The best trees that differ in their phrases, each with its best tags of words."""
    trees: dict[Shape, tuple[Phrase, float]] = {}
    for rank in range(_DERIVATIONS * k):
        score = root.derivation(rank)
        if score is None or len(trees) == k:
            break
        (tree,) = root.children(rank)
        assert isinstance(tree, Phrase)
        flat = _flat(tree)
        trees.setdefault(_shape(flat), (flat, score))
    return list(trees.values())


def _shape(tree: Phrase) -> Shape:
    """A tree without its words' tags."""
    return (tree.tag, *(child.index if isinstance(child, Word) else _shape(child) for child in tree.children))


def _flat(tree: Phrase) -> Phrase:
    """The tree with the pieces of pieces directly below the root."""
    if tree.tag != FRAGMENT or not any(child.tag == FRAGMENT for child in tree.phrases):
        return tree
    children: list[Phrase | Word] = []
    for child in tree.children:
        children.extend(child.children if isinstance(child, Phrase) and child.tag == FRAGMENT else [child])
    return Phrase(FRAGMENT, tuple(children))
