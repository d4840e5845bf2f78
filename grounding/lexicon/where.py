"""Where a concept is asked for: at the objects of a scene, or at any points at which something could stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from grounding.world import Array
from grounding.world.scene import Scene


@dataclass(frozen=True, eq=False)
class Where:
    """Places at which a concept is asked for.

    Attributes:
        xy: their points on the table, shape (m, 2) in [m].
        z: the heights of their centres, shape (m,) in [m].
        gaps: from what stands there to every object of the scene, shape (m, n) in [m].
        itself: whether a place is an object's own, shape (m, n): nothing is beside itself.
    """

    xy: Array
    z: Array
    gaps: Array
    itself: np.ndarray

    @classmethod
    def objects(cls, scene: Scene) -> Where:
        """At all objects of a scene."""
        return cls(scene.xy, scene.z, scene.gaps, np.eye(scene.n, dtype=bool))

    @classmethod
    def points(cls, scene: Scene, xy: Array, z: Array | None = None, size: Array | None = None) -> Where:
        """At points where a box with sides along the axes could stand.

        Args:
            scene: the world.
            xy: shape (m, 2) in [m].
            z: heights of its centre, shape (m,) in [m]; on the table where nothing is said.
            size: its full edges along x and y, shape (2,) in [m]; a typical block's where nothing is said.
        """
        half = np.full(2, scene.edge / 2) if size is None else np.asarray(size[:2]) / 2
        heights = np.full(len(xy), scene.z.min(initial=scene.edge / 2)) if z is None else z
        apart = np.abs(xy[:, None] - scene.xy[None]) - half - scene.halves[None]
        gaps = np.maximum(apart.max(axis=2), 0.0)
        return cls(xy, heights, gaps, np.zeros((len(xy), scene.n), dtype=bool))

    def __len__(self) -> int:
        return len(self.xy)
