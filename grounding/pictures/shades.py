"""Small plans side by side, in each of which every object is as strong as it weighs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from PIL import Image

from grounding.pictures.canvas import Canvas, shortened
from grounding.pictures.labels import name_beside
from grounding.pictures.outlines import convex_hull, corners_of, outline_of, rounded_hull
from grounding.pictures.palette import EDGE, FAINT, INK, MARKS, PAPER, TABLE, Rgb, color_of, mixed
from grounding.pictures.plan import WIDTH, View, drawing_order
from grounding.pictures.sheet import Row, Sheet
from grounding.world import World

_COLUMNS = 3
_MARGIN = 28
_GAP = 20
_HEAD = 30
_FOOT = 28
_AROUND = 0.05  # free space around the objects, in [m]
_NARROWEST = 0.45  # what a panel shows at least, in [m]
_TALLEST = 1.1  # height of a panel over its width
_FADED = 0.86  # how far an object of weight 0 fades into the table
_NAMED = 0.05  # objects of this weight and more are labelled
_MOST_NAMED = 6
_RING = 4.0


@dataclass(frozen=True)
class Panel:
    """One small plan.

    Attributes:
        title: above it, such as a phrase.
        weights: of objects by id, in [0, 1]; the heavier the stronger, those that are missing fade.
        note: below it.
        ringed: ids of objects that are ringed.
        color: of rings and title.
        labels: texts by id in place of the weights.
    """

    title: str
    weights: Mapping[str, float]
    note: str = ""
    ringed: tuple[str, ...] = ()
    color: Rgb = INK
    labels: Mapping[str, str] = field(default_factory=dict)


class CloseView(View):
    """As `View`, but only the things and what is around them."""

    def __init__(self, world: World, width: int, top: float = 0.0) -> None:
        super().__init__(world, width, top)
        points = np.concatenate([outline_of(item) for item in world.things] or [np.array([[0.5, 0.0]])])
        low, high = points.min(axis=0) - _AROUND, points.max(axis=0) + _AROUND
        tallest = max((float(item.position[2] + item.half_extents[2]) for item in world.things), default=self.floor)
        high[0] += 0.4 * max(tallest - self.floor, 0.0)
        missing = np.maximum(_NARROWEST - (high - low), 0.0) * [0.5, 1.0]
        low, high = low - missing / 2, high + missing / 2
        span = high - low
        self.scale = width / float(max(span[1], span[0] / _TALLEST))
        self.height = round(float(span[0]) * self.scale)
        middle = float(low[1] + high[1]) / 2
        self._corner = np.array([middle + width / self.scale / 2, high[0]])


def draw_panels(
    world: World, panels: Sequence[Panel], title: str = "", rows: Sequence[Row] = (), note: str = "", width: int = WIDTH
) -> Image.Image:
    """Draw small plans side by side, the robot below each of them.

    Args:
        world: what is drawn.
        panels: in reading order.
        title: above all.
        rows: of the legend below.
        note: in small print below that.
        width: of the picture in pixels.

    Returns:
        the picture.
    """
    columns = max(1, min(_COLUMNS, len(panels)))
    wide = (width - 2 * _MARGIN - (columns - 1) * _GAP) // columns
    tall = CloseView(world, wide).height + _HEAD + _FOOT
    lines = -(-len(panels) // columns)
    sheet = Sheet((width, lines * (tall + _GAP) + _GAP), title, rows, note)
    for place, panel in enumerate(panels):
        left = _MARGIN + place % columns * (wide + _GAP)
        top = sheet.body[1] + _GAP + place // columns * (tall + _GAP)
        sheet.canvas.paste(_panel(world, panel, wide, tall), (left, top))
    return sheet.finished()


def _panel(world: World, panel: Panel, width: int, height: int) -> Image.Image:
    canvas = Canvas(width, height, PAPER)
    view = CloseView(world, width, _HEAD)
    right, bottom = width - 1, height - _FOOT
    canvas.polygon([(1, _HEAD), (right, _HEAD), (right, bottom), (1, bottom)], fill=TABLE, line=EDGE)
    canvas.text((2, _HEAD / 2 - 2), shortened(panel.title, 17, width - 4), 17, panel.color, "lm")
    if panel.note:
        canvas.text((2, height - _FOOT / 2), shortened(panel.note, 14, width - 4), 14, FAINT, "lm")
    things = sorted(world.things, key=drawing_order)
    corners = {item.id: view(corners_of(item)) for item in things}
    for item in things:
        weight = float(np.clip(panel.weights.get(item.id, 0.0), 0.0, 1.0))
        color = mixed(color_of(item.color), TABLE, _FADED * (1.0 - weight))
        line = mixed(mixed(INK, TABLE, 0.2), TABLE, 0.7 * (1.0 - weight))
        canvas.polygon(convex_hull(corners[item.id]), fill=mixed(color, INK, 0.25 * weight), line=line, width=1)
        order = np.argsort(corners_of(item)[:, 2], kind="stable")
        canvas.polygon(convex_hull(corners[item.id][order[4:]]), fill=color, line=line, width=1)
    for name in panel.ringed:
        if name in corners:
            canvas.polygon(rounded_hull(corners[name], _RING), line=PAPER, width=6)
            canvas.polygon(rounded_hull(corners[name], _RING), line=MARKS[0], width=3)
    heavy = sorted((name for name in corners if panel.weights.get(name, 0.0) >= _NAMED),
                   key=lambda name: (-panel.weights[name], name))[:_MOST_NAMED]  # fmt: skip
    texts = {name: panel.labels.get(name, f"{name} {panel.weights[name]:.2f}") for name in heavy}
    name_beside(canvas, heavy, corners, texts, (2, _HEAD + 2, right - 1, bottom - 2))
    return canvas.finished()
