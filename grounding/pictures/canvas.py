"""A Pillow picture drawn at several times its size and reduced when it is finished."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike
from PIL import Image, ImageDraw, ImageFont

from grounding.pictures.palette import INK, PAPER, Rgb

SCALE = 2
"""How many times larger a picture is drawn than it is shown."""

Color = Rgb | tuple[int, int, int, int]


@lru_cache(maxsize=64)
def _font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(size=size)


class Canvas:
    """A picture in the making; all coordinates and sizes are pixels of the finished one.

    Args:
        width: of the finished picture.
        height: ditto.
        color: of the background.
    """

    def __init__(self, width: int, height: int, color: Rgb = PAPER) -> None:
        self.width, self.height = width, height
        self._image = Image.new("RGB", (width * SCALE, height * SCALE), color)
        self._draw = ImageDraw.Draw(self._image, "RGBA")

    def finished(self) -> Image.Image:
        """The picture, reduced to its size."""
        return self._image.reduce(SCALE)

    def paste(self, image: Image.Image, corner: tuple[float, float]) -> None:
        """Puts a picture, given at its finished size, with its upper left corner at `corner`."""
        large = image.resize((image.width * SCALE, image.height * SCALE), Image.Resampling.BICUBIC)
        self._image.paste(large, (round(corner[0] * SCALE), round(corner[1] * SCALE)))

    def polygon(
        self, points: ArrayLike, fill: Color | None = None, line: Color | None = None, width: float = 1
    ) -> None:
        """A closed outline through (n, 2) points, with its corners round."""
        array = np.asarray(points, dtype=float)
        if fill is not None:
            self._draw.polygon(self._scaled(array), fill=fill)
        if line is not None:
            closed = np.concatenate([array, array[:2]])
            self._draw.line(self._scaled(closed), fill=line, width=max(1, round(width * SCALE)), joint="curve")

    def line(self, points: ArrayLike, color: Color, width: float = 1) -> None:
        """A line through (n, 2) points."""
        self._draw.line(self._scaled(points), fill=color, width=max(1, round(width * SCALE)), joint="curve")

    def dashed(self, points: ArrayLike, color: Color, width: float = 1, dash: float = 6, gap: float = 4) -> None:
        """A dashed line through (n, 2) points."""
        array = np.asarray(points, dtype=float)
        steps = np.linalg.norm(np.diff(array, axis=0), axis=1)
        along = np.concatenate([[0.0], np.cumsum(steps)])
        for start in np.arange(0.0, along[-1], dash + gap):
            stops = [start, *along[(along > start) & (along < start + dash)], min(start + dash, along[-1])]
            self.line([[np.interp(s, along, array[:, k]) for k in (0, 1)] for s in stops], color, width)

    def arrow(self, start: ArrayLike, end: ArrayLike, color: Color, width: float = 2, head: float = 11) -> None:
        """A dashed line from `start` to `end` with a head."""
        first, last = np.asarray(start, float), np.asarray(end, float)
        length = float(np.linalg.norm(last - first))
        if length < head:
            return
        ahead = (last - first) / length
        across = np.array([-ahead[1], ahead[0]])
        neck = last - head * ahead
        self.dashed([first, neck], color, width)
        self.polygon([last, neck + 0.45 * head * across, neck - 0.45 * head * across], fill=color)

    def circle(
        self, center: ArrayLike, radius: float, fill: Color | None = None, line: Color | None = None, width: float = 1
    ) -> None:
        """A disc or a ring."""
        x, y = np.asarray(center, float)
        box = [(x - radius) * SCALE, (y - radius) * SCALE, (x + radius) * SCALE, (y + radius) * SCALE]
        self._draw.ellipse(box, fill=fill, outline=line, width=max(1, round(width * SCALE)))

    def panel(
        self, box: tuple[float, float, float, float], radius: float, fill: Color, line: Color | None = None
    ) -> None:
        """A rectangle with round corners: left, top, right, bottom."""
        self._draw.rounded_rectangle([v * SCALE for v in box], radius * SCALE, fill=fill, outline=line, width=SCALE)

    def text(
        self,
        place: ArrayLike,
        text: str,
        size: float,
        color: Color = INK,
        anchor: str = "la",
        halo: Color | None = None,
    ) -> None:
        """Text, anchored as Pillow names it: "la" left top, "mm" middle, "rm" right middle, ...; ringed by a halo."""
        x, y = np.asarray(place, float)
        self._draw.text(
            (x * SCALE, y * SCALE),
            text,
            fill=color,
            font=_font(round(size * SCALE)),
            anchor=anchor,
            stroke_width=0 if halo is None else round(2 * SCALE),
            stroke_fill=halo,
        )

    def _scaled(self, points: ArrayLike) -> list[tuple[float, float]]:
        return [(float(x) * SCALE, float(y) * SCALE) for x, y in np.asarray(points, dtype=float)]


def text_width(text: str, size: float) -> float:
    """How wide a text is in pixels."""
    return float(_font(round(size * SCALE)).getlength(text)) / SCALE


def shortened(text: str, size: float, width: float) -> str:
    """The text, with words left out of its middle where it is wider than `width` pixels."""
    if text_width(text, size) <= width:
        return text
    words: Sequence[str] = text.split()
    for kept in range(len(words) - 1, 0, -1):
        front = (kept + 1) // 2
        short = " ".join([*words[:front], "...", *words[len(words) - (kept - front) :]])
        if text_width(short, size) <= width:
            return short
    while text and text_width(text + "...", size) > width:
        text = text[:-1]
    return text + "..."


def wrapped(text: str, size: float, width: float, lines: int = 2) -> list[str]:
    """The text in at most so many lines of at most `width` pixels; the last is shortened where it must be."""
    words = text.split()
    result: list[str] = []
    while words and len(result) < lines - 1:
        count = 1
        while count < len(words) and text_width(" ".join(words[: count + 1]), size) <= width:
            count += 1
        result.append(shortened(" ".join(words[:count]), size, width))
        words = words[count:]
    if words:
        result.append(shortened(" ".join(words), size, width))
    return result
