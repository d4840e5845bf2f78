"""Names of objects in a plan: on the object where there is room, otherwise beside it where nothing else is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from grounding.pictures.canvas import Canvas, text_width
from grounding.pictures.palette import FAINT, PAPER, Rgb, legible_on
from grounding.world import Array

_LARGE, _SMALL, _LEAST = 14.0, 11.5, 8.0
_GAP = 7.0

Box = tuple[float, float, float, float]


def name_on(canvas: Canvas, name: str, face: Array, color: Rgb) -> bool:
    """Writes a name on an object's upper face, (4, 2) pixels in order; whether there was room."""
    edge = float(np.linalg.norm(np.diff(face, axis=0), axis=1).min())
    size = min(_LARGE, 0.42 * edge)
    if size < _LEAST or text_width(name, size) > 0.92 * edge:
        return False
    canvas.text(face.mean(axis=0), name, size, legible_on(color), "mm")
    return True


def name_beside(
    canvas: Canvas,
    names: Sequence[str],
    corners: Mapping[str, Array],
    texts: Mapping[str, str] | None = None,
    bounds: Box | None = None,
) -> None:
    """Writes names below, above, or at a side of their objects, the first of these where nothing is yet.

    Args:
        canvas: to write on.
        names: of the objects to be named.
        corners: (n, 2) pixels of the corners of every object, by name.
        texts: what is written, by name; the names themselves by default.
        bounds: left, top, right and bottom of where may be written; what has no free place there is left out.
    """
    said = {} if texts is None else texts
    taken: dict[str, Box] = {name: _bounds(points) for name, points in corners.items()}
    for name in names:
        left, top, right, bottom = taken[name]
        width, height = text_width(said.get(name, name), _SMALL), _SMALL
        x, y = (left + right) / 2, (top + bottom) / 2
        centers = (
            (x, bottom + _GAP + height / 2),
            (x, top - _GAP - height / 2),
            (right + _GAP + width / 2, y),
            (left - _GAP - width / 2, y),
        )
        boxes = [(a - width / 2, b - height / 2, a + width / 2, b + height / 2) for a, b in centers]
        free = (i for i, box in enumerate(boxes) if not any(_overlap(box, other) for other in taken.values()))
        if bounds is not None:
            free = (i for i in list(free) if _within(boxes[i], bounds))
        chosen = next(free, 0 if bounds is None else None)
        if chosen is None:
            continue
        taken[f"name of {name}"] = boxes[chosen]
        canvas.text(centers[chosen], said.get(name, name), _SMALL, FAINT, "mm", PAPER)


def _bounds(points: Array) -> Box:
    (left, top), (right, bottom) = points.min(axis=0), points.max(axis=0)
    return float(left), float(top), float(right), float(bottom)


def _within(inner: Box, outer: Box) -> bool:
    return inner[0] >= outer[0] and inner[1] >= outer[1] and inner[2] <= outer[2] and inner[3] <= outer[3]


def _overlap(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
