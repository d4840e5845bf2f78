"""A scene as the person sees it who writes about it: table, robot and blocks in perspective, with marks or numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from grounding.pictures.boxes import back_to_front, faces_of, light_of, shadow_of, visible
from grounding.pictures.canvas import Canvas
from grounding.pictures.figure import draw_robot, robot_boxes
from grounding.pictures.outlines import convex_hull, corners_of
from grounding.pictures.palette import EDGE, GROUND, INK, PAPER, TABLE, Rgb, color_of, legible_on, mixed
from grounding.pictures.perspective import Camera, camera_of
from grounding.world import Array, World, WorldObject

SIZE = (1200, 700)
"""Width and height in pixels."""

_MARGINS = (24.0, 84.0, 1176.0, 640.0)  # left, top, right, bottom of what is drawn in perspective
_GHOST = 205  # opacity of a block that is to be there, of 255
_PALE = 0.55  # how far its colour fades
_ARROW = 64.0  # length in pixels
_TURNS = (0.0, 0.5, -0.5, 0.95, -0.95)  # of the arrow from straight down, in [rad]
_NUMBER = 15.0  # size of the largest numbers
_SELF = 'the WRITER ("me") sits here, across from the robot, and sees the table like this'
_BEHIND = 'the WRITER ("me") stands behind the robot and sees the table as the robot does'


@dataclass(frozen=True, eq=False)
class Marks:
    """What is marked in a scene.

    Attributes:
        target: id of the block that an arrow points at.
        destination: centre of where it shall go, (3,) in [m], or None.
        title: above the picture.
    """

    target: str
    destination: tuple[float, float, float] | None = None
    title: str = ""


def scene_camera(world: World) -> Camera:
    """The camera of the writer, fitted to the picture."""
    camera = camera_of(world)
    shown = [corners_of(item) for item in (*(o for o in world.objects if o.type == "table"), *robot_boxes())]
    return camera.fitted(np.concatenate(shown), _MARGINS)


def draw_seen(world: World, marks: Marks | None = None, numbered: bool = False) -> Image.Image:
    """Draw a scene as its writer sees it.

    Args:
        world: with a table; with a speaker it is drawn from the speaker's seat, otherwise from behind the robot.
        marks: an arrow and a translucent block, or None.
        numbered: whether each block bears the number of its id.

    Returns:
        the picture, of `SIZE`.
    """
    canvas = Canvas(*SIZE, GROUND)
    camera = scene_camera(world)
    far_robot = world.speaker is not None
    if far_robot:
        draw_robot(canvas, camera)
    _draw_table(canvas, camera, world)
    if not far_robot:
        draw_robot(canvas, camera)
    ghost = None
    if marks is not None and marks.destination is not None:
        ghost = _ghost(world, world[marks.target], marks.destination)
    items = [*world.things] if ghost is None else [*world.things, ghost]
    for item in back_to_front(items, camera):
        if item.id:
            _draw_block(canvas, camera, item)
        else:
            _draw_ghost(canvas, camera, item)
    if numbered:
        _write_numbers(canvas, camera, world.things)
    if marks is not None:
        _point_at(canvas, camera, world[marks.target], [item for item in items if item.id != marks.target])
        canvas.text((SIZE[0] / 2, 26), marks.title, 19, INK, "mm")
    canvas.text((SIZE[0] / 2, SIZE[1] - 22), _SELF if far_robot else _BEHIND, 17, INK, "mm")
    return canvas.finished()


def _ghost(world: World, item: WorldObject, place: tuple[float, float, float]) -> WorldObject:
    """The block where it shall be, turned as what it stands on, with no id."""
    under = (other for other in world.things if np.allclose(other.position[:2], place[:2], atol=1e-3))
    below = [other for other in under if other.position[2] < place[2]]
    turn = max(below, key=lambda other: float(other.position[2])).orientation if below else (1.0, 0.0, 0.0, 0.0)
    there = item.moved(place, turn)
    return WorldObject("", item.type, item.color, there.position, there.orientation, item.size)


def _draw_table(canvas: Canvas, camera: Camera, world: World) -> None:
    for table in (item for item in world.objects if item.type == "table"):
        for face in faces_of(table, camera):
            canvas.polygon(face.pixels, fill=TABLE if face.top else mixed(EDGE, INK, 0.25), line=INK, width=1.5)
        floor = float(table.position[2] + table.half_extents[2])
        for item in world.things:
            shadow = convex_hull(camera(shadow_of(item, floor, light_of(camera))))
            canvas.polygon(shadow, fill=mixed(TABLE, INK, 0.16))


def _draw_block(canvas: Canvas, camera: Camera, item: WorldObject) -> None:
    color = color_of(item.color)
    line = mixed(color, INK, 0.7)
    for face in faces_of(item, camera):
        canvas.polygon(face.pixels, fill=face.shade(color), line=line, width=1)


def _draw_ghost(canvas: Canvas, camera: Camera, item: WorldObject) -> None:
    color = color_of(item.color)
    for face in faces_of(item, camera):
        canvas.polygon(face.pixels, fill=(*mixed(face.shade(color), PAPER, _PALE), _GHOST))
        canvas.dashed(np.concatenate([face.pixels, face.pixels[:1]]), INK, 1.5, 4, 3)


def _point_at(canvas: Canvas, camera: Camera, item: WorldObject, others: Sequence[WorldObject]) -> None:
    """An arrow from above to the middle of a block's upper face, from where it hides the least of the others."""
    tip = camera(item.position + np.array([0.0, 0.0, float(item.half_extents[2])]))
    hidden = _covered(camera, others)
    turn = min(_TURNS, key=lambda turn: _hides(hidden, tip, turn))
    ahead = np.array([np.sin(turn), np.cos(turn)])
    across = np.array([-ahead[1], ahead[0]])
    neck, start = tip - 17 * ahead, tip - _ARROW * ahead
    head = [tip, neck + 8 * across, neck - 8 * across]
    for color, width in ((PAPER, 9.0), (INK, 4.5)):
        canvas.line([start, neck], color, width)
        canvas.polygon(head, fill=color, line=color, width=4 if color == PAPER else 1)


def _covered(camera: Camera, items: Sequence[WorldObject]) -> np.ndarray:
    """Which pixels show some of the boxes, shape (height, width)."""
    image = Image.new("1", SIZE, 0)
    draw = ImageDraw.Draw(image)
    for item in items:
        draw.polygon([(float(x), float(y)) for x, y in convex_hull(camera(corners_of(item)))], fill=1)
    return np.asarray(image)


def _hides(covered: np.ndarray, tip: Array, turn: float) -> float:
    """Pixels of others that an arrow would hide, and a little for not coming straight from above."""
    along = np.arange(6.0, _ARROW)[:, None] * np.array([np.sin(turn), np.cos(turn)])
    columns, rows = np.clip(np.round(tip - along), 0, np.array(SIZE) - 1).astype(int).T
    return float(covered[rows, columns].sum()) + 4.0 * abs(turn)


def _write_numbers(canvas: Canvas, camera: Camera, items: Sequence[WorldObject]) -> None:
    shown = visible(items, camera, SIZE)
    for item in items:
        found = re.search(r"\d+$", item.id)
        text = found.group() if found else item.id
        color: Rgb = color_of(item.color)
        ink = legible_on(color)
        size = _NUMBER if len(text) < 2 else _NUMBER - 1
        canvas.text(shown[item.id].spot, text, size, ink, "mm", mixed(color, PAPER if ink == INK else INK, 0.25))
