"""A camera that tells where boxes are: the truth, or the truth with noise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from motion.errors import InvalidGoal
from motion.poses import Array, Pose, about, quaternion

if TYPE_CHECKING:
    from motion.scene import Scene
    from motion.sim.backend import Backend

FRAME = 1 / 30
"""Seconds from one frame of the camera to the next."""


@dataclass(frozen=True)
class Sensor:
    """Accuracy with which the poses of loose boxes are seen.

    Every frame shows every box elsewhere in a ball around where it is, and turned a little about some axis.

    Attributes:
        noise: radius of that ball, metres.
        turn: largest turn, radians.
    """

    noise: float = 0.0
    turn: float = 0.0

    def __post_init__(self) -> None:
        if not (0 <= self.noise < 0.05 and 0 <= self.turn < 0.5):
            raise InvalidGoal(
                f"a sensor's noise is from 0 to 0.05 m and from 0 to 0.5 rad, not {self.noise} and {self.turn}"
            )

    @property
    def exact(self) -> bool:
        """True if it shows the truth."""
        return self.noise == 0.0 and self.turn == 0.0

    def uncertainty(self, frames: int) -> float:
        """Two standard deviations of the distance between the mean of so many frames and the truth, metres."""
        return float(2 * self.noise * np.sqrt(3 / 5 / max(frames, 1)))

    def frame(self, scene: Scene, rng: np.random.Generator) -> Scene:
        """The poses of loose boxes as one frame shows them."""
        if self.exact:
            return scene
        return scene.moved({box.name: self.glimpse(box.pose, rng) for box in scene.boxes if not box.fixed})

    def look(self, simulator: Backend, rng: np.random.Generator, frames: int) -> Scene:
        """The mean of several frames, taken while the robot keeps still; an exact sensor needs one and no time."""
        if self.exact:
            return simulator.scene()
        seen = []
        for _ in range(frames):
            simulator.hold(FRAME)
            seen.append(self.frame(simulator.scene(), rng))
        return seen[0].moved(
            {
                box.name: Pose(
                    np.mean([scene.box(box.name).position for scene in seen], axis=0),
                    _mean(np.array([scene.box(box.name).orientation for scene in seen])),
                )
                for box in seen[0].boxes
                if not box.fixed
            }
        )

    def glimpse(self, pose: Pose, rng: np.random.Generator) -> Pose:
        """The pose at which one frame shows a box that is at `pose`."""
        if self.exact:
            return pose
        offset = _direction(rng) * self.noise * rng.uniform() ** (1 / 3)
        rotation = about(_direction(rng), rng.uniform(-self.turn, self.turn)) @ pose.rotation
        return Pose(pose.position + offset, quaternion(rotation))


def _direction(rng: np.random.Generator) -> Array:
    vector = rng.normal(size=3)
    return np.asarray(vector / np.linalg.norm(vector))


def _mean(orientations: Array) -> Array:
    """(4,) mean of (n, 4) quaternions that differ little (Markley et al., 2007)."""
    _, vectors = np.linalg.eigh(orientations.T @ orientations)
    return np.asarray(vectors[:, -1])
