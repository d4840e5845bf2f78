"""Marks drawn over a picture of any kind, given where the corners of its objects are in it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from grounding.pictures.canvas import Canvas
from grounding.pictures.marks import Mark
from grounding.pictures.outlines import rounded_hull
from grounding.pictures.palette import PAPER
from grounding.world import Array

_RING = 5.0
_HULL = 13.0
_APART = 8.0

Project = Callable[[Array], Array]


def draw_areas(canvas: Canvas, marks: Sequence[Mark], corners: Mapping[str, Array]) -> None:
    """The translucent insides of containers, to be drawn before the objects are.

    Args:
        canvas: to draw on.
        marks: those of them that are containers are drawn.
        corners: (n, 2) pixels of each object's corners, by id.
    """
    for mark, outline in _hulls(marks, corners):
        canvas.polygon(outline, fill=(*mark.color, 30))


def draw_marks(canvas: Canvas, marks: Sequence[Mark], corners: Mapping[str, Array]) -> None:
    """The lines around containers and the rings around objects, to be drawn after the objects are."""
    for mark, outline in _hulls(marks, corners):
        canvas.polygon(outline, line=(*PAPER, 200), width=5.5)
        canvas.polygon(outline, line=mark.color, width=2.8)
    for mark in reversed(marks):
        for name in mark.objects if mark.role == "object" else ():
            if name in corners:
                ring = rounded_hull(corners[name], _RING)
                canvas.polygon(ring, line=PAPER, width=8)
                canvas.polygon(ring, line=mark.color, width=4)


def draw_names(canvas: Canvas, marks: Sequence[Mark], corners: Mapping[str, Array]) -> None:
    """The ids of ringed objects above their rings, for pictures whose objects do not show them."""
    named: set[str] = set()
    for mark in marks:
        for name in mark.objects if mark.role == "object" else ():
            if name in corners and name not in named:
                named.add(name)
                points = corners[name]
                place = (float(points[:, 0].mean()), float(points[:, 1].min()) - _HULL - 5)
                canvas.text(place, name, 15, mark.color, "mb", PAPER)


def draw_destinations(canvas: Canvas, marks: Sequence[Mark], corners: Mapping[str, Array], project: Project) -> None:
    """Where marked objects are brought to: a dashed outline of the object there, and an arrow to it.

    Args:
        canvas: to draw on.
        marks: those of them with a destination are drawn.
        corners: (n, 2) pixels of each object's corners, by id.
        project: from (n, 3) points in [m] to (n, 2) pixels.
    """
    for mark in marks:
        if mark.destination is None or not mark.objects or mark.objects[0] not in corners:
            continue
        here = corners[mark.objects[0]]
        there = project(mark.destination[None])[0] + here - here.mean(axis=0)
        outline = rounded_hull(there, 2.0)
        closed = np.concatenate([outline, outline[:1]])
        canvas.dashed(closed, PAPER, 6, 7, 5)
        canvas.dashed(closed, mark.color, 3, 7, 5)
        start, end = here.mean(axis=0), there.mean(axis=0)
        length = float(np.linalg.norm(end - start))
        room = np.ptp(here, axis=0).max() / 2 + _RING + 4
        if length > 2 * room:
            ahead = (end - start) / length
            canvas.arrow(start + room * ahead, end - room * ahead, mark.color, 3, 13)


def _hulls(marks: Sequence[Mark], corners: Mapping[str, Array]) -> list[tuple[Mark, Array]]:
    """Containers, the largest first, with outlines that keep apart where one lies in another."""
    found: list[tuple[Mark, Array]] = []
    groups = [mark for mark in marks if mark.role != "object" and any(name in corners for name in mark.objects)]
    for mark in sorted(groups, key=lambda mark: len(mark.objects)):
        points = np.concatenate([corners[name] for name in mark.objects if name in corners])
        within = sum(bool(set(mark.objects) & set(other.objects)) for other, _ in found)
        found.append((mark, rounded_hull(points, _HULL + _APART * within)))
    return found[::-1]
