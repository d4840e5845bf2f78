"""The robot as a small labelled figure at its edge of the table."""

from __future__ import annotations

import numpy as np

from grounding.pictures.boxes import back_to_front, faces_of
from grounding.pictures.canvas import Canvas
from grounding.pictures.palette import INK, PAPER, ROBOT, mixed
from grounding.pictures.perspective import Camera
from grounding.world import WorldObject, make_object

_PARTS = {  # centre and edges in [m]
    "body": ((0.06, 0.0, 0.70), (0.14, 0.30, 0.20)),
    "head": ((0.09, 0.0, 0.86), (0.08, 0.14, 0.10)),
    "left arm": ((0.15, 0.24, 0.72), (0.26, 0.06, 0.06)),
    "right arm": ((0.15, -0.24, 0.72), (0.26, 0.06, 0.06)),
    "shoulders": ((0.05, 0.0, 0.755), (0.08, 0.54, 0.06)),
}


def robot_boxes() -> tuple[WorldObject, ...]:
    """The figure's boxes; it is smaller than the robot, so that it hides nothing of the table."""
    return tuple(
        make_object(name.replace(" ", "_"), "robot", "gray", place, size=size) for name, (place, size) in _PARTS.items()
    )


def draw_robot(canvas: Canvas, camera: Camera) -> None:
    """Draw the figure, its name, and which hand is which."""
    by_name = {item.id: item for item in robot_boxes()}
    for item in back_to_front(list(by_name.values()), camera):
        for face in faces_of(item, camera):
            canvas.polygon(face.pixels, fill=face.shade(mixed(ROBOT, PAPER, 0.35)), line=mixed(ROBOT, INK, 0.5))
    for name, letter in (("left_arm", "L"), ("right_arm", "R")):
        hand = by_name[name]
        spot = camera(hand.position + np.array([0.09, 0.0, float(hand.half_extents[2])]))
        canvas.text(spot, letter, 15, INK, "mm", PAPER)
    aside = camera(np.array([0.06, 0.42, 0.72]))
    other = camera(np.array([0.06, -0.42, 0.72]))
    right = aside if aside[0] > other[0] else other
    canvas.text(right, 'the ROBOT, which the text calls "you"', 17, INK, "lm")
