"""Figures as pictures: panels side by side under the instruction, each with its phrase above it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from PIL import Image

from grounding.experiments.panels import Figure, Panel
from grounding.pictures import Canvas, Row, draw_plan
from grounding.pictures.canvas import wrapped
from grounding.pictures.palette import EDGE, FAINT, INK

PANEL = 860  # width of a panel in pixels
_GAP = 26
_MARGIN = 34
_TITLE, _LINE = 34, 44
_SAID, _SAID_LINE, _INDENT = 25, 32, 28
_NOTE = 16


def draw_figure(figure: Figure) -> Image.Image:
    """The phrases of a figure over plans of its world, seen from above."""
    panels = figure.panels or (nothing(figure),)
    return on_sheet(replace(figure, panels=panels), [plan_of(figure, panel) for panel in panels])


def nothing(figure: Figure) -> Panel:
    """The panel of an instruction of whose phrases none means anything among the objects."""
    return Panel(figure.title, "", (), (Row("failed", "nothing among the objects is meant"),))


def on_sheet(figure: Figure, panels: Sequence[Image.Image]) -> Image.Image:
    """Put the pictures of a figure's panels on one sheet, in rows of two, each under its phrase.

    Args:
        figure: its instruction stands above, its note below.
        panels: of equal width, in the order of `figure.panels`.
    """
    across = 1 if len(panels) == 1 else 2
    width = max((panel.width for panel in panels), default=PANEL)
    rows = [range(i, min(i + across, len(panels))) for i in range(0, len(panels), across)]
    captions = [_caption(panel, i, width) for i, panel in enumerate(figure.panels)]
    above = [16 + _SAID_LINE * max(len(captions[i]) for i in row) for row in rows]
    below = [max(panels[i].height for i in row) for row in rows]
    total = 2 * _MARGIN + across * width + (across - 1) * _GAP
    lines = wrapped(f"“{figure.title}”", _TITLE, total - 2 * _MARGIN)
    y = 24 + _LINE * len(lines) + 14
    notes = wrapped(figure.note, _NOTE, total - 2 * _MARGIN)
    canvas = Canvas(total, y + sum(above) + sum(below) + _GAP * len(rows) + 14 + 22 * len(notes))
    for i, line in enumerate(lines):
        canvas.text((_MARGIN, 24 + _LINE * (i + 0.5)), line, _TITLE, INK, "lm")
    for row, top, height in zip(rows, above, below, strict=True):
        for i in row:
            x = _MARGIN + (i % across) * (width + _GAP)
            for k, line in enumerate(captions[i]):
                canvas.text((x + _INDENT, y + 10 + _SAID_LINE * (k + 0.5)), line, _SAID, INK, "lm")
            canvas.paste(panels[i], (x, y + top))
            frame = [(x, y), (x + width, y), (x + width, y + top + height), (x, y + top + height)]
            canvas.polygon(frame, line=EDGE, width=1)
        y += top + height + _GAP
    for i, line in enumerate(notes):
        canvas.text((_MARGIN, y + 4 + 22 * i), line, _NOTE, FAINT, "lm")
    return canvas.finished()


def plan_of(figure: Figure, panel: Panel) -> Image.Image:
    """One phrase over the plan of its world."""
    return draw_plan(figure.world, panel.marks, "", panel.rows, width=PANEL)


def _caption(panel: Panel, place: int, width: int) -> list[str]:
    return wrapped(f"({chr(ord('a') + place)})  {panel.tag}  “{panel.text}”", _SAID, width - 2 * _INDENT)
