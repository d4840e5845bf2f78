"""Boxes in perspective: which of their faces are seen, in which order they are drawn, how much of each shows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from grounding.pictures.outlines import corners_of
from grounding.pictures.palette import INK, PAPER, Rgb, mixed
from grounding.pictures.perspective import Camera
from grounding.world import Array, WorldObject

_FACES = ((4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))  # of `corners_of`; the first is on top
_LIGHT = (-0.5, -0.3, 0.8)  # where light comes from: right of the camera, ahead of it, upward
TOP_PREFERRED = 1.5  # a face on top counts for so many times its pixels


@dataclass(frozen=True, eq=False)
class Face:
    """A face of a box that is turned to the camera.

    Attributes:
        pixels: its corners in order, shape (4, 2).
        light: share of the light that falls on it, in [0, 1].
        top: whether it is the upper one.
    """

    pixels: Array
    light: float
    top: bool

    def shade(self, color: Rgb) -> Rgb:
        """The colour that it shows."""
        return mixed(color, PAPER, 0.16) if self.top else mixed(color, INK, 0.4 - 0.28 * self.light)


def light_of(camera: Camera) -> Array:
    """The direction to the light, over the camera's left shoulder, a unit vector in the world's frame, shape (3,)."""
    right, ahead = camera.axes[0], np.array([camera.axes[2][0], camera.axes[2][1], 0.0])
    light = _LIGHT[0] * right + _LIGHT[1] * ahead / np.linalg.norm(ahead) + np.array([0.0, 0.0, _LIGHT[2]])
    return np.asarray(light / np.linalg.norm(light))


def faces_of(item: WorldObject, camera: Camera) -> list[Face]:
    """The faces of a box that are turned to the camera, the upper one last."""
    corners, light = corners_of(item), light_of(camera)
    found = []
    for face in _FACES:
        points = corners[list(face)]
        normal = points.mean(axis=0) - item.position
        normal /= np.linalg.norm(normal)
        if camera.faces(points.mean(axis=0), normal):
            found.append(Face(camera(points), float(max(0.0, normal @ light)), face == _FACES[0]))
    return found[::-1]


def back_to_front(items: Sequence[WorldObject], camera: Camera) -> list[WorldObject]:
    """The order in which boxes cover each other, exact for cubes of a size seen from above.

    What a ray from above meets first is higher or, on the same level, nearer.
    """

    def key(item: WorldObject) -> tuple[int, float, str]:
        away = float(np.linalg.norm(item.position[:2] - camera.position[:2]))
        return round(float(item.position[2] - item.half_extents[2]) * 100), -away, item.id

    return sorted(items, key=key)


def shadow_of(item: WorldObject, floor: float, light: Array) -> Array:
    """Where the corners of a box cast their shadows on a plane, shape (8, 3) in [m]."""
    corners = corners_of(item)
    return np.asarray(corners - (corners[:, 2:] - floor) / light[2] * light)


@dataclass(frozen=True, eq=False)
class Visible:
    """What is seen of one box.

    Attributes:
        share: of its pixels that nothing covers, in [0, 1].
        spot: the middle of what shows of its best face, shape (2,) in pixels.
        width: of what shows there, in pixels.
    """

    share: float
    spot: Array
    width: float


def visible(items: Sequence[WorldObject], camera: Camera, size: tuple[int, int]) -> dict[str, Visible]:
    """How much of each box shows, by id.

    Args:
        items: all boxes of the scene.
        camera: fitted to a picture.
        size: of that picture in pixels.
    """
    image = Image.new("I", size, 0)
    draw = ImageDraw.Draw(image)
    ordered = back_to_front(items, camera)
    shown = {item.id: faces_of(item, camera) for item in ordered}
    for number, item in enumerate(ordered):
        for side, face in enumerate(shown[item.id]):
            draw.polygon(_points(face.pixels), fill=1 + number * len(_FACES) + side)
    codes = np.asarray(image)
    return {item.id: _visible(codes, shown[item.id], number) for number, item in enumerate(ordered)}


def _visible(codes: np.ndarray, faces: Sequence[Face], number: int) -> Visible:
    """What is seen of a box, from the picture in which every pixel says whose face it shows."""
    pixels = np.concatenate([face.pixels for face in faces])
    left, top = np.maximum(np.floor(pixels.min(axis=0)).astype(int) - 2, 0)
    right, bottom = np.ceil(pixels.max(axis=0)).astype(int) + 3
    part = codes[top:bottom, left:right]
    alone = Image.new("1", (int(right - left), int(bottom - top)), 0)
    draw = ImageDraw.Draw(alone)
    total, best, spot, width = 0, 0.0, np.zeros(2), 0.0
    for side, face in enumerate(faces):
        draw.polygon(_points(face.pixels - (left, top)), fill=1)
        rows, columns = np.nonzero(part == 1 + number * len(_FACES) + side)
        total += len(rows)
        weight = len(rows) * (TOP_PREFERRED if face.top else 1.0)
        if weight > best:
            best, spot = weight, np.array([np.median(columns) + left, np.median(rows) + top])
            width = float(np.ptp(columns)) + 1
    return Visible(total / max(int(np.asarray(alone).sum()), 1), spot, width)


def _points(pixels: Array) -> list[tuple[float, float]]:
    return [(float(x), float(y)) for x, y in pixels]
