"""A hand that lays rows, grids, rings, heaps, towers and pairs, and remembers the places that these leave open."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from grounding.corpus.by_hand.room import EDGE, gap
from grounding.corpus.tabletop import TABLE_TOP, Looks, Tabletop, heap, line, ring
from grounding.world import Array, WorldObject

REACH_X = (0.465, 0.775)  # centres of blocks, as in the scenes that ship, in [m]
REACH_Y = (-0.62, 0.62)
_JITTER = 0.003  # standard deviation of a block's place in [m]
_YAW = 0.13  # half width of a block's turn in [rad]
_PITCH = (0.08, 0.094)  # of neighbours in rows, grids and rings in [m]
_CLOSE = (0.068, 0.074)  # of pairs in [m]


@dataclass(frozen=True)
class Opening:
    """A place that an arrangement leaves open for one more block.

    Attributes:
        kind: gap, end, middle, between, beside, top or corner.
        place: centre (x, y, z) in [m] of a block there.
        near: ids of the blocks that make it what it is.
    """

    kind: str
    place: tuple[float, float, float]
    near: tuple[str, ...] = ()


@dataclass
class Hand:
    """Lays one scene.

    Attributes:
        rng: where chance comes from.
        palette: the scene's colours.
        mixed: whether colours change within an arrangement.
        table: what is laid on.
        openings: that the arrangements left.
        arranged: ids of the blocks that belong to an arrangement.
    """

    rng: np.random.Generator
    palette: tuple[str, ...]
    mixed: bool
    table: Tabletop = field(init=False)
    openings: list[Opening] = field(default_factory=list)
    arranged: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.table = Tabletop(self.rng, REACH_X, REACH_Y, 0.02)

    def colors(self, count: int) -> tuple[str, ...]:
        """Colours of an arrangement: all alike, or mixed as the scene is."""
        picks = self.rng.integers(len(self.palette), size=count if self.mixed else 1)
        return tuple(self.palette[i] for i in np.resize(picks, count).tolist())

    def row(self, count: int, leave: bool = False) -> bool:
        """A row, a column or, seldom, a slanted line; with a gap within if `leave`."""
        turn = float(self.rng.choice((math.pi / 2, math.pi / 2, 0.0, 0.6), p=(0.4, 0.3, 0.22, 0.08)))
        if turn == 0.0 and (count + leave) > 4:
            turn = math.pi / 2
        turn += float(self.rng.normal(0.0, 0.04))
        cells = line(count + leave + 2, self._pitch(), turn)
        missing = int(self.rng.integers(2, count)) if leave and count > 2 else (2 if leave else -1)
        inner = [i for i in range(1, len(cells) - 1) if i != missing]
        laid = self._lay(cells, inner, turn - math.pi / 2, "row")
        if laid is None:
            return False
        blocks, middle = laid
        near = tuple(block.id for block in blocks)
        for i in (0, len(cells) - 1):
            self._open("end", middle + cells[i], near)
        if leave:
            self._open("gap", middle + cells[missing], near)
        return True

    def grid(self, rows: int, columns: int, leave: bool = False) -> bool:
        """A grid along the table, slightly turned; with one cell empty if `leave`."""
        turn, pitch = float(self.rng.normal(0.0, 0.04)), self._pitch()
        x, y = np.meshgrid(np.arange(rows) - (rows - 1) / 2, np.arange(columns) - (columns - 1) / 2, indexing="ij")
        flat = np.column_stack([x.ravel(), y.ravel()]) * pitch
        cells = flat @ np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
        missing = int(self.rng.integers(len(cells))) if leave else -1
        laid = self._lay(cells, [i for i in range(len(cells)) if i != missing], turn, "grid")
        if laid is None:
            return False
        if leave:
            self._open("gap", laid[1] + cells[missing], tuple(block.id for block in laid[0]))
        return True

    def ring(self, count: int, filled: bool = False) -> bool:
        """A ring, with a block in its middle if `filled`."""
        pitch = 0.084 if count > 6 else max(self._pitch(), 0.1)
        cells = np.concatenate([ring(count, pitch, float(self.rng.uniform(0, 6.28))), np.zeros((1, 2))])
        laid = self._lay(cells, list(range(count + filled)), float(self.rng.uniform(-0.2, 0.2)), "ring")
        if laid is not None and not filled:
            self._open("middle", laid[1], tuple(block.id for block in laid[0]))
        return laid is not None

    def heap(self, count: int) -> bool:
        """A dense bunch without order."""
        cells = heap(count, float(self.rng.uniform(0.078, 0.088)), self.rng)
        return self._lay(cells, list(range(count)), float(self.rng.uniform(-0.7, 0.7)), "heap") is not None

    def alike(self, count: int, color: str) -> bool:
        """Two or three blocks of a colour close together."""
        turn = float(self.rng.choice((0.0, math.pi / 2)) + self.rng.normal(0.0, 0.15))
        cells = line(count, float(self.rng.uniform(*_CLOSE)), turn)
        return self._lay(cells, list(range(count)), turn, "pair", (color,) * count, 0.05) is not None

    def tower(self, count: int) -> bool:
        """A stack that rests exactly."""
        place = self.table.room(np.zeros((1, 2)), EDGE)
        if place is None:
            return False
        looks = Looks(self._shuffled_palette(count), EDGE, 0.0, _YAW, float(self.rng.uniform(-0.3, 0.3)))
        blocks = self.table.stack(place, count, looks)
        self.arranged |= {block.id for block in blocks}
        return True

    def loose(self, count: int, near: bool = False) -> bool:
        """Blocks that belong to nothing, anywhere or, if `near`, beside what lies there already."""
        left = count
        for _ in range(60 * count):
            if not left:
                break
            place = self.rng.uniform((REACH_X[0], REACH_Y[0]), (REACH_X[1], REACH_Y[1]))
            if near and self.table.blocks and self.rng.random() < 0.7:
                other = self.table.blocks[int(self.rng.integers(len(self.table.blocks)))]
                angle = self.rng.uniform(0, 2 * math.pi)
                step = self.rng.uniform(0.066, 0.12) * np.array([math.cos(angle), math.sin(angle)])
                place = other.position[:2] + step
            turn = float(self.rng.uniform(-0.7, 0.7))
            free = 0.013 if near else 0.045
            if _inside(place) and all(gap(place, turn, other) >= free for other in self.table.blocks):
                color = self.palette[int(self.rng.integers(len(self.palette)))]
                self.table.lay(None, place[None], Looks((color,), EDGE, 0.0, 0.0, turn))
                left -= 1
        return not left

    def _pitch(self) -> float:
        return float(self.rng.uniform(*_PITCH))

    def _shuffled_palette(self, count: int) -> tuple[str, ...]:
        return tuple(self.palette[i] for i in self.rng.integers(len(self.palette), size=count).tolist())

    def _lay(
        self, cells: Array, inner: list[int], turn: float, kind: str, colors: tuple[str, ...] = (), yaw: float = _YAW
    ) -> tuple[tuple[WorldObject, ...], Array] | None:
        """Lay blocks on some cells where all of these find room; the blocks and the middle of the cells."""
        middle = self.table.room(cells[inner], EDGE, 64)
        if middle is None:
            return None
        jitter = _JITTER if kind != "pair" else 0.0008
        looks = Looks(colors or self.colors(len(inner)), EDGE, jitter, yaw, turn)
        blocks = self.table.lay(None, middle + cells[inner], looks)
        self.arranged |= {block.id for block in blocks}
        return blocks, middle

    def _open(self, kind: str, place: Array, near: tuple[str, ...]) -> None:
        x, y = (round(float(value), 4) for value in place)
        self.openings.append(Opening(kind, (x, y, TABLE_TOP + EDGE / 2), near))


def _inside(place: Array) -> bool:
    return REACH_X[0] <= place[0] <= REACH_X[1] and REACH_Y[0] <= place[1] <= REACH_Y[1]
