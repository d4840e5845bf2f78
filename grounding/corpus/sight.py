"""What annotation sees in a world beside its layout: contact, loneness, places of the table, diagonals, the speaker.

Everything is computed once a layout and shared by all sentences in it.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np

from grounding.corpus.meaning import Meaning
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of, mask_of
from grounding.world import Array

CONTACT = 0.16  # blocks touch when their sides are at most so many edges apart
NO_CONTACT = 0.5  # and do not when they are so many apart; in between it is not clear
ALONE = 1.35  # a block is alone when all others are so many edges away
BESIDE = 1.0  # and is not when one is at most so many away
SLANTED = 0.45  # a line that deviates from both axes by more is a diagonal [rad]
_STEPS = {"left": (0.0, 1.0), "right": (0.0, -1.0), "back": (1.0, 0.0), "front": (-1.0, 0.0), "center": (0.0, 0.0),
          "top": (1.0, 0.0), "bottom": (-1.0, 0.0), "far": (1.0, 0.0), "near": (-1.0, 0.0)}  # fmt: skip


class Sight:
    """One world as an annotator looks at it; see `sight_of`."""

    def __init__(self, layout: Layout) -> None:
        self.meanings: dict[Hashable, Meaning | str] = {}  # of base noun phrases, or why they have none
        self._things = layout.things
        self._positions = layout.positions
        self._edges = layout.edges
        self._layout_by_members = {(a.kind, a.mask): a.angle for a in layout.arrangements}
        tables = [item for item in layout.world.objects if item.type == "table"]
        self._centre = tables[0].position[:2] if tables else self._positions[:, :2].mean(axis=0)
        spread = np.ptp(self._positions[:, :2], axis=0) / 2 if len(self._positions) else np.ones(2)
        self._half = tables[0].half_extents[:2] if tables else np.maximum(spread, 0.1)
        speaker = layout.world.speaker
        self.speaker: Array | None = None if speaker is None else speaker.position[:2]
        turn = 1.0 if speaker is None else math.cos(speaker.yaw)
        self.opposite = turn < -0.7
        self.beside = turn > 0.7

    @cached_property
    def gaps(self) -> Array:
        """Free space between any two blocks over the mean of their edges, oriented boxes, shape (n, n)."""
        n = len(self._things)
        gaps = np.full((n, n), np.inf)
        centres = self._positions
        for i in range(n):
            for j in range(i + 1, n):
                edge = float(self._edges[i] + self._edges[j]) / 2
                away = float(np.hypot(*(centres[i, :2] - centres[j, :2])))
                if away > 3 * edge:
                    gap = away / edge - 1.2
                else:
                    gap = separation(self._corners[i], self._corners[j], self._axes[i], self._axes[j]) / edge
                rise = abs(float(centres[i, 2] - centres[j, 2])) / edge - 1.0
                gaps[i, j] = gaps[j, i] = max(gap, rise) if rise > -0.5 else gap
        return gaps

    @cached_property
    def _axes(self) -> list[Array]:
        found = []
        for item in self._things:
            w, x, y, z = item.orientation
            turn = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
            found.append(np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]]))
        return found

    @cached_property
    def _corners(self) -> list[Array]:
        signs = np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]]) / 2
        return [
            item.position[:2] + (signs * item.size[:2]) @ axes
            for item, axes in zip(self._things, self._axes, strict=True)
        ]

    def touching(self, reference: int, pool: int) -> tuple[int, bool]:
        """Members of a set that touch one of the reference, and whether it is clear which do."""
        members = list(indices_of(pool))
        others = list(indices_of(reference))
        if not members or not others:
            return 0, True
        gaps = self.gaps[np.ix_(members, others)].min(axis=1)
        touch = gaps <= CONTACT
        clear = not ((gaps > CONTACT) & (gaps < NO_CONTACT)).any()
        return mask_of(i for i, near in zip(members, touch, strict=True) if near), clear

    @cached_property
    def _nearest(self) -> Array:
        return self.gaps.min(axis=1, initial=np.inf)

    def alone(self, pool: int) -> tuple[int, bool]:
        """Members of a set with nothing beside them, and whether it is clear which."""
        members = list(indices_of(pool))
        nearest = self._nearest[members]
        clear = not ((nearest > BESIDE) & (nearest < ALONE)).any()
        return mask_of(i for i, gap in zip(members, nearest, strict=True) if gap >= ALONE), clear

    def place(self, names: Iterable[str], low: Array | None = None, high: Array | None = None) -> Array:
        """The point that directions name on the table, or on what lies within bounds, shape (2,) in [m]."""
        centre = self._centre if low is None or high is None else (low + high) / 2
        half = self._half if low is None or high is None else np.asarray(high - low) / 2
        step = np.sum([_STEPS[name] for name in names], axis=0)
        return np.asarray(centre + step * half)

    def half(self, direction: str) -> tuple[int, int]:
        """What lies on the table's half in a direction, and what lies too near its middle to say."""
        axis, sign = {"left": (1, 1), "right": (1, -1), "back": (0, 1), "front": (0, -1)}[direction]
        over = sign * (self._positions[:, axis] - self._centre[axis])
        return mask_of(np.flatnonzero(over > 0)), mask_of(np.flatnonzero(np.abs(over) < 0.02))

    def slanted(self, kind: str, mask: int) -> bool:
        """Whether a line is a diagonal rather than a row or a column."""
        return self._layout_by_members.get((kind, mask), 0.0) > SLANTED


def separation(a: Array, b: Array, axes_a: Array, axes_b: Array) -> float:
    """The gap between two oriented rectangles along the axis that separates them best; 0 where they overlap."""
    best = 0.0
    for axis in (*axes_a, *axes_b):
        along_a, along_b = a @ axis, b @ axis
        best = max(best, float(along_b.min() - along_a.max()), float(along_a.min() - along_b.max()))
    return best


_SIGHTS: WeakKeyDictionary[Layout, Sight] = WeakKeyDictionary()


def sight_of(layout: Layout) -> Sight:
    """What is seen in a layout; computed once."""
    found = _SIGHTS.get(layout)
    if found is None:
        found = _SIGHTS[layout] = Sight(layout)
    return found
