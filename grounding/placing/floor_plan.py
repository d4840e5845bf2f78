"""Candidate places: on every stack, beside every object, on a grid over the table, and where clues point exactly."""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from grounding.lexicon.support import bare
from grounding.lexicon.table import tables
from grounding.world import Array
from grounding.world.scene import Scene

PITCH = 1.09  # from block to block where they lie side by side [edges]
_CELLS = 600  # of the grid, about
_FINE = 0.5  # the grid's step, at least [edges]
_REACH = 4.0  # the grid's border around the objects where there is no table [edges]
_CELL, _FACE, _DIAGONAL, _APART, _EXACT, _TOP = 1.0, 5.0, 1.6, 2.0, 4.0, 20.0
"""Weights of how often people choose such places: half of what they move comes to stand on or beside something."""
_FACES = np.array([[1.0, 0], [-1, 0], [0, 1], [0, -1]])
_CORNERS = np.array([[1.0, 1], [1, -1], [-1, 1], [-1, -1]])
_AROUND = np.concatenate([_FACES, _CORNERS, 2 * _FACES]) * PITCH
_SHARES = np.repeat([_FACE, _DIAGONAL, _APART], 4)


@dataclass(frozen=True, eq=False)
class Places:
    """Places that are free and supported.

    Attributes:
        points: in edges along "right" and "back", shape (p, 2).
        support: what each is on top of, -1 for the table, shape (p,).
        prior: how often such places are chosen, shape (p,).
    """

    points: Array
    support: np.ndarray
    prior: Array


@dataclass(frozen=True, eq=False)
class FloorPlan:
    """The floor plan as a viewer sees it, in edges.

    Attributes:
        points: centres of the objects along "right" and "back", shape (n, 2).
        reach: how near the centre of a block may come to each, along one axis at least, shape (n,).
        level: which block of a stack each is, counted from 1 at the table, shape (n,).
        axes: "right" and "back" in the world, shape (2, 2).
        edge: [m].
        pitch: from one place to the next, side by side or on a board [edges].
        board: number of squares along the axes where there is a board, shape (2,).
        centre: of the table, or of what surrounds the objects where there is none, shape (2,).
        half: its half extents, shape (2,).
        boxes: centres and half extents of all tables, each of shape (t, 2).
        spots: a grid, and what surrounds every object, shape (s, 2).
        prior: how often such places are chosen, 0 off the table, shape (s,).
        around: which object each of them surrounds, -1 for the grid, shape (s,).
        taken: which of them each object takes, shape (n, s).
    """

    points: Array
    reach: Array
    level: np.ndarray
    axes: Array
    edge: float
    pitch: float
    board: Array | None
    centre: Array
    half: Array
    boxes: tuple[Array, Array]
    spots: Array
    prior: Array
    around: np.ndarray
    taken: np.ndarray

    def world(self, point: Array) -> Array:
        """A point in the world's frame [m]."""
        return np.asarray(point @ self.axes * self.edge)

    def local(self, point: Array) -> Array:
        """A point of the world's frame [m] along "right" and "back" [edges]."""
        return np.asarray(point @ self.axes.T / self.edge)


_plans: WeakKeyDictionary[Scene, dict[tuple[str, int], FloorPlan]] = WeakKeyDictionary()


def lay_out(scene: Scene, view: str, main: int = 0) -> FloorPlan:
    """The floor plan as somebody sees it; it is kept as long as the scene.

    Args:
        scene: the world.
        view: whose directions are its axes.
        main: index of the table whose sides and middle are meant, where there are several.
    """
    plans = _plans.setdefault(scene, {})
    if (view, main) not in plans:
        plans[view, main] = _draw(scene, view, main)
    return plans[view, main]


def find_places(plan: FloorPlan, scene: Scene, source: int, exact: Array) -> Places:
    """All candidates.

    Args:
        plan: the floor plan.
        scene: the world.
        source: index of what is moved; it is in nobody's way.
        exact: where clues point, shape (m, 2).
    """
    others = np.delete(np.arange(scene.n), source)
    free = (plan.prior > 0) & (plan.around != source) & ~plan.taken[others].any(axis=0)
    near = lying_at(plan, source, exact)
    carrying = bare(scene)
    tops = np.array([i for i in others if carrying[i] and scene.apart[i, source] > 0.5 * scene.edge], dtype=int)
    return Places(
        np.concatenate([plan.spots[free], near.points, plan.points[tops]]),
        np.concatenate([np.full(int(free.sum()), -1), near.support, tops]),
        np.concatenate([plan.prior[free], near.prior, np.full(len(tops), _TOP)]),
    )


def lying_at(plan: FloorPlan, source: int, points: Array) -> Places:
    """Those of `points`, shape (m, 2), that are free and on a table.

    Args:
        plan: the floor plan.
        source: index of what is moved; it is in nobody's way.
        points: along "right" and "back" [edges].
    """
    others = np.delete(np.arange(len(plan.points)), source)
    taken = _overlaps(points, plan.points[others], plan.reach[others]).any(axis=0)
    free = points[_inside(points, *plan.boxes) & ~taken]
    return Places(free, np.full(len(free), -1), np.full(len(free), _EXACT))


def _draw(scene: Scene, view: str, main: int) -> FloorPlan:
    axes = np.array([scene.direction("right", view), scene.direction("back", view)])
    points = scene.xy @ axes.T / scene.edge
    found = tables(scene)
    if found:
        centres = np.array([axes @ item.position[:2] / scene.edge for item in found])
        halves = np.array([np.abs(axes) @ item.half_extents[:2] / scene.edge for item in found])
    else:
        low, high = points.min(axis=0, initial=0.0), points.max(axis=0, initial=0.0)
        centres, halves = ((low + high) / 2)[None], ((high - low) / 2 + _REACH)[None]
    board = scene.board
    grid = np.concatenate([_grid(c, h) for c, h in zip(centres, halves, strict=True)]) if board is None else (
        board.centres @ axes.T / scene.edge
    )
    surrounding = _AROUND if board is None else _AROUND[:0]
    beside = (points[:, None] + surrounding).reshape(-1, 2)
    spots = np.concatenate([grid, beside])
    prior = np.concatenate([np.full(len(grid), _CELL), np.tile(_SHARES[: len(surrounding)], len(points))])
    around = np.concatenate([np.full(len(grid), -1), np.repeat(np.arange(len(points)), len(surrounding))])
    prior = np.where(_inside(spots, centres, halves), prior, 0.0)
    sizes = np.array([float(item.size[:2].max()) for item in scene.layout.things])
    reach = 0.5 * (1.0 + sizes / scene.edge)
    taken = _overlaps(spots, points, reach)
    level = np.ones(scene.n, dtype=int)
    for tower in scene.towers:
        level[list(tower)] = np.arange(1, len(tower) + 1)
    squares = None if board is None else np.round(np.abs(axes) @ np.array(board.shape))
    pitch = PITCH if board is None else board.pitch / scene.edge
    return FloorPlan(points, reach, level, axes, scene.edge, pitch, squares, centres[main], halves[main],
                     (centres, halves), spots, prior, around, taken)  # fmt: skip


def _grid(centre: Array, half: Array) -> Array:
    room = np.maximum(half - 0.5, 0.0)
    step = max(_FINE, float(np.sqrt(4 * room[0] * room[1] / _CELLS)))
    lines = [np.arange(-room[k], room[k] + 1e-9, step) + centre[k] for k in range(2)]
    return np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 2)


def _inside(points: Array, centres: Array, halves: Array) -> np.ndarray:
    """Tells which points (p, 2) are on one of the tables (t, 2) with a whole block."""
    off = (np.abs(points[:, None] - centres) - halves).max(axis=2)
    return np.asarray((off <= -0.5 + 1e-6).any(axis=1))


def _overlaps(points: Array, standing: Array, reach: Array) -> np.ndarray:
    """Tells which objects (n, 2) that reach so far, (n,), a block at points (p, 2) would overlap, shape (n, p)."""
    off = [np.abs(standing[:, k][:, None] - points[:, k]) for k in range(2)]
    return np.asarray(np.maximum(off[0], off[1]) < reach[:, None] - 1e-6)
