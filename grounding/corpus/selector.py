"""Selects from sets of objects for annotation, and refuses what is too close to call."""

from __future__ import annotations

import numpy as np

from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.sight import sight_of
from grounding.geometry.layout import UPRIGHT, Layout
from grounding.geometry.masks import indices_of, single
from grounding.language.tree import Phrase
from grounding.symbols import LAST, Container, ObjectSymbol, Region, Symbol

MARGIN = 0.01  # an extreme object is so much more extreme than the next one [m]


class Selector:
    """Selections in one world."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self.sight = sight_of(layout)

    def objects(self, mask: int) -> frozenset[Symbol]:
        """The symbols of the members of a set."""
        return frozenset(ObjectSymbol(name) for name in self.layout.names(mask))

    def contained(self, kind: str, mask: int) -> frozenset[Symbol]:
        """A container and its members; one object is no container."""
        if single(mask):
            return self.objects(mask)
        return self.objects(mask) | {Container(kind, self.layout.names(mask))}

    def choose(self, phrase: Phrase, pool: int, how: Meaning, kind: str = "", upright: bool = False) -> int:
        """The member of a set that is meant; empty where none or several could be.

        Args:
            phrase: for messages.
            pool: the set.
            how: what says which member: a direction, a corner, a distance to something, an index.
            kind: of the arrangement that the set is, or "".
            upright: whether top and bottom are up and down whatever the set.

        Raises:
            NotAnnotatable: the best one is too close to the next.
        """
        if how.comparative and pool.bit_count() != 2:
            raise NotAnnotatable(f"{phrase.text!r}: a comparison is of two")
        if how.nearest_to:
            pool &= ~self.layout.mask(how.nearest_to)
            return self._by(phrase, pool, self.layout.distance_to(pool, how.nearest_to), how.index or 1, how.away)
        if how.corner:
            point = self.sight.place(how.corner)
            away = np.linalg.norm(self.layout.positions[list(indices_of(pool)), :2] - point, axis=1)
            return self._by(phrase, pool, away, how.index or 1, False, 3 * MARGIN)
        if how.relation is None:
            return pool if single(pool) and how.index is None else 0
        ranked = how.relation
        if not upright and not self.layout.stacked(pool):
            ranked = UPRIGHT.get(ranked, ranked)
        chosen = self.rank(phrase, pool, ranked, how.index or 1, kind)
        if how.by_speaker and chosen and self.sight.speaker is not None:
            away = np.linalg.norm(self.layout.positions[list(indices_of(pool)), :2] - self.sight.speaker, axis=1)
            if self._by(phrase, pool, away, how.index or 1, how.relation == "near") != chosen:
                raise NotAnnotatable(f"{phrase.text!r}: near the speaker is not far from the robot")
        return chosen

    def _by(
        self, phrase: Phrase, pool: int, score: np.ndarray, index: int, descending: bool, margin: float = MARGIN
    ) -> int:
        """The index-th member by a score, clearly before and behind its neighbours."""
        members = list(indices_of(pool))
        place = len(members) - 1 if index == LAST else index - 1
        if not 0 <= place < len(members):
            return 0
        score = -score if descending else score
        order = np.argsort(score, kind="stable")
        for a, b in ((place - 1, place), (place, place + 1)):
            if 0 <= a and b < len(order) and score[order[b]] - score[order[a]] < margin:
                raise NotAnnotatable(f"{phrase.text!r}: too close to call")
        return 1 << members[int(order[place])]

    def alone(self, phrase: Phrase, pool: int) -> int:
        """The members of a set that stand alone, or its only one."""
        if single(pool):
            return pool
        found, clear = self.sight.alone(pool)
        if not clear:
            raise NotAnnotatable(f"{phrase.text!r}: which ones are alone?")
        return found

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

    def nearest(self, phrase: Phrase, pool: int, how: Meaning, number: int) -> int:
        """The `number` members nearest to a reference, or farthest from it; empty where there are fewer."""
        pool &= ~self.layout.mask(how.nearest_to)
        members = list(indices_of(pool))
        if len(members) < number:
            return 0
        away = self.layout.distance_to(pool, how.nearest_to)
        order = np.argsort(-away if how.away else away, kind="stable")
        if len(order) > number and abs(away[order[number]] - away[order[number - 1]]) < MARGIN:
            raise NotAnnotatable(f"{phrase.text!r}: too close to call")
        return sum(1 << members[int(i)] for i in order[:number])

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
            score = [-float(np.linalg.norm(self._middle_of(mask) - centre)) for _, mask in cands]
        else:
            score = [float(self.layout.extent(mask, direction).mean()) for _, mask in cands]
        return self._best(phrase, cands, score, index)

    def arrangement(self, phrase: Phrase, cands: list[tuple[str, int]], how: Meaning) -> tuple[str, int] | None:
        """Which of several arrangements is meant; None where none or several could be.

        Raises:
            NotAnnotatable: the best one is too close to the next.
        """
        if how.comparative and len(cands) != 2:
            raise NotAnnotatable(f"{phrase.text!r}: a comparison is of two")
        if len(cands) == 1:
            return cands[0] if how.index in (None, 1, LAST) else None
        if not cands:
            return None
        if how.nearest_to:
            away = [float(self.layout.distance_to(mask, how.nearest_to).min()) for _, mask in cands]
            return self._best(phrase, cands, away if how.away else [-value for value in away], how.index or 1)
        if how.corner:
            point = self.sight.place(how.corner)
            return self._best(phrase, cands, [-float(np.linalg.norm(self._middle_of(m) - point)) for _, m in cands],
                              how.index or 1)  # fmt: skip
        if how.relation:
            return self.extreme_arrangement(phrase, cands, how.relation, how.index or 1)
        if how.size:
            sizes = [float(how.size * mask.bit_count()) for _, mask in cands]
            return self._best(phrase, cands, sizes, how.index or 1)
        return None

    def _middle_of(self, mask: int) -> np.ndarray:
        return np.asarray(self.layout.positions[list(indices_of(mask)), :2].mean(axis=0))

    def _best(self, phrase: Phrase, cands: list[tuple[str, int]], score: list[float], index: int) -> tuple[str, int]:
        """The index-th of several arrangements by a score, clearly before and behind its neighbours."""
        order = sorted(range(len(cands)), key=lambda i: -score[i])
        place = len(order) - 1 if index == LAST else index - 1
        if place >= len(order):
            raise NotAnnotatable(f"{phrase.text!r}: there are not so many")
        for a, b in ((place - 1, place), (place, place + 1)):
            if 0 <= a and b < len(order) and score[order[a]] - score[order[b]] < 5 * MARGIN:
                raise NotAnnotatable(f"{phrase.text!r}: too close to call")
        return cands[order[place]]

    def middle(self, direction: str) -> float:
        """Where the table's half in a direction begins."""
        tables = [item for item in self.layout.world.objects if item.type == "table"]
        x, y, _ = tables[0].position if tables else self.layout.positions.mean(axis=0)
        return float({"left": y, "right": -y, "back": x, "front": -x}.get(direction, -np.inf))

    def half(self, phrase: Phrase, pool: int, direction: str, clear: bool = False) -> int:
        """The members on one half of the table; `clear` asks that none stands near its middle."""
        direction = UPRIGHT.get(direction, direction)
        if direction not in ("left", "right", "front", "back"):
            raise NotAnnotatable(f"{phrase.text!r}: no half of the table is meant")
        members = list(indices_of(pool))
        over = self.layout.extent(pool, direction) - self.middle(direction)
        if clear and (np.abs(over) < 2 * MARGIN).any():
            raise NotAnnotatable(f"{phrase.text!r}: some stand in between")
        return sum(1 << i for i, value in zip(members, over, strict=True) if value > 0)
