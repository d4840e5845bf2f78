"""Figures as pictures: panels side by side under the instruction, each with its phrase above it."""

from __future__ import annotations

from collections.abc import Sequence

from PIL import Image

from grounding.experiments.panels import Figure, Panel
from grounding.pictures import Canvas, draw_plan
from grounding.pictures.canvas import shortened, wrapped
from grounding.pictures.palette import EDGE, FAINT, INK

PANEL = 860  # width of a panel in pixels
_GAP = 26
_MARGIN = 34
_TITLE, _LINE = 34, 44
_NOTE = 16


def draw_figure(figure: Figure) -> Image.Image:
    """The phrases of a figure over plans of its world, seen from above."""
    return on_sheet(figure, [_plan(figure, panel, place) for place, panel in enumerate(figure.panels)])


def caption(panel: Panel, place: int) -> str:
    """The letter and the words of a panel."""
    return f"({chr(ord('a') + place)})  {panel.tag}  “{panel.text}”"


def on_sheet(figure: Figure, panels: Sequence[Image.Image]) -> Image.Image:
    """Put the pictures of panels on one sheet, in rows of two, with the instruction above and the note below."""
    across = 1 if len(panels) == 1 else 2
    width = max((panel.width for panel in panels), default=PANEL)
    rows = [panels[i : i + across] for i in range(0, len(panels), across)]
    heights = [max(panel.height for panel in row) for row in rows]
    total = 2 * _MARGIN + across * width + (across - 1) * _GAP
    lines = wrapped(f"“{figure.title}”", _TITLE, total - 2 * _MARGIN)
    top = 24 + _LINE * len(lines) + 14
    canvas = Canvas(total, top + sum(heights) + _GAP * len(rows) + 34)
    for i, line in enumerate(lines):
        canvas.text((_MARGIN, 24 + _LINE * (i + 0.5)), line, _TITLE, INK, "lm")
    y = top
    for row, height in zip(rows, heights, strict=True):
        for i, panel in enumerate(row):
            x = _MARGIN + i * (width + _GAP)
            canvas.paste(panel, (x, y))
            frame = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
            canvas.polygon(frame, line=EDGE, width=1)
        y += height + _GAP
    canvas.text((_MARGIN, y + 4), shortened(figure.note, _NOTE, total - 2 * _MARGIN), _NOTE, FAINT, "lm")
    return canvas.finished()


def _plan(figure: Figure, panel: Panel, place: int) -> Image.Image:
    return draw_plan(figure.world, panel.marks, caption(panel, place), panel.rows, width=PANEL)
