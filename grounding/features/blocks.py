"""Many symbols at once: roles as integer codes in arrays, so that a whole space is judged by gathering and adding."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from grounding.symbols import Symbol
from grounding.world import Array

NO_ROLE = ""  # the name of a place that is empty
Lookup = Callable[[Sequence[str]], Array]  # from names of roles to their weights in a context


class Slot(NamedTuple):
    """One role of every symbol of a block.

    Attributes:
        names: the roles that occur; `NO_ROLE` where a symbol has none in this slot.
        codes: which of them each symbol has; broadcasts to the block's shape.
    """

    names: tuple[str, ...]
    codes: np.ndarray


@dataclass(frozen=True, eq=False)
class Block:
    """Symbols that are the cells of an array.

    Attributes:
        shape: of the array.
        slots: the roles of its cells.
        symbol: the symbol of a cell, by the cell's index in the flattened array.
        find: the index of a symbol's cell; None where the symbol is not in the block.
    """

    shape: tuple[int, ...]
    slots: tuple[Slot, ...]
    symbol: Callable[[int], Symbol]
    find: Callable[[Symbol], int | None]

    @property
    def size(self) -> int:
        """How many symbols it holds."""
        return math.prod(self.shape)

    def log_odds(self, lookup: Lookup) -> Array:
        """The log odds of every symbol, flattened: the sum of its roles' weights."""
        total = np.zeros(self.shape)
        for slot in self.slots:
            total += lookup(slot.names)[slot.codes]
        return total.ravel()

    def roles(self, index: int) -> list[str]:
        """The roles of one symbol."""
        place = np.unravel_index(index, self.shape)
        named = (slot.names[int(np.broadcast_to(slot.codes, self.shape)[place])] for slot in self.slots)
        return [name for name in named if name != NO_ROLE]

    def groups(self, dropped: Sequence[int] = ()) -> list[tuple[list[str], int]]:
        """The different combinations of roles, each with the number of symbols that have it.

        Args:
            dropped: indices of symbols that do not count.
        """
        keys = np.zeros(self.shape, dtype=np.int64)
        for slot in self.slots:
            keys = keys * len(slot.names) + slot.codes
        flat = np.delete(keys.ravel(), list(dropped))
        _, first, counts = np.unique(keys.ravel() if not len(dropped) else flat, return_index=True, return_counts=True)
        if len(dropped):
            first = np.delete(np.arange(self.size), list(dropped))[first]
        return [(self.roles(int(index)), int(count)) for index, count in zip(first, counts, strict=True)]


@dataclass(frozen=True, eq=False)
class Space:
    """All symbols of one family for one phrase.

    Attributes:
        listed: symbols with their roles, one by one: those that the phrase proposes and some more.
        blocks: all others, in arrays.
        dropped: for each block the indices of those that are listed already.
    """

    listed: list[tuple[Symbol, list[str]]]
    blocks: tuple[Block, ...]
    dropped: tuple[tuple[int, ...], ...]

    @property
    def size(self) -> int:
        """How many symbols there are."""
        return len(self.listed) + sum(
            block.size - len(dropped) for block, dropped in zip(self.blocks, self.dropped, strict=True)
        )


def make_space(listed: list[tuple[Symbol, list[str]]], blocks: Sequence[Block] = ()) -> Space:
    """A space of listed symbols and blocks; what is listed is dropped from the blocks."""
    dropped = []
    for block in blocks:
        found = {place for symbol, _ in listed if (place := block.find(symbol)) is not None}
        dropped.append(tuple(sorted(found)))
    return Space(listed, tuple(blocks), tuple(dropped))
