"""A table being laid: where blocks may stand, where they do, and the world that comes out.

Lines, rings, heaps and stacks are given as offsets from their centre; a `Tabletop` finds room for them and remembers
which arrangement was laid. Blocks of one arrangement keep the distance that its offsets give them; blocks of different
arrangements keep at least `gap`, measured between the circles around their bases.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from grounding.symbols import Container
from grounding.world import Array, World, WorldObject, make_object

TABLE = make_object("table", "table", "white", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04))
TABLE_TOP = 0.711  # z of the table's surface in [m]
REACH_X = (0.46, 0.77)  # centres of blocks that one arm or the other grasps from above, in [m]
REACH_Y = (-0.62, 0.62)
WHOLE_X = (0.36, 0.94)  # centres of blocks that do not stick out over the table's edge, in [m]
WHOLE_Y = (-0.84, 0.84)
_DIGITS = 4  # of positions in [m] and turns in [rad]: tenths of a millimetre


@dataclass(frozen=True, slots=True)
class Looks:
    """What the blocks of an arrangement look like and how neatly they are laid.

    Attributes:
        colors: one a block, repeated as often as needed.
        edge: of the cubes in [m].
        jitter: standard deviation of a block's place along x and along y in [m], cut off at twice that.
        yaw: half width of the interval of a block's turn about z in [rad].
        turn: middle of that interval in [rad].
    """

    colors: tuple[str, ...] = ("red",)
    edge: float = 0.05
    jitter: float = 0.002
    yaw: float = 0.06
    turn: float = 0.0


@dataclass
class Tabletop:
    """A table and the blocks laid on it so far.

    Attributes:
        rng: where chance comes from.
        x: interval of the blocks' centres away from the robot, in [m].
        y: interval of the blocks' centres to the robot's left, in [m].
        gap: least distance between blocks of different arrangements in [m].
        blocks: what lies there, in the order of laying.
        containers: the arrangements laid, with the ids of their blocks.
    """

    rng: np.random.Generator
    x: tuple[float, float] = REACH_X
    y: tuple[float, float] = REACH_Y
    gap: float = 0.03
    blocks: list[WorldObject] = field(default_factory=list)
    containers: list[Container] = field(default_factory=list)
    _taken: list[tuple[float, float, float]] = field(default_factory=list)  # x, y and radius of the bases

    def room(self, offsets: Array, edge: float, tries: int = 32) -> Array | None:
        """Find a place for blocks that keep their places relative to each other.

        Args:
            offsets: (n, 2) from the centre of the arrangement in [m].
            edge: of the cubes in [m].
            tries: how many places to look at, drawn uniformly.

        Returns:
            a centre (2,) in [m] with room for all of them, or None.
        """
        low = np.array([self.x[0], self.y[0]]) - offsets.min(axis=0)
        high = np.array([self.x[1], self.y[1]]) - offsets.max(axis=0)
        if (high < low).any():
            return None
        centres = self.rng.uniform(low, high, (tries, 2))
        free = np.flatnonzero(self._free(centres[:, None] + offsets, edge))
        return centres[free[0]] if len(free) else None

    def lay(self, kind: str | None, places: Array, looks: Looks) -> tuple[WorldObject, ...]:
        """Lay cubes side by side.

        Args:
            kind: of the container that they make, or None.
            places: (n, 2) centres in the world's frame in [m].
            looks: colours, edge and neatness.

        Returns:
            the blocks.
        """
        noise = np.clip(self.rng.normal(0.0, 1.0, places.shape), -2, 2) * looks.jitter
        turns = looks.turn + self.rng.uniform(-looks.yaw, looks.yaw, len(places))
        z = TABLE_TOP + looks.edge / 2
        laid = [
            self._put(place, z, float(turn), looks.colors[i % len(looks.colors)], looks.edge)
            for i, (place, turn) in enumerate(zip(places + noise, turns, strict=True))
        ]
        return self._record(kind, laid)

    def stack(self, place: Array, count: int, looks: Looks, edges: Sequence[float] = ()) -> tuple[WorldObject, ...]:
        """Build a tower that rests exactly, each cube on the one below.

        Args:
            place: (2,) centre of its base in [m].
            count: of cubes.
            looks: colours, from the bottom upward, edge and neatness.
            edges: of the cubes from the bottom upward in [m], if they differ.
        """
        noise = np.clip(self.rng.normal(0.0, 1.0, (count, 2)), -2, 2) * looks.jitter
        turns = looks.turn + self.rng.uniform(-looks.yaw, looks.yaw, count)
        laid, top = [], TABLE_TOP
        for level in range(count):
            edge = edges[level] if edges else looks.edge
            color = looks.colors[level % len(looks.colors)]
            laid.append(self._put(place + noise[level], top + edge / 2, float(turns[level]), color, edge))
            top += edge
        return self._record("tower", laid)

    def scatter(self, looks: Sequence[Looks], rounds: int = 6) -> bool:
        """Lay cubes that belong to nothing, one for each of `looks`, where there is room.

        Returns:
            whether all of them found a place within so many rounds of draws.
        """
        left = list(looks)
        half = max((item.edge for item in left), default=0.0) / np.sqrt(2)
        for _ in range(rounds):
            if not left:
                break
            places = self.rng.uniform((self.x[0], self.y[0]), (self.x[1], self.y[1]), (12 * len(left), 2))
            accepted: list[Array] = []
            for place in places[self._free(places[:, None], 2 * half / np.sqrt(2))]:
                apart = 2 * half + self.gap
                if len(accepted) < len(left) and all(math.dist(place, other) >= apart for other in accepted):
                    accepted.append(place)
            for place in accepted:
                self.lay(None, place[None], left.pop())
        return not left

    def world(self) -> World:
        """The blocks and, last, the table."""
        return World((*self.blocks, TABLE))

    def _free(self, bases: Array, edge: float) -> np.ndarray:
        """(m,) whether all (m, n, 2) bases of a candidate are free."""
        if not self._taken:
            return np.ones(len(bases), dtype=bool)
        taken = np.array(self._taken)
        away = np.hypot(bases[:, :, None, 0] - taken[:, 0], bases[:, :, None, 1] - taken[:, 1])
        return np.asarray((away >= taken[:, 2] + edge / np.sqrt(2) + self.gap).all(axis=(1, 2)))

    def _put(self, place: Array, z: float, turn: float, color: str, edge: float) -> WorldObject:
        position = (round(float(place[0]), _DIGITS), round(float(place[1]), _DIGITS), round(z, _DIGITS + 1))
        half_turn = round(turn / 2, _DIGITS)
        turned = (math.cos(half_turn), 0.0, 0.0, math.sin(half_turn))
        name = f"b{len(self.blocks) + 1}"
        block = WorldObject(name, "block", color, _fixed(position), _fixed(turned), _fixed((edge, edge, edge)))
        self.blocks.append(block)
        self._taken.append((position[0], position[1], edge / np.sqrt(2)))
        return block

    def _record(self, kind: str | None, laid: list[WorldObject]) -> tuple[WorldObject, ...]:
        if kind is not None:
            self.containers.append(Container(kind, tuple(block.id for block in laid)))
        return tuple(laid)


def _fixed(values: tuple[float, ...]) -> Array:
    array = np.array(values)
    array.setflags(write=False)
    return array


def line(count: int, pitch: float, direction: float) -> Array:
    """(count, 2) offsets of a straight line centred on the origin.

    Args:
        count: of blocks.
        pitch: from centre to centre in [m].
        direction: angle from x in [rad]: 0 for a column, pi/2 for a row.
    """
    along = (np.arange(count) - (count - 1) / 2) * pitch
    return np.stack([along * np.cos(direction), along * np.sin(direction)], axis=1)


def ring(count: int, pitch: float, start: float = 0.0) -> Array:
    """(count, 2) offsets of a circle whose neighbours are `pitch` metres apart; the first lies at angle `start`."""
    radius = pitch / (2 * np.sin(np.pi / count))
    angles = start + 2 * np.pi * np.arange(count) / count
    return radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def heap(count: int, pitch: float, rng: np.random.Generator) -> Array:
    """(count, 2) offsets of a dense group without a line's or a ring's order, no two nearer than `pitch` metres."""
    spots = [np.zeros(2)]
    while len(spots) < count:
        angles = rng.uniform(0, 2 * np.pi, 24)
        reach = rng.uniform(1.0, 1.25, 24) * pitch
        anchors = np.array(spots)[rng.integers(len(spots), size=24)]
        candidates = anchors + reach[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        nearest = np.linalg.norm(candidates[:, None] - np.array(spots), axis=2).min(axis=1)
        free = candidates[nearest >= pitch * 0.999]
        if len(free):  # the one nearest to the middle keeps the group dense
            spots.append(free[np.argmin(np.linalg.norm(free - np.mean(spots, axis=0), axis=1))])
    offsets = np.array(spots)
    return np.asarray(offsets - offsets.mean(axis=0))
