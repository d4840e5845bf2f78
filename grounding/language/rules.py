"""The grammar's rules as a chart parser wants them: small integers, looked up by the symbols being joined.

Nothing is expanded in advance: a rule is worked out from the grammar's probabilities the first time a chart asks for
it, and kept.
"""

from __future__ import annotations

from math import log
from typing import NamedTuple

from grounding.language.contexts import State, Symbol, awaits_object
from grounding.language.events import ROOT, join_label, split_label
from grounding.language.grammar import Grammar
from grounding.language.heads import plain_tag
from grounding.language.probabilities import Probabilities

Step = tuple[int, float]
"""A state or symbol by number, and the log probability of getting there."""


class Start(NamedTuple):
    """A state that a symbol can be the head of."""

    state: int
    log_probability: float
    grows: bool
    """Whether it can take children to the right."""


class Close(NamedTuple):
    """What a state can become without further children on its side."""

    symbol: Step | None
    """The complete phrase, both sides closed."""
    state: Step | None
    """The state that takes children to the left, of a state whose right side closes."""
    wanted: frozenset[str]
    """The tags of these children."""


class Rules:
    """Numbered symbols and states of one grammar, and the steps between them."""

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar
        self._probabilities = Probabilities(grammar)
        self.symbols: list[Symbol] = []
        self.states: list[State] = []
        self.symbol_rank: list[float] = []
        """Log of how common each symbol is: for pruning."""
        self.state_rank: list[float] = []
        """The same for the symbol that each state is to become."""
        self.depth: list[int] = []
        """For each symbol, how long a chain of only children can be below it; 0 for words."""
        self.plain_tags: list[str] = []
        """For each symbol, its tag in the tree."""
        self.takes: list[dict[int, Step | None]] = []
        """For each state, the steps worked out so far: symbol -> state after it."""
        self._symbol_numbers: dict[Symbol, int] = {}
        self._state_numbers: dict[State, int] = {}
        self._starts: dict[int, tuple[Start, ...]] = {}
        self._closes: dict[int, Close] = {}
        self._tops: dict[int, float | None] = {}
        self._root = State(ROOT, "", "", "R", "^", False)
        self._depths = _depths(grammar)

    def symbol(self, symbol: Symbol) -> int:
        """The number of a symbol."""
        number = self._symbol_numbers.get(symbol)
        if number is None:
            number = self._symbol_numbers[symbol] = len(self.symbols)
            self.symbols.append(symbol)
            self.plain_tags.append(plain_tag(symbol.tag))
            self.symbol_rank.append(log(self._probabilities.share(symbol)))
            self.depth.append(self._depths.get(symbol.tag, 0))
        return number

    def starts(self, symbol: int) -> tuple[Start, ...]:
        """The states of which a symbol can be the head."""
        steps = self._starts.get(symbol)
        if steps is None:
            steps = self._starts[symbol] = tuple(self._find_starts(self.symbols[symbol]))
        return steps

    def take(self, state: int, symbol: int) -> Step | None:
        """The state after one more child, or None where the grammar has no such child there; kept in `takes`."""
        before, child = self.states[state], self.symbols[symbol]
        chance = self._probabilities.child_probability(before, child)
        told = child.label if awaits_object(before, child.tag) else before.object
        after = before._replace(previous=child.tag, bare=False, object=told)
        step = (self._state(after), log(chance)) if chance else None
        self.takes[state][symbol] = step
        return step

    def close(self, state: int) -> Close:
        """What a state can become when it takes no more children on its side."""
        close = self._closes.get(state)
        if close is None:
            close = self._closes[state] = self._find_close(self.states[state])
        return close

    def top(self, symbol: int) -> float | None:
        """Log probability of a whole sentence being this symbol; None where it cannot be."""
        if symbol not in self._tops:
            chance = self._probabilities.child_probability(self._root, self.symbols[symbol])
            self._tops[symbol] = log(chance) if chance else None
        return self._tops[symbol]

    def _state(self, state: State) -> int:
        number = self._state_numbers.get(state)
        if number is None:
            number = self._state_numbers[state] = len(self.states)
            self.states.append(state)
            self.state_rank.append(log(self._probabilities.share(Symbol(state.tag, state.label))))
            self.takes.append({})
        return number

    def _find_starts(self, head: Symbol) -> list[Start]:
        steps = []
        is_phrase = head.tag in self.grammar.phrase_tags
        for tag in self.grammar.mothers.get(head.tag, ()):
            chance = self._probabilities.head_probability(tag, split_label(head.label)[0], head.tag)
            if chance:
                state = self._state(State.start(tag, head, is_phrase))
                steps.append(Start(state, log(chance), (tag, "R") in self.grammar.tables.sides))
        return steps

    def _find_close(self, state: State) -> Close:
        chance = self._probabilities.stop_probability(state)
        if not chance:
            return Close(None, None, frozenset())
        whole = not state.bare or (state.tag, state.head) in self.grammar.chains
        symbol = self.symbol(Symbol(state.tag, join_label(state.label, state.object))) if whole else -1
        if state.side == "L":
            return Close((symbol, log(chance)) if whole else None, None, frozenset())
        after = state._replace(side="L", previous="^" + state.head)
        wanted = self.grammar.tables.sides.get((state.tag, "L"), frozenset())
        final = self._probabilities.stop_probability(after)
        return Close(
            (symbol, log(chance * final)) if whole and final else None,
            (self._state(after), log(chance)) if wanted else None,
            wanted,
        )


def _depths(grammar: Grammar) -> dict[str, int]:
    depths: dict[str, int] = {}

    def depth(tag: str) -> int:
        if tag not in depths:
            depths[tag] = 1 + max((depth(lower) for upper, lower in grammar.chains if upper == tag), default=0)
        return depths[tag]

    for tag in grammar.phrase_tags:
        depth(tag)
    return depths
