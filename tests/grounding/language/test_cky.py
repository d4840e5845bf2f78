"""CKY against an enumeration that knows neither charts nor cells."""

from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from small_treebank import TREES, VOCABULARY

from grounding.language.cky import FRAGMENT, Beam, Cover, Lexeme, parse_forest
from grounding.language.contexts import Symbol
from grounding.language.events import label_of
from grounding.language.forest import Node
from grounding.language.grammar import Grammar
from grounding.language.rules import Rules
from grounding.language.tree import Phrase, Word

GRAMMAR = Grammar.learn(TREES)
RULES = Rules(GRAMMAR)
EVERYTHING = Beam(width=1e9, size=10**6)
sentences = st.lists(st.sampled_from(VOCABULARY), min_size=1, max_size=4)


def lexemes(words: list[str]) -> list[list[Lexeme]]:
    tags = GRAMMAR.words.counts
    return [
        [Lexeme(Word(word, tag, index), label_of(word, tag, GRAMMAR.words), -0.1 * len(tag)) for tag in tags[word]]
        for index, word in enumerate(words)
    ]


def enumerate_all(sentence: list[list[Lexeme]]) -> list[float]:
    """Log probabilities of all derivations of the whole sentence, by recursion over spans."""

    @cache
    def whole(start: int, end: int, symbol: int) -> tuple[float, ...]:
        found = []
        if end - start == 1:
            for reading in sentence[start]:
                if RULES.symbol(Symbol(reading.word.tag, reading.label)) == symbol:
                    found.append(reading.log_probability)
        for state in range(len(RULES.states)):
            closed = RULES.close(state).symbol
            if closed is not None and closed[0] == symbol:
                side = RULES.states[state].side
                if side == "R" or not RULES.states[state].previous.startswith("^"):
                    found.extend(closed[1] + value for value in part(start, end, state))
        return tuple(found)

    @cache
    def part(start: int, end: int, state: int) -> tuple[float, ...]:
        found = []
        for symbol in range(len(RULES.symbols)):
            for begin in RULES.starts(symbol):
                if begin.state == state:
                    found.extend(begin.log_probability + value for value in whole(start, end, symbol))
        for earlier in range(len(RULES.states)):
            closed = RULES.close(earlier)
            if closed.state is not None and closed.state[0] == state:
                found.extend(closed.state[1] + value for value in part(start, end, earlier))
            for symbol, step in list(RULES.takes[earlier].items()):
                if step is None or step[0] != state:
                    continue
                for middle in range(start + 1, end):
                    if RULES.states[earlier].side == "R":
                        before, after = part(start, middle, earlier), whole(middle, end, symbol)
                    else:
                        before, after = whole(start, middle, symbol), part(middle, end, earlier)
                    found.extend(step[1] + a + b for a in before for b in after)
        return tuple(found)

    values = []
    for symbol in range(len(RULES.symbols)):
        weight = RULES.top(symbol)
        if weight is not None:
            values.extend(weight + value for value in whole(0, len(sentence), symbol))
    return sorted(values, reverse=True)


def derivations(root: Node, most: int) -> list[float]:
    found = []
    for rank in range(most):
        value = root.derivation(rank)
        if value is None:
            break
        found.append(value)
    return found


@settings(max_examples=40, deadline=None)
@given(sentences)
def test_without_a_beam_the_chart_has_every_derivation_and_no_other(words: list[str]) -> None:
    sentence = lexemes(words)
    root, complete = parse_forest(RULES, sentence, EVERYTHING, Cover())
    expected = enumerate_all(sentence)
    assert complete == bool(expected)
    if complete:
        assert derivations(root, 50) == pytest.approx(expected[:50])


@settings(deadline=None)
@given(st.lists(st.sampled_from(VOCABULARY), min_size=1, max_size=12))
def test_every_tree_has_exactly_the_words(words: list[str]) -> None:
    root, complete = parse_forest(RULES, lexemes(words), Beam(), Cover())
    scores = derivations(root, 6)
    assert scores == sorted(scores, reverse=True)
    for rank in range(len(scores)):
        (tree,) = root.children(rank)
        assert isinstance(tree, Phrase)
        assert [leaf.text for leaf in tree.leaves] == words
        assert [leaf.index for leaf in tree.leaves] == list(range(len(words)))
        assert complete == (tree.tag != FRAGMENT)


@settings(deadline=None)
@given(st.lists(st.sampled_from(VOCABULARY), min_size=2, max_size=10))
def test_a_beam_finds_nothing_better_than_no_beam(words: list[str]) -> None:
    narrow, narrow_complete = parse_forest(RULES, lexemes(words), Beam(width=3.0, size=3), Cover())
    wide, wide_complete = parse_forest(RULES, lexemes(words), EVERYTHING, Cover())
    assert wide_complete or not narrow_complete
    if narrow_complete == wide_complete:
        assert narrow.score <= wide.score + 1e-9


def test_no_constituent_is_longer_than_the_span() -> None:
    words = "take the red block in the row".split()
    root, complete = parse_forest(RULES, lexemes(words), Beam(span=3), Cover())
    assert not complete
    (tree,) = root.children(0)
    assert all(len(phrase.leaves) <= 3 for phrase in tree.preorder() if phrase.tag != FRAGMENT)
