"""Starts for inverse kinematics from a table: configurations whose tool is already close to the target.

The first joint turns the whole arm about a vertical axis and the last one the hand about its own. Both can be read off
the target, so the table need only cover the five joints between: where the wrist is (distance from the vertical axis
and height) and where the hand points, seen from the wrist's own azimuth, are four numbers. A k-d tree over twelve
thousand samples thus has starts within a few centimetres and degrees of any target, in many postures of the elbow.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from motion.poses import Array
from motion.robot.kinematics import ArmKinematics

SAMPLES = 12_000
NEIGHBOURS = 24
_TURN = 2 * math.pi
_BETWEEN = np.array([0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0])
_POINTING = 0.35
"""Metres that a radian of the hand's direction counts for when starts are looked up."""
_OUT_OF_RANGE = 0.3
"""Metres that a radian beyond a joint's range counts for when starts are ranked."""
_POSTURE = 0.04
"""Metres that a radian away from the wished posture counts for."""
_USUAL_POSTURE = 0.004
"""The same for the very first start, in square metres."""


class SeedTable:
    """The table of one arm.

    Args:
        kinematics: the arm.
        wrist: distance from the wrist's centre to the tool frame along the tool's z axis, metres.
        posture: (7,) joints that are usually preferred, radians: for them the first start is found more quickly.
        count: size of the table.
    """

    def __init__(self, kinematics: ArmKinematics, wrist: float, posture: Array, count: int = SAMPLES) -> None:
        samples = sampled_configurations(kinematics, wrist, count)
        base = kinematics.model.jointPlacements[1]
        self._turn, self._origin = np.array(base.rotation).T, np.array(base.translation)
        self._lower, self._upper = kinematics.lower, kinematics.upper
        self._wrist = wrist
        self._joints, self._azimuth = samples["joints"], samples["azimuth"]
        self._low0, self._high0 = float(self._lower[0]), float(self._upper[0])
        self._low6, self._high6 = float(self._lower[6]), float(self._upper[6])
        self._x, self._y = samples["x"], samples["y"]
        self._tree = cKDTree(samples["features"], balanced_tree=False, compact_nodes=False)
        # |f - g|² + c |q - p| over all rows, but for |f|²: one product of a vector and a matrix, quicker than the tree.
        features = samples["features"].astype(np.float32)
        away = np.abs(self._joints - posture).dot(_BETWEEN)
        self._usual = posture
        self._columns = np.ascontiguousarray(-2.0 * features.T)
        self._offsets = (np.sum(features**2, axis=1) + _USUAL_POSTURE * away).astype(np.float32)

    def starts(self, position: Array, rotation: Array, posture: Array, count: int = NEIGHBOURS) -> Iterator[Array]:
        """Joints (7,) within their ranges, the most promising first.

        Args:
            position: (3,) of the tool frame in the world's frame, metres.
            rotation: (3, 3) of the tool frame.
            posture: (7,) joints that are preferred where it makes no difference, radians.
            count: how many starts there shall be.
        """
        turned = self._turn.dot(rotation)
        (ax, _, dx), (ay, _, dy), (az, _, dz) = turned.tolist()
        x, y, z = self._turn.dot(position - self._origin).tolist()
        x, y, z = x - self._wrist * dx, y - self._wrist * dy, z - self._wrist * dz
        azimuth = math.atan2(y, x)
        cosine, sine = math.cos(azimuth), math.sin(azimuth)
        features = (
            math.hypot(x, y), z,
            _POINTING * (cosine * dx + sine * dy), _POINTING * (cosine * dy - sine * dx), _POINTING * dz,
        )  # fmt: skip
        side = (cosine * ax + sine * ay, cosine * ay - sine * ax, az)
        chosen = -1
        if posture is self._usual:  # in nine of ten cases no other start is asked for
            costs = np.dot(np.array(features, np.float32), self._columns)
            costs += self._offsets
            row = int(costs.argmin())
            first = _wrapped(azimuth - float(self._azimuth[row]))
            last = math.atan2(_dot(self._y[row].tolist(), side), _dot(self._x[row].tolist(), side))
            if self._low0 <= first <= self._high0 and self._low6 <= last <= self._high6:
                start, chosen = self._joints[row].copy(), row
                start[0], start[6] = first, last
                yield start
        distances, found = self._tree.query(features, count)
        joints = self._joints.take(found, axis=0)
        cost = np.abs(joints - posture).dot(_BETWEEN)
        cost *= _POSTURE
        cost += distances
        joints[:, 0] = _wrapped(azimuth - self._azimuth.take(found))
        across = np.array(side)
        joints[:, 6] = np.arctan2(self._y.take(found, axis=0).dot(across), self._x.take(found, axis=0).dot(across))
        clipped = np.minimum(np.maximum(joints, self._lower), self._upper)
        cost += _OUT_OF_RANGE * np.abs(joints - clipped).sum(axis=1)
        for index in cost.argsort().tolist():
            if found[index] != chosen:
                yield clipped[index]


def sampled_configurations(kinematics: ArmKinematics, wrist: float, count: int) -> dict[str, Any]:
    """Evenly spread configurations with the first and last joint at 0, and where they bring wrist and hand.

    Returns:
        `joints` (n, 7), `azimuth` (n,) of the wrist about the first joint's axis, and seen from that azimuth: `x` and
        `y` (n, 3), the hand's axes, and `features` (n, 5), by which starts are looked up.
    """
    # An additive recurrence with powers of the generalised golden ratio (Roberts, 2018) covers five joints evenly.
    ratio = _golden(5)
    spread = (0.5 + np.arange(1, count + 1)[:, None] * ratio ** -np.arange(1.0, 6.0)) % 1.0
    joints = np.zeros((count, 7))
    joints[:, 1:6] = kinematics.lower[1:6] + spread * (kinematics.upper - kinematics.lower)[1:6]
    base = kinematics.model.jointPlacements[1]
    position, rotation = kinematics.poses(joints)
    rotation = np.array(base.rotation).T @ rotation
    centre = (position - base.translation) @ base.rotation - wrist * rotation[:, :, 2]
    azimuth = np.arctan2(centre[:, 1], centre[:, 0])
    cosine, sine = np.cos(azimuth)[:, None], np.sin(azimuth)[:, None]
    x, y, z = rotation[:, 0], rotation[:, 1], rotation[:, 2]
    seen = np.stack([cosine * x + sine * y, cosine * y - sine * x, z], axis=1)
    features = np.column_stack([np.hypot(centre[:, 0], centre[:, 1]), centre[:, 2], _POINTING * seen[:, :, 2]])
    x, y = np.ascontiguousarray(seen[:, :, 0]), np.ascontiguousarray(seen[:, :, 1])
    return {"joints": joints, "azimuth": azimuth, "x": x, "y": y, "features": features}


def _golden(dimensions: int) -> float:
    """The root above 1 of x^(d + 1) = x + 1."""
    root = 1.0
    for _ in range(64):
        root = (1.0 + root) ** (1.0 / (dimensions + 1))
    return root


def _wrapped(angle: Any) -> Any:
    """The angle, a number or an array, in [-pi, pi)."""
    return (angle + math.pi) % _TURN - math.pi


def _dot(first: list[float], second: tuple[float, float, float]) -> float:
    return first[0] * second[0] + first[1] * second[1] + first[2] * second[2]
