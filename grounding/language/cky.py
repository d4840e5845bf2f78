"""Weighted CKY over the markovised grammar: from tagged words to a packed forest.

Phrases grow from their heads, to the right, then to the left, one child at a time, so that every rule joins two
neighbours. Each cell of the chart keeps unfinished phrases open to the right, unfinished phrases open to the left, and
constituents; those far worse than the best in their cell are dropped.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from grounding.language.contexts import Symbol
from grounding.language.forest import Edge, Node
from grounding.language.pruning import Beam, Table, prune
from grounding.language.rules import Rules
from grounding.language.tree import Word

FRAGMENT = "FRAG"


@dataclass(frozen=True)
class Lexeme:
    """A word with one of its tags.

    Attributes:
        word: the leaf.
        label: the word's label in the grammar.
        log_probability: log P(word | tag, label).
    """

    word: Word
    label: str
    log_probability: float


@dataclass(frozen=True)
class Cover:
    """Log probabilities, beside a constituent's own, of its being one piece of a text that does not parse whole.

    Attributes:
        phrase: of a phrase.
        word: of a single word.
    """

    phrase: float = -8.0
    word: float = -14.0


def parse_forest(rules: Rules, sentence: Sequence[Sequence[Lexeme]], beam: Beam, cover: Cover) -> tuple[Node, bool]:
    """Parse one sentence.

    Args:
        rules: of the grammar.
        sentence: at least one word; for each, at least one reading.
        beam: how much to keep.
        cover: weights for sentences that do not parse whole.

    Returns:
        the root, and whether the grammar covers the sentence; where it does not, all roots are phrases `FRAGMENT` over
        the best pieces.
    """
    chart = _fill(rules, sentence, beam)
    size = len(sentence)
    edges: list[Edge] = []
    for symbol, node in chart[0][size].items():
        weight = rules.top(symbol)
        if weight is not None:
            edges.append((weight, node, None))
    if edges:
        return Node(max(weight + node.score for weight, node, _ in edges), edges), True
    return _cover(rules, chart, size, cover), False


def _fill(rules: Rules, sentence: Sequence[Sequence[Lexeme]], beam: Beam) -> list[list[Table]]:
    """All constituents, by first word and by the word after the last."""
    size = len(sentence)
    words = [{reading.word.text for reading in readings} for readings in sentence]
    begins, ends = rules.grammar.boundaries.openings(words, rules.grammar.words)
    complete: list[list[Table]] = [[{} for _ in range(size + 1)] for _ in range(size + 1)]
    # Unfinished phrases: those open to the right by first word, those open to the left (for one end) by start.
    rightwards: list[list[tuple[int, Table]]] = [[] for _ in range(size)]
    tags_before: frozenset[str] = frozenset()
    ending: list[frozenset[str]] = [tags_before]
    for end in range(1, size + 1):
        leftwards: list[tuple[int, Table]] = []
        for start in range(end - 1, max(-1, end - 1 - beam.span), -1):
            whole = complete[start][end]
            right: Table = {}
            left: Table = {}
            if end - start == 1:
                for reading in sentence[start]:
                    symbol = rules.symbol(Symbol(reading.word.tag, reading.label))
                    whole[symbol] = Node(reading.log_probability, [], reading.word)
            else:
                # Where no phrase ends, only the last word can be added.
                _extend_right(rules, rightwards[start][0 if ends[end - 1] else -1 :], complete, end, right)
                if ends[end - 1]:
                    _extend_left(rules, complete[start], leftwards, left)
                if not right and not left:
                    continue
                prune(right, rules.state_rank, beam)
                if ends[end - 1]:
                    prune(left, rules.state_rank, beam)
                    for state, node in [*right.items(), *left.items()]:
                        _close(rules, state, node, whole, left, ending[start])
                    if not begins[start]:
                        whole.clear()
                    prune(whole, rules.symbol_rank, beam)
            if whole:
                _start(rules, whole, right, left, ending[start])
                prune(whole, rules.symbol_rank, beam, beam.slack)
            prune(right, rules.state_rank, beam, beam.slack)
            prune(left, rules.state_rank, beam, beam.slack)
            if right and end < size:
                rightwards[start].append((end, right))
            if left:
                leftwards.append((start, left))
        ending.append(frozenset(rules.symbols[symbol].tag for row in complete for symbol in row[end]))
    return complete


def _extend_right(
    rules: Rules, unfinished: list[tuple[int, Table]], complete: list[list[Table]], end: int, target: Table
) -> None:
    """Add the constituents that reach to `end` to the unfinished phrases of one start."""
    takes, take = rules.takes, rules.take
    for middle, states in unfinished:
        symbols = complete[middle][end]
        if not symbols:
            continue
        for state, node in states.items():
            steps = takes[state]
            for symbol, child in symbols.items():
                step = steps[symbol] if symbol in steps else take(state, symbol)
                if step is not None:
                    number, weight = step
                    score = weight + node.score + child.score
                    found = target.get(number)
                    if found is None:
                        target[number] = Node(score, [(weight, node, child)])
                    else:
                        found.edges.append((weight, node, child))
                        if score > found.score:
                            found.score = score


def _extend_left(rules: Rules, row: list[Table], unfinished: list[tuple[int, Table]], target: Table) -> None:
    """Add the constituents of one start to the unfinished phrases of one end."""
    takes, take = rules.takes, rules.take
    for middle, states in unfinished:
        symbols = row[middle]
        if not symbols:
            continue
        for state, node in states.items():
            steps = takes[state]
            for symbol, child in symbols.items():
                step = steps[symbol] if symbol in steps else take(state, symbol)
                if step is not None:
                    _add(target, step[0], step[1], child, node)


def _add(table: Table, number: int, weight: float, first: Node, second: Node) -> None:
    score = weight + first.score + second.score
    node = table.get(number)
    if node is None:
        table[number] = Node(score, [(weight, first, second)])
    else:
        node.edges.append((weight, first, second))
        if score > node.score:
            node.score = score


def _close(rules: Rules, state: int, node: Node, whole: Table, left: Table, before: frozenset[str]) -> None:
    """Close a side of an unfinished phrase; where it is the right one, go on to the left if a child can be there."""
    closed = rules.close(state)
    if closed.symbol is not None:
        number, weight = closed.symbol
        score = weight + node.score
        found = whole.get(number)
        if found is None:
            whole[number] = Node(score, [(weight, node, None)], rules.plain_tags[number])
        else:
            found.edges.append((weight, node, None))
            if score > found.score:
                found.score = score
    if closed.state is not None and not closed.wanted.isdisjoint(before):
        number, weight = closed.state
        score = weight + node.score
        found = left.get(number)
        if found is None:
            left[number] = Node(score, [(weight, node, None)])
        else:
            found.edges.append((weight, node, None))
            if score > found.score:
                found.score = score


def _start(rules: Rules, whole: Table, right: Table, left: Table, before: frozenset[str]) -> None:
    """Make every constituent of a cell the head of what it can be, constituents that this makes included."""
    depth = rules.depth
    pending = sorted(whole, key=depth.__getitem__)
    while pending:
        symbol = pending.pop(0)
        node = whole[symbol]
        known = len(whole)
        for state, weight, grows in rules.starts(symbol):
            part = Node(weight + node.score, [(weight, node, None)])
            if grows:
                right[state] = part
            _close(rules, state, part, whole, left, before)
        if len(whole) > known:
            pending = sorted({*pending, *list(whole)[known:]}, key=lambda number: (depth[number], number))


def _cover(rules: Rules, chart: list[list[Table]], size: int, cover: Cover) -> Node:
    """The best ways of covering a sentence by pieces."""
    covers: list[Node | None] = [None] * (size + 1)
    for end in range(1, size + 1):
        edges: list[Edge] = []
        for start in range(end):
            before = covers[start]
            for symbol, node in chart[start][end].items():
                weight = rules.symbol_rank[symbol] + (cover.phrase if rules.depth[symbol] else cover.word)
                if before is not None:
                    edges.append((weight, before, node))
                elif start == 0:
                    edges.append((weight, node, None))
        best = max(weight + one.score + (two.score if two else 0.0) for weight, one, two in edges)
        covers[end] = Node(best, edges)
    last = covers[size]
    assert last is not None
    return Node(last.score, [(0.0, last, None)], FRAGMENT)
