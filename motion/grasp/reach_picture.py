"""The reach map as a picture: which hand, and how far tilted, seen from above with the robot at the bottom."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from motion.grasp.reach_map import STEEPNESS, ReachMap
from motion.poses import Array

Rgb = tuple[int, int, int]

_FINE = 2
"""Drawn so many times larger and shrunk, for smooth edges."""
_MARGIN, _GAP, _TITLE, _LEGEND, _AXIS = 24, 56, 44, 92, 46
_WIDE = 620
_PAPER: Rgb = (255, 255, 255)
_INK: Rgb = (40, 44, 52)
_GREY: Rgb = (128, 134, 142)
_NONE: Rgb = (232, 232, 230)
_LEFT: Rgb = (66, 122, 199)
_RIGHT: Rgb = (224, 133, 42)
_BOTH: Rgb = (72, 158, 96)
_TILTS: tuple[Rgb, ...] = ((38, 70, 120), (62, 120, 170), (112, 170, 200), (176, 212, 224))


def reach_picture(reach: ReachMap) -> Image.Image:
    """Both panels, with axes in metres and a legend."""
    table = reach.table
    length, width = 2 * table.half_extents[0], 2 * table.half_extents[1]
    scale = _WIDE / width
    high = round(length * scale)
    size = (2 * _MARGIN + 2 * _AXIS + 2 * _WIDE + _GAP, _TITLE + high + _AXIS + _LEGEND)
    image = Image.new("RGB", (size[0] * _FINE, size[1] * _FINE), _PAPER)
    draw = ImageDraw.Draw(image)
    hands = reach.hands()
    least = reach.least_tilt()
    edges = [1000 * float(edge) for edge in reach.size]
    block = f"a block of {edges[0]:.0f} x {edges[1]:.0f} x {edges[2]:.0f} mm"
    left = _MARGIN + _AXIS
    for index, title in enumerate((f"Which hand takes {block}", "How far it must tilt at least")):
        corner = (left + index * (_WIDE + _GAP + _AXIS), _TITLE)
        _text(draw, (corner[0], corner[1] - 16), title, 18, _INK, "ls")
        for row, x in enumerate(reach.x):
            for column, y in enumerate(reach.y):
                color = _hand_color(hands[:, row, column]) if index == 0 else _tilt_color(float(least[row, column]))
                _cell(draw, reach, corner, scale, (float(x), float(y)), color)
        _axes(draw, reach, corner, scale, high)
    below = _TITLE + high + _AXIS + 14
    _legend(draw, (left, below), [("left", _LEFT), ("both alike", _BOTH), ("right", _RIGHT), ("none", _NONE)])
    _text(draw, (left, below + 50), "Paler: only some turns of the block can be taken.", 14, _GREY, "ls")
    tilts = [(f"{np.degrees(tilt):.0f} degrees", color) for tilt, color in zip(STEEPNESS, _TILTS, strict=True)]
    _legend(draw, (left + _WIDE + _GAP + _AXIS, below), [*tilts, ("out of reach", _NONE)])
    return image.resize(size, Image.Resampling.LANCZOS)


def _hand_color(shares: Array) -> Rgb:
    """Of the hands that take most turns of the block, paler the fewer those are."""
    best = float(shares.max())
    if best <= 0:
        return _NONE
    which = shares >= best - 1e-9
    color = _BOTH if which.all() else _LEFT if which[0] else _RIGHT
    strength = 0.35 + 0.65 * best
    return _mixed(color, strength)


def _tilt_color(tilt: float) -> Rgb:
    return _NONE if np.isnan(tilt) else _TILTS[int(np.argmin(np.abs(np.array(STEEPNESS) - tilt)))]


def _mixed(color: Rgb, strength: float) -> Rgb:
    red, green, blue = (round(strength * part + (1 - strength) * 255) for part in color)
    return red, green, blue


def _cell(
    draw: ImageDraw.ImageDraw,
    reach: ReachMap,
    corner: tuple[float, float],
    scale: float,
    place: tuple[float, float],
    color: Rgb,
) -> None:
    half = _spacing(reach) / 2
    first = _pixel(reach, corner, scale, place[0] + half, place[1] + half)
    last = _pixel(reach, corner, scale, place[0] - half, place[1] - half)
    draw.rectangle([*first, *last], fill=color)


def _spacing(reach: ReachMap) -> float:
    """Distance between neighbouring places, metres."""
    for values in (reach.x, reach.y):
        if len(values) > 1:
            return float(values[1] - values[0])
    return float(2 * min(reach.table.half_extents[:2]))


def _pixel(reach: ReachMap, corner: tuple[float, float], scale: float, x: float, y: float) -> tuple[float, float]:
    """The pixel of a place: x upwards, y to the left, as the robot sees it."""
    far, left = (reach.table.position + reach.table.half_extents)[:2]
    return (corner[0] + (left - y) * scale) * _FINE, (corner[1] + (far - x) * scale) * _FINE


def _axes(draw: ImageDraw.ImageDraw, reach: ReachMap, corner: tuple[float, float], scale: float, high: int) -> None:
    first, last = reach.table.position - reach.table.half_extents, reach.table.position + reach.table.half_extents
    outline = [*_pixel(reach, corner, scale, last[0], last[1]), *_pixel(reach, corner, scale, first[0], first[1])]
    draw.rectangle(outline, outline=_INK, width=_FINE)
    for x in _round_numbers(first[0], last[0], 0.1):
        row = _pixel(reach, corner, scale, x, last[1])[1] / _FINE
        _text(draw, (corner[0] - 6, row), f"{x:.1f}", 13, _GREY, "rm")
    for y in _round_numbers(first[1], last[1], 0.3):
        column = _pixel(reach, corner, scale, first[0], y)[0] / _FINE
        _text(draw, (column, corner[1] + high + 6), f"{y:.1f}", 13, _GREY, "ma")
    _text(draw, (corner[0] - 44, corner[1] - 18), "x [m]", 13, _GREY, "ls")
    middle = _pixel(reach, corner, scale, first[0], 0.0)[0] / _FINE
    _text(draw, (corner[0], corner[1] + high + 24), "y [m]", 13, _GREY, "la")
    _text(draw, (middle, corner[1] + high + 24), "the robot stands here, below", 13, _INK, "ma")


def _round_numbers(low: float, high: float, step: float) -> list[float]:
    return [float(k * step) for k in range(int(np.ceil(low / step)), int(np.floor(high / step)) + 1)]


def _legend(draw: ImageDraw.ImageDraw, corner: tuple[float, float], entries: list[tuple[str, Rgb]]) -> None:
    x, y = corner
    for name, color in entries:
        draw.rectangle([x * _FINE, y * _FINE, (x + 18) * _FINE, (y + 18) * _FINE], fill=color, outline=_GREY)
        _text(draw, (x + 25, y + 9), name, 15, _INK, "lm")
        x += 46 + _font(15).getlength(name) / _FINE


def _text(draw: ImageDraw.ImageDraw, place: tuple[float, float], text: str, size: int, color: Rgb, anchor: str) -> None:
    draw.text((place[0] * _FINE, place[1] * _FINE), text, fill=color, font=_font(size), anchor=anchor)


def _font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(size=size * _FINE)
