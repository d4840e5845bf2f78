"""Many symbols at once: roles as integer codes in arrays, so that a whole space is judged by gathering and adding."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
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
        salient: cells that no sample leaves out.
    """

    shape: tuple[int, ...]
    slots: tuple[Slot, ...]
    symbol: Callable[[int], Symbol]
    find: Callable[[Symbol], int | None]
    salient: tuple[int, ...] = ()

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

    def groups(self, dropped: Sequence[int] = ()) -> list[tuple[list[str], float]]:
        """The different combinations of roles, each with the number of symbols that have it.

        Args:
            dropped: indices of symbols that do not count.
        """
        kept = np.ones(self.size, dtype=bool)
        kept[list(dropped)] = False
        return self._grouped(np.flatnonzero(kept), None)

    def sampled(
        self, count: int, rng: np.random.Generator, dropped: Sequence[int] = ()
    ) -> list[tuple[list[str], float]]:
        """As `groups`, of the salient symbols and of a sample of the others that stands for all of them.

        Args:
            count: how many are drawn, evenly and with repetition; each stands for the same share of all.
            rng: draws them.
            dropped: indices of symbols that do not count.
        """
        kept = np.ones(self.size, dtype=bool)
        kept[list(self.salient)] = False
        kept[list(dropped)] = False
        others = np.flatnonzero(kept)
        salient = np.array(sorted(set(self.salient) - set(dropped)), dtype=int)
        if len(others) <= count:
            return self.groups(dropped)
        drawn = rng.choice(others, count)
        weights = np.concatenate([np.ones(len(salient)), np.full(count, len(others) / count)])
        return self._grouped(np.concatenate([salient, drawn]), weights)

    def _grouped(self, places: np.ndarray, weights: Array | None) -> list[tuple[list[str], float]]:
        codes = [np.broadcast_to(slot.codes, self.shape).ravel()[places] for slot in self.slots]
        keys = np.zeros(len(places), dtype=np.int64)
        for slot, code in zip(self.slots, codes, strict=True):
            keys = keys * len(slot.names) + code
        _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
        counts = np.bincount(inverse, weights, len(first))
        rows = zip(*(code[first].tolist() for code in codes), strict=True)
        names = [slot.names for slot in self.slots]
        return [
            ([name for of, code in zip(names, row, strict=True) if (name := of[code]) != NO_ROLE], float(number))
            for row, number in zip(rows, counts, strict=True)
        ]


@dataclass(frozen=True, eq=False)
class Space:
    """All symbols of one family for one phrase.

    Attributes:
        listed: symbols with their roles, one by one: those that the phrase proposes and some more.
        blocks: all others, in arrays.
        dropped: for each block the indices of those that are listed already.
        alike: roles that many other symbols share, with the number of those; they have no cells of their own.
        proposed: how many of those listed, from the first, adaptive inference proposes.
    """

    listed: list[tuple[Symbol, list[str]]]
    blocks: tuple[Block, ...]
    dropped: tuple[tuple[int, ...], ...]
    alike: tuple[tuple[list[str], int], ...] = ()
    proposed: int = 0

    @property
    def size(self) -> int:
        """How many symbols there are."""
        return self.judged + sum(count - 1 for _, count in self.alike)

    @property
    def judged(self) -> int:
        """How many factors are evaluated: one a symbol, and one for all of `alike` with the same roles."""
        cells = sum(block.size - len(dropped) for block, dropped in zip(self.blocks, self.dropped, strict=True))
        return len(self.listed) + cells + len(self.alike)

    def listing(self, symbols: Iterable[Symbol]) -> Space:
        """The same, some more symbols listed with the roles that they have in their blocks."""
        listed, dropped = list(self.listed), [list(places) for places in self.dropped]
        known = {symbol for symbol, _ in listed}
        for symbol in symbols:
            for block, places in zip(self.blocks, dropped, strict=True):
                place = block.find(symbol)
                if place is not None and symbol not in known:
                    listed.append((symbol, block.roles(place)))
                    places.append(place)
        return replace(self, listed=listed, dropped=tuple(map(tuple, dropped)))

    def unlisted(self, sample: int, rng: np.random.Generator) -> list[tuple[list[str], float]]:
        """The combinations of roles of all symbols that are not listed, each with the number that have it.

        Args:
            sample: of larger blocks with salient symbols, so many of the others are drawn, see `Block.sampled`.
            rng: draws them.
        """
        found: list[tuple[list[str], float]] = []
        for block, dropped in zip(self.blocks, self.dropped, strict=True):
            found += block.sampled(sample, rng, dropped) if block.salient else block.groups(dropped)
        return [*found, *self.alike]


def with_others(
    listed: list[tuple[Symbol, list[str]]], others: list[tuple[Symbol, list[str]]]
) -> list[tuple[Symbol, list[str]]]:
    """What is listed, and of the others those that are not."""
    known = {symbol for symbol, _ in listed}
    return [*listed, *((symbol, roles) for symbol, roles in others if symbol not in known)]


def make_slot(names: Sequence[str], indices: np.ndarray) -> Slot:
    """A slot whose role is found in a list of names, some of which may be the same."""
    different = tuple(dict.fromkeys(names))
    places = {name: i for i, name in enumerate(different)}
    return Slot(different, np.array([places[name] for name in names])[indices])


def make_space(
    listed: list[tuple[Symbol, list[str]]],
    blocks: Sequence[Block] = (),
    alike: Sequence[tuple[list[str], int]] = (),
) -> Space:
    """A space of listed symbols and blocks; what is listed is dropped from the blocks."""
    dropped = []
    for block in blocks:
        found = {place for symbol, _ in listed if (place := block.find(symbol)) is not None}
        dropped.append(tuple(sorted(found)))
    return Space(listed, tuple(blocks), tuple(dropped), tuple(alike))
