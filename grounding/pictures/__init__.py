"""Worlds and groundings as plans seen from above: pictures that need Pillow and nothing else.

The robot is at the bottom, so that left is left as the robot sees it. Sizes are in pixels of the finished picture; the
drawing happens at several times that size and is reduced, which smooths every edge.
"""

from grounding.pictures.canvas import Canvas
from grounding.pictures.marks import Mark, marks_of, meaning_of
from grounding.pictures.outlines import rounded_hull
from grounding.pictures.plan import draw_plan
from grounding.pictures.sheet import Row, Sheet, mark_rows

__all__ = [
    "Canvas",
    "Mark",
    "Row",
    "Sheet",
    "draw_plan",
    "mark_rows",
    "marks_of",
    "meaning_of",
    "rounded_hull",
]
