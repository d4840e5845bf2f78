"""Boxes around the robot, with names, poses and sizes. Frozen values, checked when they are made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from motion.errors import InvalidGoal, InvalidScene, UnknownBody
from motion.polygons import contains, hull, overlap
from motion.poses import Array, Pose, about, frozen, matrix

LEANING = 0.05
"""A box whose faces are turned by more than this from level, in radians, does not stand but leans on something."""
RESTING_GAP = 0.003
"""Two boxes whose faces are at most this far apart, in metres, are taken to touch."""


@dataclass(frozen=True, eq=False)
class Box:
    """A box in the world's frame.

    Attributes:
        name: unique in its scene.
        position: (3,) centre, metres.
        orientation: (4,) unit quaternion w, x, y, z.
        size: (3,) full edges, metres.
        color: red, green, blue, opacity in [0, 1].
        mass: kilograms; ignored when fixed.
        fixed: True for what never moves, such as the table.
    """

    name: str
    position: Array
    orientation: Array = (1.0, 0.0, 0.0, 0.0)  # type: ignore[assignment]
    size: Array = (0.05, 0.05, 0.05)  # type: ignore[assignment]
    color: tuple[float, float, float, float] = (0.75, 0.09, 0.09, 1.0)
    mass: float = 0.1
    fixed: bool = False

    def __post_init__(self) -> None:
        if not self.name or not isinstance(self.name, str):
            raise InvalidScene(f"a box needs a name that is not empty, not {self.name!r}")
        for key, length in (("position", 3), ("orientation", 4), ("size", 3), ("color", 4)):
            try:
                value = frozen(getattr(self, key))
            except (TypeError, ValueError) as error:
                raise InvalidScene(f"{key} of box {self.name!r} is {getattr(self, key)!r}, not numbers") from error
            if value.shape != (length,) or not np.all(np.isfinite(value)):
                raise InvalidScene(
                    f"{key} of box {self.name!r} is {value.tolist()}; {length} finite numbers are needed"
                )
            object.__setattr__(self, key, tuple(value.tolist()) if key == "color" else value)
        if np.any(self.size <= 0):
            raise InvalidScene(f"size of box {self.name!r} is {self.size.tolist()}; every edge must be positive")
        norm = float(np.linalg.norm(self.orientation))
        if abs(norm - 1) > 1e-3:
            raise InvalidScene(f"orientation of box {self.name!r} has norm {norm:.6g}; a unit quaternion is needed")
        object.__setattr__(self, "orientation", frozen(self.orientation / norm))
        if not self.fixed and not (np.isfinite(self.mass) and self.mass > 0):
            raise InvalidScene(f"mass of box {self.name!r} is {self.mass!r} kg; it must be positive")

    @property
    def pose(self) -> Pose:
        """Pose of the centre."""
        return Pose(self.position, self.orientation)

    @cached_property
    def axes(self) -> Array:
        """(3, 3): the box's edges' directions in the world, in columns."""
        return frozen(matrix(self.orientation))

    @cached_property
    def half_extents(self) -> Array:
        """(3,) half the edges of the smallest upright box around it, along the world's axes, metres."""
        return frozen(np.abs(self.axes) @ self.size / 2)

    @property
    def bottom(self) -> float:
        """Lowest z, metres."""
        return float(self.position[2] - self.half_extents[2])

    @property
    def top(self) -> float:
        """Highest z, metres."""
        return float(self.position[2] + self.half_extents[2])

    @cached_property
    def footprint(self) -> Array:
        """(n, 2) convex outline seen from above, anticlockwise, metres."""
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        corners = self.position + (signs * self.size / 2) @ self.axes.T
        return frozen(hull(corners[:, :2]))

    @property
    def lean(self) -> float:
        """Angle by which no face is level, radians; 0 for a box that stands on a face."""
        return float(np.arccos(np.clip(np.max(np.abs(self.axes[2])), -1.0, 1.0)))

    @property
    def upright(self) -> Box:
        """The same box turned the least that makes a face level."""
        rising = self.axes[:, int(np.argmax(np.abs(self.axes[2])))]
        rising = rising * np.sign(rising[2])
        across = np.cross(rising, (0.0, 0.0, 1.0))
        norm = float(np.linalg.norm(across))
        if norm < 1e-12:
            return self
        return self.at(Pose.of(about(across / norm, self.lean) @ self.axes, self.position))

    def at(self, pose: Pose) -> Box:
        """The same box elsewhere."""
        return replace(self, position=pose.position, orientation=pose.orientation)


@dataclass(frozen=True, eq=False)
class Scene:
    """The boxes around the robot; the floor (z = 0) and the robot itself are always there.

    Attributes:
        boxes: in any order, with names that differ.
    """

    boxes: tuple[Box, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "boxes", tuple(self.boxes))
        seen: set[str] = set()
        for box in self.boxes:
            if not isinstance(box, Box):
                raise InvalidScene(f"a scene is made of Box values, not of {box!r}")
            if box.name in seen:
                raise InvalidScene(f"the name {box.name!r} is used by two boxes; names must differ")
            seen.add(box.name)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The boxes' names, in order."""
        return tuple(box.name for box in self.boxes)

    @property
    def poses(self) -> dict[str, Pose]:
        """The pose of every box, by name."""
        return {box.name: box.pose for box in self.boxes}

    def box(self, name: str) -> Box:
        """The box of that name.

        Raises:
            UnknownBody: there is none.
        """
        for box in self.boxes:
            if box.name == name:
                return box
        raise UnknownBody(str(name), self.names)

    def moved(self, poses: Mapping[str, Pose]) -> Scene:
        """The same boxes, those named in `poses` (and not fixed) elsewhere."""
        for name in poses:
            self.box(name)
        return Scene(
            tuple(box.at(poses[box.name]) if box.name in poses and not box.fixed else box for box in self.boxes)
        )

    def boxes_above(self, name: str) -> tuple[Box, ...]:
        """The boxes that rest on the box of that name, directly."""
        below = self.box(name)
        return tuple(
            box
            for box in self.boxes
            if box.name != name
            and not box.fixed
            and abs(box.bottom - below.top) <= 2 * RESTING_GAP
            and np.all(np.abs(box.position - below.position)[:2] <= (box.half_extents + below.half_extents)[:2])
            and overlap(box.footprint, below.footprint) > 1e-3
        )

    def below(self, name: str) -> frozenset[str]:
        """Names of the boxes, fixed ones too, that the box of that name rests on, directly."""
        box = self.box(name)
        return frozenset(
            other.name
            for other in self.boxes
            if other.name != name
            and abs(box.bottom - other.top) <= 2 * RESTING_GAP
            and np.all(np.abs(box.position - other.position)[:2] <= (box.half_extents + other.half_extents)[:2])
            and overlap(box.footprint, other.footprint) > 1e-3
        )

    def leaning_on(self, name: str) -> tuple[str, ...]:
        """Names of the loose boxes that lean and touch the box of that name: they would fall were it taken away."""
        box = self.box(name)
        return tuple(
            other.name
            for other in self.boxes
            if other.name != name
            and not other.fixed
            and other.lean > LEANING
            and other.bottom < box.top
            and box.bottom < other.top
            and overlap(other.footprint, box.footprint) > -RESTING_GAP
        )

    def resting_position(self, name: str, xy: ArrayLike, ignore: Sequence[str] = ()) -> Array:
        """The place of a box's centre when it rests, turned as it is, on whatever is highest below (x, y).

        Args:
            name: the box to be set down.
            xy: (2,) where, metres.
            ignore: names of boxes to look through.

        Returns:
            (3,) position of the centre, metres.

        Raises:
            InvalidGoal: nothing is there to rest on.
        """
        box = standing(self.box(name))
        point = np.asarray(xy, dtype=np.float64)
        if point.shape != (2,) or not np.all(np.isfinite(point)):
            raise InvalidGoal(f"a place on the table is two finite numbers, not {point.tolist()}", name)
        tops = [
            other.top
            for other in self.boxes
            if other.name != name and other.name not in ignore and contains(other.footprint, point)
        ]
        if not tops:
            raise InvalidGoal(f"nothing stands at ({point[0]:.3f}, {point[1]:.3f}) that {name!r} could rest on", name)
        return np.array([point[0], point[1], max(tops) + float(box.half_extents[2])])


def standing(box: Box) -> Box:
    """The box as it is put down: upright if it leans; what is level but for the noise of physics stays as it is."""
    return box.upright if box.lean > LEANING else box
