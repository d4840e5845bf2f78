"""The grammar's rules as a chart parser wants them: small integers, looked up by the symbols being joined.

Nothing is expanded in advance: a rule is worked out from the grammar's probabilities the first time a chart asks for it, and kept.
"""

from __future__ import annotations

from math import log

from grounding.language.grammar import ROOT, Grammar, State, Symbol

Target = tuple[int, float]
"""A state or symbol by number, and the log probability of the step to it."""

_NEVER: Target | None = None


class Rules:
    """Numbered symbols and states of one grammar, and the steps between them.

    A symbol starts a state as its head (`starts`); the state takes symbols to the right (`take`), closes its right side (`close`), takes
    symbols to the left (`take` again) and becomes a symbol (`close` again).
    """

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar
        self.symbols: list[Symbol] = []
        self.states: list[State] = []
        self.symbol_rank: list[float] = []
        """Log of how common each symbol is: for pruning."""
        self.state_rank: list[float] = []
        """The same for the symbol that each state is to become."""
        self.takes: list[dict[int, Target | None]] = []
        """For each state, the steps worked out so far: symbol -> state after it."""
        self.root = State(ROOT, "", "R", "^", False)
        self._symbol_numbers: dict[Symbol, int] = {}
        self._state_numbers: dict[State, int] = {}
        self._starts: dict[int, tuple[Target, ...]] = {}
        self._closes: dict[int, Target | None] = {}
        self._tops: dict[int, float | None] = {}

    def symbol(self, symbol: Symbol) -> int:
        """The number of a symbol."""
        number = self._symbol_numbers.get(symbol)
        if number is None:
            number = self._symbol_numbers[symbol] = len(self.symbols)
            self.symbols.append(symbol)
            self.symbol_rank.append(log(self.grammar.share(symbol)))
        return number

    def state(self, state: State) -> int:
        """The number of a state."""
        number = self._state_numbers.get(state)
        if number is None:
            number = self._state_numbers[state] = len(self.states)
            self.states.append(state)
            self.state_rank.append(log(self.grammar.share(Symbol(state.tag, state.label))))
            self.takes.append({})
        return number

    def starts(self, symbol: int) -> tuple[Target, ...]:
        """The states of which a symbol can be the head."""
        steps = self._starts.get(symbol)
        if steps is None:
            steps = self._starts[symbol] = tuple(self._starts_of(self.symbols[symbol]))
        return steps

    def take(self, state: int, symbol: int) -> Target | None:
        """The state after one more child, or None where the grammar has no such child there."""
        steps = self.takes[state]
        if symbol not in steps:
            steps[symbol] = self._take(self.states[state], self.symbols[symbol])
        return steps[symbol]

    def close(self, state: int) -> Target | None:
        """What a state becomes when its side is complete: a left-sided state (right sides) or a symbol (left sides)."""
        if state not in self._closes:
            self._closes[state] = self._close(self.states[state])
        return self._closes[state]

    def top(self, symbol: int) -> float | None:
        """Log probability of a whole sentence being this symbol; None where it cannot be."""
        if symbol not in self._tops:
            chance = self.grammar.child_probability(self.root, self.symbols[symbol])
            self._tops[symbol] = log(chance) if chance else None
        return self._tops[symbol]

    def _starts_of(self, symbol: Symbol) -> list[Target]:
        steps = []
        is_phrase = symbol.tag in self.grammar.phrase_tags
        for tag in self.grammar.mothers.get(symbol.tag, ()):
            chance = self.grammar.head_probability(tag, symbol.label, symbol.tag)
            if chance:
                steps.append((self.state(State(tag, symbol.label, "R", "^" + symbol.tag, is_phrase)), log(chance)))
        return steps

    def _take(self, state: State, symbol: Symbol) -> Target | None:
        chance = self.grammar.child_probability(state, symbol)
        if not chance:
            return None
        return self.state(state._replace(previous=symbol.tag, bare=False)), log(chance)

    def _close(self, state: State) -> Target | None:
        chance = self.grammar.stop_probability(state)
        if not chance:
            return None
        if state.side == "L":
            if state.bare and (state.tag, state.previous[1:]) not in self.grammar.chains:
                return None
            return self.symbol(Symbol(state.tag, state.label)), log(chance)
        return self.state(state._replace(side="L", previous=self._head_of(state))), log(chance)
