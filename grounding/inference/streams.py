"""Alternatives in the order of their probability, made only as far as they are asked for."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import count
from typing import Generic, TypeVar

S = TypeVar("S")
T = TypeVar("T")


class Stream(Generic[T]):
    """Alternatives with their log probability, the likeliest first; can be gone through more than once."""

    def __init__(self, source: Iterable[tuple[float, T]]) -> None:
        self._source = iter(source)
        self._known: list[tuple[float, T]] = []

    def __iter__(self) -> Iterator[tuple[float, T]]:
        for place in count():
            if place == len(self._known):
                found = next(self._source, None)
                if found is None:
                    return
                self._known.append(found)
            yield self._known[place]


def expand(
    base: Iterable[tuple[float, S]], follow: Callable[[S], Iterable[tuple[float, T]]]
) -> Iterator[tuple[float, T]]:
    """All continuations of all alternatives, the likeliest first.

    No continuation is likelier than what it continues, so that alternatives which are less likely than the best
    continuation found need not be looked at yet.

    Args:
        base: alternatives, the likeliest first.
        follow: the continuations of one, the likeliest first, with the log probability given that one.
    """
    alternatives = iter(base)
    ties = count()
    pending = next(alternatives, None)
    heap: list[tuple[float, int, float, T, Iterator[tuple[float, T]]]] = []

    def push(log: float, rest: Iterator[tuple[float, T]]) -> None:
        found = next(rest, None)
        if found is not None:
            heapq.heappush(heap, (-(log + found[0]), next(ties), log, found[1], rest))

    while heap or pending is not None:
        while pending is not None and (not heap or pending[0] > -heap[0][0]):
            push(pending[0], iter(follow(pending[1])))
            pending = next(alternatives, None)
        if not heap:
            return
        cost, _, log, value, rest = heapq.heappop(heap)
        yield -cost, value
        push(log, rest)


def ranked_sets(log_odds: Sequence[float], rest: float = 0.0) -> Iterator[tuple[float, frozenset[int]]]:
    """All truth assignments of independent binary variables, the likeliest first.

    Args:
        log_odds: of each variable being true.
        rest: log probability of what is the same in all of them.

    Yields:
        log probability, indices of the true variables.
    """
    base = frozenset(i for i, odds in enumerate(log_odds) if odds > 0)
    best = rest - sum(math.log1p(math.exp(-min(abs(odds), 700.0))) for odds in log_odds)
    yield best, base
    cheap = sorted((abs(odds), i) for i, odds in enumerate(log_odds))
    heap: list[tuple[float, int, tuple[int, ...]]] = [(cheap[0][0], 0, (0,))] if cheap else []
    while heap:
        cost, last, places = heapq.heappop(heap)
        yield best - cost, base ^ frozenset(cheap[place][1] for place in places)
        if last + 1 < len(cheap):
            more = cheap[last + 1][0]
            heapq.heappush(heap, (cost + more, last + 1, (*places, last + 1)))
            heapq.heappush(heap, (cost - cheap[last][0] + more, last + 1, (*places[:-1], last + 1)))
