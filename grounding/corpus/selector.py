"""Selects from sets of objects for annotation, and refuses what is too close to call."""

from __future__ import annotations

import numpy as np

from grounding.corpus.meaning import NotAnnotatable
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of, single
from grounding.language.tree import Phrase
from grounding.symbols import LAST, Container, ObjectSymbol, Region, Symbol

MARGIN = 0.01  # an extreme object is so much more extreme than the next one [m]


class Selector:
    """Selections in one world."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout

    def objects(self, mask: int) -> frozenset[Symbol]:
        """The symbols of the members of a set."""
        return frozenset(ObjectSymbol(name) for name in self.layout.names(mask))

    def contained(self, kind: str, mask: int) -> frozenset[Symbol]:
        """A container and its members; one object is no container."""
        if single(mask):
            return self.objects(mask)
        return self.objects(mask) | {Container(kind, self.layout.names(mask))}

    def rank(self, phrase: Phrase, pool: int, direction: str, index: int, kind: str) -> int:
        """The index-th member of a set in a direction; empty where there is none."""
        if direction == "center" and kind in ("row", "column", "tower") and index == 1:
            middle = self.layout.median(pool)
            if not middle:
                raise NotAnnotatable(f"{phrase.text!r}: an even number has no middle")
            return middle
        order = self.layout.ranked(pool, direction)
        place = len(order) - 1 if index == LAST else index - 1
        if not 0 <= place < len(order):
            return 0
        self._set_apart(phrase, pool, direction, place, place + 1)
        return 1 << order[place]

    def count(self, phrase: Phrase, pool: int, number: int | None, relation: str | None) -> int:
        """So many members of a set, the most extreme in a direction if one is said; empty where that leaves it open."""
        if number is None:
            if relation is not None:
                raise NotAnnotatable(f"{phrase.text!r}: how many?")
            return pool
        if relation is None:
            return pool if pool.bit_count() == number else 0
        if pool.bit_count() < number:
            return 0
        self._set_apart(phrase, pool, relation, 0, number)
        return self.layout.extreme(pool, relation, number)

    def _set_apart(self, phrase: Phrase, pool: int, direction: str, first: int, end: int) -> None:
        """Whether places [first, end) in the ranking are set apart from the others by the margin."""
        extent = np.sort(self.layout.extent(pool, direction))[::-1]
        for edge in (first, end):
            if 0 < edge < len(extent) and extent[edge - 1] - extent[edge] < MARGIN:
                raise NotAnnotatable(f"{phrase.text!r}: too close to call")

    def closest(self, phrase: Phrase, pool: int, reference: tuple[str, ...]) -> int:
        """The member nearest to the reference; empty for an empty set."""
        members = list(indices_of(pool))
        if not members:
            return 0
        distance = self.layout.distance_to(pool, reference)
        order = np.argsort(distance, kind="stable")
        if len(order) > 1 and distance[order[1]] - distance[order[0]] < MARGIN:
            raise NotAnnotatable(f"{phrase.text!r}: too close to call")
        return 1 << members[int(order[0])]

    def first_met(self, pool: int, region: Region) -> int:
        """Of several objects in a direction of a thing, the one that comes first, if it clearly does."""
        if region.relation not in ("left", "right", "front", "back", "near") or region.objects in ((), ("table",)):
            return 0
        members = list(indices_of(pool))
        away = self.layout.distance_to(pool, region.objects)
        order = np.argsort(away, kind="stable")
        return 1 << members[int(order[0])] if away[order[0]] < 0.75 * away[order[1]] else 0

    def extreme_arrangement(
        self, phrase: Phrase, cands: list[tuple[str, int]], direction: str, index: int
    ) -> tuple[str, int]:
        """The index-th of several arrangements in a direction."""
        if direction == "center":
            centre = self.layout.positions[:, :2].mean(axis=0)
            score = [-float(np.linalg.norm(self.layout.positions[list(indices_of(m)), :2].mean(axis=0) - centre))
                     for _, m in cands]  # fmt: skip
        else:
            score = [float(self.layout.extent(mask, direction).mean()) for _, mask in cands]
        order = sorted(range(len(cands)), key=lambda i: -score[i])
        place = len(order) - 1 if index == LAST else index - 1
        if place >= len(order):
            raise NotAnnotatable(f"{phrase.text!r}: there are not so many")
        for a, b in ((place - 1, place), (place, place + 1)):
            if 0 <= a and b < len(order) and score[order[a]] - score[order[b]] < 5 * MARGIN:
                raise NotAnnotatable(f"{phrase.text!r}: too close to call")
        return cands[order[place]]

    def largest(self, phrase: Phrase, cands: list[tuple[str, int]], sign: int) -> tuple[str, int]:
        """The arrangement with the most members, or the fewest for sign -1."""
        ordered = sorted(cands, key=lambda a: -sign * a[1].bit_count())
        if len(ordered) > 1 and ordered[0][1].bit_count() == ordered[1][1].bit_count():
            raise NotAnnotatable(f"{phrase.text!r}: equally large")
        return ordered[0]

    def middle(self, direction: str) -> float:
        """Where the table's half in a direction begins."""
        tables = [item for item in self.layout.world.objects if item.type == "table"]
        x, y, _ = tables[0].position if tables else self.layout.positions.mean(axis=0)
        return float({"left": y, "right": -y, "back": x, "front": -x}.get(direction, -np.inf))

    def half(self, phrase: Phrase, pool: int, direction: str, clear: bool = False) -> int:
        """The members on one half of the table; `clear` asks that none stands near its middle."""
        if direction not in ("left", "right", "front", "back"):
            raise NotAnnotatable(f"{phrase.text!r}: no half of the table is meant")
        members = list(indices_of(pool))
        over = self.layout.extent(pool, direction) - self.middle(direction)
        if clear and (np.abs(over) < 2 * MARGIN).any():
            raise NotAnnotatable(f"{phrase.text!r}: some stand in between")
        return sum(1 << i for i, value in zip(members, over, strict=True) if value > 0)
