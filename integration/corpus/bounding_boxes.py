"""The image of an annotated example: its world, with boxes around the arrangements it speaks of and their members.

Boxes are in pixels of the image: left, top, right, bottom, of the whole object, whether or not something hides a part
of it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from PIL import Image

from grounding.corpus.format import Example
from grounding.pictures import Row, Sheet, draw_plan
from grounding.pictures.canvas import Canvas
from grounding.pictures.outlines import corners_of
from grounding.pictures.palette import INK, MARKS, PAPER, Rgb
from grounding.pictures.plan import View
from grounding.symbols import Action, Container, ObjectSymbol
from grounding.world import World
from integration.worlds_and_scenes import scene_of
from motion import Camera, Renderer, rendering_available

SIZE = (960, 560)  # of the view in pixels; title and legend make the image higher
_CAMERA = Camera(np.array([1.86, 0.0, 2.26]), np.array([0.60, 0.0, 0.84]), 34.5)
_TABLE = np.array([0.65, 0.0, 0.691])  # the centre of the table that `_CAMERA` suits, in [m]
_AROUND, _APART = 4.0, 5.0
_LABEL = 15
_OUTWARD = np.array([-1.0, -1.0, 1.0, 1.0])

Project = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Boxed:
    """Objects that a rectangle is drawn around.

    Attributes:
        role: "container" or "object" (what the whole instruction is about).
        kind: of the container, else "".
        objects: their ids.
        text: of the phrase that means them.
        color: of the rectangle.
    """

    role: str
    kind: str
    objects: tuple[str, ...]
    text: str
    color: Rgb


def pictured(example: Example, world: World) -> tuple[Image.Image, dict[str, Any]]:
    """The image of an example, and what the index tells of it.

    Args:
        example: whose containers and objects are boxed.
        world: that it is in.
    """
    boxed = boxed_of(example)
    rows = [Row(item.role, item.text, _told(item), "", item.color) for item in boxed]
    kind, view, project = _view(world)
    sheet = Sheet((view.width, view.height), example.instruction, rows)
    sheet.canvas.paste(view, (0, sheet.body[1]))
    below = np.array([0.0, sheet.body[1]])
    corners = {item.id: project(corners_of(item)) + below for item in world.things}
    limits = np.array(sheet.body, dtype=float)
    objects = {name: _box(points, limits) for name, points in corners.items()}
    boxes = []
    for item in boxed:
        inner = sum(set(other.objects) < set(item.objects) for other in boxed)
        boxes.append(_union([objects[name] for name in item.objects], _AROUND + _APART * (1 + inner), limits))
    for place in reversed(range(len(boxed))):  # what is meant is drawn last, over the rest
        _draw(sheet.canvas, boxed[place], boxes[place], [objects[name] for name in boxed[place].objects], place)
    if kind == "rendered":
        _sides(sheet)
    image = sheet.finished()
    symbols = [{"phrase": phrase.text, "tag": phrase.tag, "symbols": sorted(map(str, grounding))}
               for phrase, grounding in example.phrases]  # fmt: skip
    containers = [{"kind": item.kind, "objects": list(item.objects), "phrase": item.text, "box": _plain(box)}
                  for item, box in zip(boxed, boxes, strict=True) if item.role == "container"]  # fmt: skip
    meant = [name for item in boxed if item.role == "object" for name in item.objects]
    return image, {
        "id": example.id, "world": example.world, "instruction": example.instruction, "outcome": example.outcome,
        "view": kind, "size": [image.width, image.height],
        "objects": {name: _plain(box) for name, box in sorted(objects.items())},
        "containers": containers, "meant": meant, "symbols": symbols,
    }  # fmt: skip


def boxed_of(example: Example) -> tuple[Boxed, ...]:
    """The objects and arrangements that an image points out: those of the instruction as a whole first."""
    found: list[Boxed] = []
    root = example.groundings[0]
    meant = [symbol.objects for symbol in root if isinstance(symbol, Action) and symbol.objects]
    meant += [(symbol.id,) for symbol in root if isinstance(symbol, ObjectSymbol)]
    names = sorted({name for objects in meant for name in objects})
    if names:
        found.append(Boxed("object", "", tuple(names), example.tree.text, MARKS[0]))
    seen: dict[Container, str] = {}
    for phrase, grounding in example.phrases:
        for symbol in sorted(grounding, key=str):
            if isinstance(symbol, Container) and symbol.objects and symbol.kind != "robot":
                seen[symbol] = phrase.text  # the innermost phrase that means it
    for place, (container, text) in enumerate(seen.items()):
        color = MARKS[1 + place % (len(MARKS) - 1)]
        found.append(Boxed("container", container.kind, container.objects, text, color))
    return tuple(found)


def _view(world: World) -> tuple[str, Image.Image, Project]:
    """The world without marks, and from points, (n, 3) in [m], to pixels, (n, 2)."""
    if not rendering_available():
        plan = draw_plan(world, (), "", (), width=SIZE[0])
        top = Sheet((SIZE[0], 1), "").body[1]
        return "plan", plan, View(world, SIZE[0], top)
    table = next((item.position for item in world.objects if item.type == "table"), _TABLE)
    shift = table - _TABLE
    camera = Camera(_CAMERA.position + shift, _CAMERA.target + shift, _CAMERA.field_of_view)
    with Renderer(scene_of(world), *SIZE) as renderer:
        picture = Image.fromarray(renderer.render(None, camera))
        return "rendered", picture, lambda points: renderer.project(points, camera)


def _box(points: np.ndarray, limits: np.ndarray) -> np.ndarray:
    """(4,) left, top, right and bottom of points, inside the image; (n, 2) points may be behind the camera."""
    low, high = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    return np.clip([*low, *high], np.tile(limits[:2], 2), np.tile(limits[2:], 2))


def _union(boxes: Sequence[np.ndarray], around: float, limits: np.ndarray) -> np.ndarray:
    array = np.array(boxes)
    low, high = array[:, :2].min(axis=0) - around, array[:, 2:].max(axis=0) + around
    return np.clip([*low, *high], np.tile(limits[:2], 2), np.tile(limits[2:], 2))


def _draw(canvas: Canvas, item: Boxed, box: np.ndarray, members: Sequence[np.ndarray], place: int) -> None:
    """The rectangle of what is meant around each of its objects, or that of a container, with thin ones inside."""
    if item.role == "object":
        for member in members:
            _rectangle(canvas, member + 2 * _OUTWARD, item.color, 3.2)
        return
    for member in members:
        _rectangle(canvas, member + place * _OUTWARD, item.color, 1.2)
    _rectangle(canvas, box, item.color, 2.6)
    left, top, right, bottom = box
    corner, anchor = (((left + 2, top - 3), "lb"), ((right - 2, bottom + 3), "rt"), ((right - 2, top - 3), "rb"),
                      ((left + 2, bottom + 3), "lt"))[(place - 1) % 4]  # fmt: skip
    canvas.text(corner, f"{item.kind} of {len(members)}", _LABEL, item.color, anchor, PAPER)


def _rectangle(canvas: Canvas, box: np.ndarray, color: Rgb, width: float) -> None:
    left, top, right, bottom = box
    outline = [(left, top), (right, top), (right, bottom), (left, bottom)]
    canvas.polygon(outline, line=(*PAPER, 190), width=width + 2)
    canvas.polygon(outline, line=color, width=width)


def _sides(sheet: Sheet) -> None:
    """Writes which side is which for the robot, which faces the picture."""
    left, _, right, bottom = sheet.body
    sheet.canvas.text((left + 24, bottom - 20), "robot's right", _LABEL, INK, "lm", PAPER)
    sheet.canvas.text((right - 24, bottom - 20), "robot's left", _LABEL, INK, "rm", PAPER)


def _told(item: Boxed) -> str:
    names = " ".join(item.objects)
    return f"{item.kind}: {names}" if item.role == "container" else names


def _plain(box: np.ndarray) -> list[int]:
    return [int(value) for value in np.round(box)]
