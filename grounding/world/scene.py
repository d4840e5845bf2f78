"""A layout measured for graded judgements: directions of every viewpoint, gaps between boxes, what stands on what."""

from __future__ import annotations

import math

import numpy as np

from grounding.geometry.arrangements import Arrangement, find_arrangements
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of, mask_of
from grounding.lazy import lazy
from grounding.world import ROBOT_VIEWPOINT, Array, Viewpoint
from grounding.world.board import Board, find_board

ROBOT, SPEAKER = "robot", "speaker"
SPREAD = 0.5
"""Blocks that take up so much of the table in both directions are placed by the table's edges, others by their own."""
BURIED = 0.1
"""What carries something is less likely spoken of."""
STACKED = 0.35
"""Who means the top of a stack mostly says so."""
SLANT = 0.15
"""The middle of a table that is seen from one side lies, in the picture, so much nearer than its own [half extents]."""


class Scene:
    """Υ for graded judgements. Masks are boolean arrays of shape (n,) over `layout.things`."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self.n = layout.size
        self.xy: Array = layout.positions[:, :2]
        self.z: Array = layout.positions[:, 2]
        self.edge = layout.edge
        self._found: dict[int, tuple[Arrangement, ...]] = {}

    def viewpoint(self, owner: str) -> Viewpoint:
        """Where somebody stands: the robot, or the speaker where the world knows one."""
        speaker = self.layout.world.speaker
        return speaker if owner == SPEAKER and speaker is not None else ROBOT_VIEWPOINT

    def direction(self, name: str, owner: str = ROBOT) -> Array:
        """Unit vector (2,) of "left", "right", "front" (towards the viewer) or "back" as somebody sees them."""
        yaw = self.viewpoint(owner).yaw
        ahead = np.array([math.cos(yaw), math.sin(yaw)])
        if name in ("back", "front"):
            return ahead if name == "back" else -ahead
        leftward = np.array([-ahead[1], ahead[0]])
        return leftward if name == "left" else -leftward

    @lazy
    def box(self) -> tuple[Array, Array]:
        """Centre and half extents (2,) of what sides, corners and the middle are spoken of: the blocks or the table."""
        if not self.n:
            return np.zeros(2), np.ones(2)
        low, high = self.xy.min(axis=0), self.xy.max(axis=0)
        centre, half = (low + high) / 2, np.maximum((high - low) / 2, self.edge)
        for item in self.layout.world.objects:
            if item.type == "table" and np.all(half > SPREAD * item.half_extents[:2]):
                return item.position[:2], item.half_extents[:2]
        return centre, half

    @lazy
    def scaled(self) -> Array:
        """Positions within the box, shape (n, 2): -1 and 1 are its edges."""
        centre, half = self.box
        scaled = (self.xy - centre) / half
        if self.on_table:
            ahead = self.direction("back")
            along = scaled @ ahead
            seen = (along + SLANT) / (1.0 + SLANT * along)
            scaled = scaled + (seen - along)[:, None] * ahead
        return np.asarray(scaled)

    @lazy
    def on_whole_table(self) -> Array:
        """Positions on the table, shape (n, 2): -1 and 1 are its edges; within the box where there is no table."""
        for item in self.layout.world.objects:
            if item.type == "table":
                return np.asarray((self.xy - item.position[:2]) / item.half_extents[:2])
        return self.scaled

    @lazy
    def on_table(self) -> bool:
        """Whether the box is the table's."""
        half = self.box[1]
        tables = (item for item in self.layout.world.objects if item.type == "table")
        return any(np.array_equal(half, item.half_extents[:2]) for item in tables)

    @lazy
    def seen(self) -> Array:
        """Positions within the box as a picture shows them, in metres from its centre, shape (n, 2)."""
        return np.asarray(self.scaled * self.box[1])

    @lazy
    def apart(self) -> Array:
        """Distances of centres on the table, shape (n, n) in [m]."""
        return np.asarray(np.linalg.norm(self.xy[:, None] - self.xy[None], axis=2))

    @lazy
    def gaps(self) -> Array:
        """Gaps between the boxes on the table, shape (n, n) in [m]; 0 where they touch or overlap from above.

        By the separating axes of the turned rectangles: exact where sides face each other, at most the gap elsewhere.
        """
        axes = np.empty((self.n, 2, 2))
        halves = np.empty((self.n, 2))
        for i, item in enumerate(self.layout.things):
            w, _, _, z = item.orientation
            yaw = 2 * math.atan2(z, w)
            axes[i] = ((math.cos(yaw), math.sin(yaw)), (-math.sin(yaw), math.cos(yaw)))
            halves[i] = item.size[:2] / 2
        offset = self.xy[None] - self.xy[:, None]
        found = np.full((self.n, self.n), -np.inf)
        for k in range(2):
            along = np.abs(np.einsum("ijd,id->ij", offset, axes[:, k]))
            other = np.einsum("jkd,id->ijk", axes, axes[:, k])
            reach = halves[:, k][:, None] + (np.abs(other) * halves[None]).sum(axis=2)
            found = np.maximum(found, np.maximum(along - reach, (along - reach).T))
        return np.asarray(np.maximum(found, 0.0))

    @lazy
    def board(self) -> Board | None:
        """The squares on which everything stands, or None."""
        return find_board(self.layout.world, self.edge)

    @lazy
    def halves(self) -> Array:
        """Half extents of the boxes along x and y as they lie unturned, shape (n, 2) in [m]."""
        return np.array([item.size[:2] / 2 for item in self.layout.things]).reshape(-1, 2)

    @lazy
    def towers(self) -> tuple[tuple[int, ...], ...]:
        """Stacks, each from its lowest to its highest member."""
        found = [a for a in self.layout.arrangements if a.kind == "tower"]
        return tuple(tuple(sorted(indices_of(a.mask), key=lambda i: self.z[i])) for a in found)

    @lazy
    def stacked(self) -> np.ndarray:
        """What belongs to a stack."""
        mask = np.zeros(self.n, dtype=bool)
        for tower in self.towers:
            mask[list(tower)] = True
        return mask

    @lazy
    def raised(self) -> np.ndarray:
        """What stands on another block."""
        mask = np.zeros(self.n, dtype=bool)
        for tower in self.towers:
            mask[list(tower[1:])] = True
        return mask

    @lazy
    def clear(self) -> np.ndarray:
        """What carries nothing."""
        mask = np.ones(self.n, dtype=bool)
        for tower in self.towers:
            top = max(self.z[i] for i in tower)
            mask[[i for i in tower if self.z[i] < top - 0.3 * self.edge]] = False
        return mask

    def in_one_tower(self, mask: np.ndarray) -> bool:
        """Whether objects, boolean (n,), all stand in one stack."""
        members = set(np.flatnonzero(mask))
        return any(members <= set(tower) for tower in self.towers)

    def supports(self, below: int, above: int) -> bool:
        """Whether one object stands somewhere below another in a stack."""
        return any(below in tower and above in tower and self.z[below] < self.z[above] for tower in self.towers)

    @lazy
    def salience(self) -> Array:
        """How readily every object is spoken of where the words name no stack, shape (n,)."""
        return np.where(self.clear, np.where(self.stacked, STACKED, 1.0), BURIED)

    def arrangements(self, mask: np.ndarray) -> tuple[Arrangement, ...]:
        """Arrangements among some objects only, their masks over all objects."""
        members = np.flatnonzero(mask)
        key = mask_of(int(i) for i in members)
        if key == self.layout.everything:
            return self.layout.arrangements
        if key not in self._found:
            found = find_arrangements(self.layout.positions[members], self.layout.edges[members])
            self._found[key] = tuple(
                Arrangement(a.kind, mask_of(int(members[i]) for i in indices_of(a.mask)), a.count, a.centroid,
                            a.deviation, a.regularity, a.separation, a.angle)
                for a in found
            )  # fmt: skip
        return self._found[key]

    def members(self, mask: int) -> np.ndarray:
        """A mask of bits as a boolean array."""
        found = np.zeros(self.n, dtype=bool)
        found[list(indices_of(mask))] = True
        return found
