"""A world seen from above, the robot at the bottom, with the marks of a grounding."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike
from PIL import Image

from grounding.pictures.canvas import Canvas
from grounding.pictures.labels import name_beside, name_on
from grounding.pictures.marks import Mark
from grounding.pictures.outlines import convex_hull, corners_of, outline_of, rounded_hull
from grounding.pictures.overlay import draw_areas, draw_destinations, draw_marks
from grounding.pictures.palette import EDGE, FAINT, GROUND, INK, PAPER, ROBOT, TABLE, color_of, mixed
from grounding.pictures.sheet import Row, Sheet, mark_rows
from grounding.world import FURNITURE, Array, World, WorldObject

WIDTH = 1280
_RISE = 0.40  # how far height shifts what is drawn, as a share of it: enough to see what stands on what
_AROUND = 0.06  # free space around everything, in [m]
_NEAREST = 0.06  # the picture begins so far before the robot's base, in [m]
_SHOULDERS = {"left": (0.10, 0.26), "right": (0.10, -0.26)}


class View:
    """From the world to the pixels of a plan: x is up, y is to the left, and higher things are shifted up.

    Args:
        world: all of whose objects shall be seen.
        width: of the picture in pixels.
        top: where the picture begins on its canvas, in pixels.
    """

    def __init__(self, world: World, width: int = WIDTH, top: float = 0.0) -> None:
        tables = [item for item in world.objects if item.type == "table"]
        self.floor = max((float(t.position[2] + t.half_extents[2]) for t in tables), default=0.0)
        if not tables and world.things:
            self.floor = min(float(item.position[2] - item.half_extents[2]) for item in world.things)
        shown = [item for item in world.objects if item.type not in ("robot", "floor")]
        points = np.concatenate([outline_of(item) for item in shown] or [np.array([[0.3, -0.9], [1.0, 0.9]])])
        low = np.minimum(points.min(axis=0), [-_NEAREST, -0.45]) - [0, _AROUND]
        high = np.maximum(points.max(axis=0), [0.6, 0.45]) + _AROUND
        self.scale = width / float(high[1] - low[1])
        self.height = round(float(high[0] - low[0]) * self.scale)
        self._corner = np.array([high[1], high[0]])
        self._top = top

    def __call__(self, points: ArrayLike) -> Array:
        """Pixels (n, 2) of points (n, 3) in [m]."""
        x, y, z = np.asarray(points, dtype=float).reshape(-1, 3).T
        lifted = x + _RISE * (z - self.floor)
        return np.column_stack([self._corner[0] - y, self._corner[1] - lifted]) * self.scale + [0, self._top]


def draw_plan(
    world: World,
    marks: Sequence[Mark] = (),
    title: str = "",
    rows: Sequence[Row] | None = None,
    note: str = "",
    hands: Mapping[str, ArrayLike] | None = None,
    width: int = WIDTH,
) -> Image.Image:
    """Draw a world from above.

    Args:
        world: what is drawn.
        marks: what is pointed out.
        title: above the plan, such as the instruction.
        rows: the legend; by default that of the marks.
        note: in small print below.
        hands: where the robot's hands are that hold something, (3,) in [m], by "left" and "right".
        width: of the picture in pixels.

    Returns:
        the picture.
    """
    view = View(world, width)
    sheet = Sheet((width, view.height), title, mark_rows(marks) if rows is None else rows, note)
    view = View(world, width, sheet.body[1])
    canvas = sheet.canvas
    left, top, right, bottom = sheet.body
    canvas.polygon([(left, top), (right, top), (right, bottom), (left, bottom)], fill=GROUND)
    for item in world.objects:
        if item.type == "table":
            _draw_table(canvas, view, item)
    _draw_robot(canvas, view)
    _draw_sides(canvas, sheet.body)
    things = sorted((item for item in world.objects if item.type not in FURNITURE), key=drawing_order)
    corners = {item.id: view(corners_of(item)) for item in things}
    draw_areas(canvas, marks, corners)
    covered = {item.id for item in things if any(_covers(other, item) for other in things)}
    name_beside(canvas, [i.id for i in things if not _draw_object(canvas, view, i, i.id not in covered)], corners)
    if world.speaker is not None:
        _draw_speaker(canvas, view, world.speaker.position, world.speaker.yaw, sheet.body)
    for arm, hand in sorted((hands or {}).items()):
        _draw_hand(canvas, view, arm, np.asarray(hand, dtype=float))
    draw_marks(canvas, marks, corners)
    draw_destinations(canvas, marks, corners, view)
    return sheet.finished()


def drawing_order(item: WorldObject) -> tuple[float, float, str]:
    """Lower objects are drawn before those that stand on them, farther ones before nearer ones."""
    return round(float(item.position[2]), 3), -float(item.position[0]), item.id


def _covers(upper: WorldObject, lower: WorldObject) -> bool:
    """Whether one object stands so over another that a name on the lower one could not be read."""
    apart = np.abs(upper.position - lower.position)
    return bool(upper.position[2] > lower.position[2] + 0.01 and (apart[:2] < 0.75 * lower.half_extents[:2]).all())


def _draw_table(canvas: Canvas, view: View, table: WorldObject) -> None:
    corners = corners_of(table)
    canvas.polygon(rounded_hull(view(corners[4:]), 3), fill=mixed(EDGE, GROUND, 0.3))
    canvas.polygon(view(corners[4:]), fill=TABLE, line=EDGE, width=1.5)


def _draw_robot(canvas: Canvas, view: View) -> None:
    ground = view.floor
    angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    torso = np.column_stack([0.06 + 0.10 * np.cos(angles), 0.30 * np.sin(angles), np.full(60, ground)])
    canvas.polygon(view(torso), fill=mixed(ROBOT, PAPER, 0.55), line=mixed(ROBOT, PAPER, 0.2), width=1.5)
    for x, y in _SHOULDERS.values():
        place = view([[x, y, ground]])[0]
        canvas.circle(place, 0.045 * view.scale, mixed(ROBOT, PAPER, 0.3), mixed(ROBOT, PAPER, 0.1), 1.5)
    canvas.text(view([[0.06, 0, ground]])[0], "robot", 16, INK, "mm")


def _draw_sides(canvas: Canvas, body: tuple[float, float, float, float]) -> None:
    left, _, right, bottom = body
    canvas.text((left + 24, bottom - 20), "robot's left", 15, FAINT, "lm")
    canvas.text((right - 24, bottom - 20), "robot's right", 15, FAINT, "rm")


def _draw_object(canvas: Canvas, view: View, item: WorldObject, named: bool) -> bool:
    """Draws an object; False where its name is wanted but has no room on it."""
    color = color_of(item.color)
    corners = corners_of(item)
    order = np.argsort(corners[:, 2], kind="stable")
    upper = view(corners[order[4:]])
    side = mixed(color, INK, 0.35)
    shade = corners.copy()
    shade[:, 2] = min(view.floor, float(corners[:, 2].min()))
    canvas.polygon(convex_hull(view(shade)) + np.array([2.5, 3.0]), fill=(0, 0, 0, 34))
    canvas.polygon(convex_hull(view(corners)), fill=side, line=mixed(color, INK, 0.55), width=1)
    top = convex_hull(upper)
    canvas.polygon(top, fill=color, line=mixed(color, INK, 0.45), width=1)
    return not named or name_on(canvas, item.id, upper, color)


def _draw_hand(canvas: Canvas, view: View, arm: str, hand: Array) -> None:
    shoulder = _SHOULDERS[arm]
    elbow = (0.45 * hand[0], hand[1] * 0.6 + (0.22 if arm == "left" else -0.22))
    joints = view(np.array([[*shoulder, view.floor], [*elbow, view.floor], hand.tolist()]))
    ahead = joints[2] - joints[1]
    ahead = ahead / max(float(np.linalg.norm(ahead)), 1e-9)
    across = np.array([-ahead[1], ahead[0]])
    wrist = joints[2] - 34 * ahead
    for width, color in ((17.0, mixed(ROBOT, PAPER, 0.1)), (13.0, mixed(ROBOT, PAPER, 0.5))):
        canvas.line([joints[0], joints[1], wrist], (*color, 235), width)
    for sign in (-1, 1):
        finger = wrist + sign * 23 * across
        canvas.line([wrist, finger, finger + 40 * ahead], PAPER, 7.5)
        canvas.line([wrist, finger, finger + 40 * ahead], mixed(ROBOT, INK, 0.5), 4.5)


def _draw_speaker(
    canvas: Canvas, view: View, position: Array, yaw: float, body: tuple[float, float, float, float]
) -> None:
    place = view([[position[0], position[1], view.floor]])[0]
    place = np.clip(place, [body[0] + 40, body[1] + 28], [body[2] - 40, body[3] - 28])
    look = np.array([-np.sin(yaw), -np.cos(yaw)])
    canvas.line([place, place + 22 * look], FAINT, 3)
    canvas.circle(place, 11, PAPER, FAINT, 2.5)
    canvas.text(place + np.array([18, 0]), "speaker", 15, FAINT, "lm", PAPER)
