"""A board: a table on which everything stands on squares, told by the world or seen from where things stand."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from grounding.world.objects import Array, World

MOST = 40
"""Squares along a side, at most."""
WIDEST = 1.6
"""A square is at most so many times as wide as what stands on it."""
OFF = 0.03
"""What stands on a square is off its middle by at most this share of its width."""
FEWEST = 2
"""Places at which something stands, at least: one may be so by chance."""


class Board(NamedTuple):
    """Squares of one width that fill a table.

    Attributes:
        corner: of the table, with the smallest x and y, shape (2,) in [m].
        pitch: width of a square [m].
        shape: number of squares along x and y.
    """

    corner: Array
    pitch: float
    shape: tuple[int, int]

    @property
    def centres(self) -> Array:
        """Middles of all squares, shape (squares, 2) in [m]."""
        x, y = (np.arange(count) + 0.5 for count in self.shape)
        return np.asarray(self.corner + self.pitch * np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2))


def find_board(world: World, edge: float) -> Board | None:
    """The board of a world, or None where things do not stand on squares.

    Args:
        world: with one table.
        edge: of a typical block [m].
    """
    tables = [item for item in world.objects if item.type == "table"]
    if len(tables) != 1 or not world.things:
        return None
    corner, size = tables[0].position[:2] - tables[0].half_extents[:2], 2 * tables[0].half_extents[:2]
    standing = np.unique(np.round(world.positions[:, :2], 4), axis=0)
    if len(standing) < FEWEST or np.all(np.ptp(standing, axis=0) < 0.5 * edge):
        return None
    for count in range(1, MOST + 1):
        pitch = float(size[0]) / count
        other = float(size[1]) / pitch
        if not edge <= pitch <= WIDEST * edge or abs(other - round(other)) > OFF:
            continue
        at = (standing - corner) / pitch - 0.5
        if np.abs(at - np.round(at)).max() <= OFF:
            return Board(corner, pitch, (count, round(other)))
    return None
