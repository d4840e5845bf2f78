"""A sheet: the title on top, the picture below it, and under that a legend of rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image

from grounding.pictures.canvas import Canvas, shortened, text_width, wrapped
from grounding.pictures.marks import Mark
from grounding.pictures.palette import EDGE, FAILED, FAINT, INK, PAPER, PASSED, Rgb, mixed

_MARGIN = 28
_TITLE = 27
_LINE = 34
_ROW = 30
_TEXT = 17
_NOTE = 14


@dataclass(frozen=True)
class Row:
    """A line of a legend.

    Attributes:
        sign: "object", "container", "region", "passed" or "failed".
        text: in `color`.
        detail: in grey behind it.
        value: at the right end.
        color: red, green, blue.
    """

    sign: str
    text: str
    detail: str = ""
    value: str = ""
    color: Rgb = INK


def mark_rows(marks: Sequence[Mark]) -> tuple[Row, ...]:
    """The legend of a picture's marks: phrase, meaning, probability."""
    return tuple(Row(m.role, m.text, m.meaning, f"{m.probability:.2f}", m.color) for m in marks)


class Sheet:
    """A picture with its title and legend.

    Args:
        size: width and height of the body in pixels; the sheet is as wide and as much higher as title and legend need.
        title: at most two lines of it are shown.
        rows: of the legend.
        note: a line in small print at the bottom.
        inset: whether the body keeps the margin of the text at its sides.

    Attributes:
        canvas: to draw on.
        body: left, top, right and bottom of the body on it.
    """

    def __init__(self, size: tuple[int, int], title: str, rows: Sequence[Row] = (), note: str = "") -> None:
        width, height = size
        lines = wrapped(title, _TITLE, width - 2 * _MARGIN)
        top = 20 + _LINE * len(lines) + 10
        bottom = (16 + _ROW * len(rows) if rows else 0) + (30 if note else 0) + 16
        self.canvas = Canvas(width, top + height + bottom)
        self.body = (0, top, width, top + height)
        for i, line in enumerate(lines):
            self.canvas.text((_MARGIN, 20 + _LINE * (i + 0.5)), line, _TITLE, anchor="lm")
        place = float(top + height + 16)
        for row in rows:
            self._row(row, place + _ROW / 2)
            place += _ROW
        if note:
            self.canvas.text((_MARGIN, place + 14), shortened(note, _NOTE, width - 2 * _MARGIN), _NOTE, FAINT, "lm")

    def finished(self) -> Image.Image:
        """The sheet, with hairlines that part the body from title and legend."""
        for y in (self.body[1], self.body[3]):
            self.canvas.line([(0, y), (self.canvas.width, y)], EDGE, 1)
        return self.canvas.finished()

    def _row(self, row: Row, y: float) -> None:
        canvas, right = self.canvas, self.canvas.width - _MARGIN
        draw_sign(canvas, row.sign, (_MARGIN + 12, y), row.color)
        left = _MARGIN + 40.0
        if row.value:
            canvas.text((right, y), row.value, _TEXT, row.color if row.sign not in ("passed", "failed") else INK, "rm")
        room = right - left - (text_width(row.value, _TEXT) + 24 if row.value else 0)
        text = shortened(row.text, _TEXT, room * (0.66 if row.detail else 1.0))
        canvas.text((left, y), text, _TEXT, row.color, "lm")
        used = text_width(text, _TEXT) + 18
        if row.detail:
            canvas.text((left + used, y), shortened(row.detail, _TEXT, room - used), _TEXT, FAINT, "lm")


def draw_sign(canvas: Canvas, sign: str, center: tuple[float, float], color: Rgb) -> None:
    """The small sign before a row: a ring, a hull, a dashed hull, a tick or a cross."""
    x, y = center
    pill = _pill(x, y, 12, 8)
    if sign == "object":
        canvas.panel((x - 9, y - 9, x + 9, y + 9), 5, color)
        canvas.panel((x - 5.5, y - 5.5, x + 5.5, y + 5.5), 2, PAPER)
    elif sign == "container":
        canvas.polygon(pill, fill=mixed(color, PAPER, 0.82), line=color, width=2.5)
    elif sign == "region":
        canvas.dashed(np.concatenate([pill, pill[:1]]), color, 2.5, 5, 3.5)
    elif sign == "passed":
        canvas.line([(x - 8, y + 0.5), (x - 2.5, y + 6.5), (x + 8.5, y - 7)], PASSED, 3.2)
    elif sign == "failed":
        canvas.line([(x - 6.5, y - 6.5), (x + 6.5, y + 6.5)], FAILED, 3.2)
        canvas.line([(x - 6.5, y + 6.5), (x + 6.5, y - 6.5)], FAILED, 3.2)


def _pill(x: float, y: float, half_width: float, half_height: float) -> np.ndarray:
    angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    shift = np.where(np.cos(angles) >= 0, 1, -1) * (half_width - half_height)
    return np.column_stack([x + shift + half_height * np.cos(angles), y + half_height * np.sin(angles)])
