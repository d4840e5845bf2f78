"""Poses: positions in metres with unit quaternions (w, x, y, z), and the few operations that planning needs on them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def frozen(values: ArrayLike) -> Array:
    """A read-only copy of `values` as float64."""
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array


@dataclass(frozen=True, eq=False)
class Pose:
    """A frame in the world's frame.

    Attributes:
        position: (3,) metres.
        orientation: (4,) unit quaternion w, x, y, z.
    """

    position: Array
    orientation: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "position", frozen(self.position))
        object.__setattr__(self, "orientation", frozen(self.orientation))

    @classmethod
    def of(cls, rotation: ArrayLike, position: ArrayLike) -> Pose:
        """A pose from a (3, 3) rotation matrix and a (3,) position."""
        return cls(frozen(position), quaternion(np.asarray(rotation, dtype=np.float64)))

    @property
    def rotation(self) -> Array:
        """(3, 3) rotation matrix, frame to world."""
        return matrix(self.orientation)

    def __matmul__(self, other: Pose) -> Pose:
        """`other`, given in this frame, in the world's frame."""
        rotation = self.rotation
        return Pose.of(rotation @ other.rotation, self.position + rotation @ other.position)

    def inverse(self) -> Pose:
        """The world in this frame."""
        rotation = self.rotation.T
        return Pose.of(rotation, -rotation @ self.position)

    def distance(self, other: Pose) -> tuple[float, float]:
        """Distance to `other` in metres and the angle between both orientations in radians."""
        cosine = abs(float(np.dot(self.orientation, other.orientation)))
        return float(np.linalg.norm(self.position - other.position)), 2.0 * float(np.arccos(min(1.0, cosine)))


def matrix(orientation: ArrayLike) -> Array:
    """(3, 3) rotation matrix of a unit quaternion (w, x, y, z)."""
    w, x, y, z = np.asarray(orientation, dtype=np.float64)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def quaternion(rotation: Array) -> Array:
    """Unit quaternion (w, x, y, z), w not negative, of a (3, 3) rotation matrix (Shepperd's method)."""
    r = rotation
    diagonal = np.array([r[0, 0] + r[1, 1] + r[2, 2], r[0, 0], r[1, 1], r[2, 2]])
    choice = int(np.argmax(diagonal))
    if choice == 0:
        q = np.array([1 + diagonal[0], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])
    else:
        i = choice - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        q = np.empty(4)
        q[0] = r[k, j] - r[j, k]
        q[1 + i] = 1 + r[i, i] - r[j, j] - r[k, k]
        q[1 + j] = r[j, i] + r[i, j]
        q[1 + k] = r[k, i] + r[i, k]
    q /= np.linalg.norm(q)
    return -q if q[0] < 0 else q


def about(axis: ArrayLike, angle: float) -> Array:
    """(3, 3) rotation by `angle` radians about the unit vector `axis` (Rodrigues)."""
    x, y, z = np.asarray(axis, dtype=np.float64)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
