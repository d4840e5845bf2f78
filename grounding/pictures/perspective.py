"""A camera over the table: points of the world become pixels as a person there sees them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from grounding.world import Array, World

FROM_ROBOT = (-0.55, 0.0, 2.5)  # above and behind the robot, in [m]
_BACK = 0.9  # how far behind the table's far edge the camera of a speaker hangs, in [m]
_HIGH = 2.45
_MIDDLE = (0.65, 0.0, 0.711)


@dataclass(frozen=True, eq=False)
class Camera:
    """A pinhole camera without roll.

    Attributes:
        position: shape (3,) in [m].
        axes: right, down and ahead as rows, shape (3, 3).
        focal: pixels a unit of tangent.
        centre: pixel of the optical axis, shape (2,).
    """

    position: Array
    axes: Array
    focal: float = 1.0
    centre: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def looking(cls, position: ArrayLike, target: ArrayLike) -> Camera:
        """A camera at one point that looks at another."""
        start = np.asarray(position, dtype=float)
        ahead = np.asarray(target, dtype=float) - start
        ahead /= np.linalg.norm(ahead)
        right = np.cross(ahead, (0.0, 0.0, 1.0))
        right /= np.linalg.norm(right)
        return cls(start, np.array([right, np.cross(ahead, right), ahead]))

    def fitted(self, points: ArrayLike, box: tuple[float, float, float, float]) -> Camera:
        """The same camera with all of (n, 3) points as large as fits into left, top, right, bottom."""
        plain = Camera(self.position, self.axes)(points)
        low, high = plain.min(axis=0), plain.max(axis=0)
        left, top, right, bottom = box
        focal = float(min((right - left) / (high[0] - low[0]), (bottom - top) / (high[1] - low[1])))
        x, y = np.array([left + right, top + bottom]) / 2 - focal * (low + high) / 2
        return Camera(self.position, self.axes, focal, (float(x), float(y)))

    def __call__(self, points: ArrayLike) -> Array:
        """Pixels of points, (..., 3) in [m] to (..., 2)."""
        seen = (np.asarray(points, dtype=float) - self.position) @ self.axes.T
        return np.asarray(seen[..., :2] / seen[..., 2:] * self.focal + self.centre)

    def faces(self, point: ArrayLike, normal: ArrayLike) -> bool:
        """Whether a surface at a point, with its normal, is turned to the camera."""
        return float((self.position - np.asarray(point, float)) @ np.asarray(normal, float)) > 0.0


def camera_of(world: World) -> Camera:
    """The camera of whoever writes: at the speaker's seat if the world has one, else above and behind the robot."""
    if world.speaker is None:
        return Camera.looking(FROM_ROBOT, _MIDDLE)
    table = next((item for item in world.objects if item.type == "table"), None)
    edge = 1.0 if table is None else float(table.position[0] + table.half_extents[0])
    return Camera.looking((edge + _BACK, float(world.speaker.position[1]), _HIGH), _MIDDLE)
