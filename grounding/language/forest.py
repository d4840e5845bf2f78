"""Packed parse forests and their k best derivations.

The k best are found lazily, from the root downwards, by algorithm 3 of L. Huang and D. Chiang, "Better k-best parsing"
(IWPT 2005).
"""

from __future__ import annotations

from heapq import heapify, heappop, heappush

from grounding.language.tree import Phrase, Word

Edge = tuple[float, "Node", "Node | None"]
"""One way of making a node: the step's log probability and what it joins, in the order of the sentence."""


class Node:
    """All ways found of making one symbol or state over one span.

    Attributes:
        score: log probability of the best of them.
        edges: the ways.
        content: the word of a leaf, the tag of a phrase, None for a part of a phrase.
    """

    __slots__ = ("_heap", "_made", "content", "edges", "score")

    def __init__(self, score: float, edges: list[Edge], content: Word | str | None = None) -> None:
        self.score = score
        self.edges = edges
        self.content = content
        self._made: list[tuple[float, int, int, int]] = []
        self._heap: list[tuple[float, int, int, int]] | None = None

    def derivation(self, rank: int) -> float | None:
        """Log probability of the derivation with this rank, from 0; None where there are not so many."""
        if not self.edges:
            return self.score if rank == 0 else None
        heap = self._heap
        if heap is None:
            heap = self._heap = [
                (-(step + first.score + (second.score if second else 0.0)), index, 0, 0)
                for index, (step, first, second) in enumerate(self.edges)
            ]
            heapify(heap)
        while len(self._made) <= rank:
            if not heap:
                return None
            cost, index, i, j = heappop(heap)
            self._made.append((-cost, index, i, j))
            self._push(heap, index, i, j + 1)
            if j == 0:
                self._push(heap, index, i + 1, 0)
        return self._made[rank][0]

    def children(self, rank: int) -> tuple[Phrase | Word, ...]:
        """What the derivation with this rank yields: one tree, or the children so far of an unfinished phrase."""
        if isinstance(self.content, Word):
            return (self.content,)
        self.derivation(rank)
        _, index, i, j = self._made[rank]
        _, first, second = self.edges[index]
        parts = first.children(i) if second is None else first.children(i) + second.children(j)
        return parts if self.content is None else (Phrase(self.content, parts),)

    def _push(self, heap: list[tuple[float, int, int, int]], index: int, i: int, j: int) -> None:
        step, first, second = self.edges[index]
        if second is None:
            if j:
                return
            other: float | None = 0.0
        else:
            other = second.derivation(j)
        one = first.derivation(i) if other is not None else None
        if one is not None and other is not None:
            heappush(heap, (-(step + one + other), index, i, j))
