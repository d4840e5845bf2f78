"""The two pictures rendered: what was understood, and the end state, each seen from before the robot."""

from __future__ import annotations

import numpy as np
from PIL import Image

from grounding.pictures import Canvas, Mark, Row, Sheet, mark_rows, marks_of
from grounding.pictures.outlines import corners_of
from grounding.pictures.overlay import draw_destinations, draw_marks
from grounding.pictures.palette import INK, PAPER
from grounding.result import Grounding
from grounding.world import FURNITURE, World
from integration.plans import check_rows, result_marks, result_title
from integration.report import Report
from integration.worlds import scene_of
from motion import Camera, Renderer, Scene, Simulator

WIDTH, HEIGHT = 1280, 760
CAMERA = Camera(np.array([2.12, 0.0, 1.90]), np.array([0.46, 0.0, 0.87]), 40.0)


def understood_view(grounding: Grounding, world: World) -> Image.Image:
    """The scene, with what the phrases mean marked in it.

    Raises:
        RenderingUnavailable: no OpenGL can be started.
    """
    marks = marks_of(grounding)
    return _view(scene_of(world), None, world, marks, grounding.instruction, mark_rows(marks))


def result_view(report: Report) -> Image.Image:
    """The scene at the end, with the checks as its caption.

    Raises:
        RenderingUnavailable: no OpenGL can be started.
    """
    scene = scene_of(report.final_world)
    with Simulator(scene, report.state) as simulator:
        return _view(
            scene, simulator, report.final_world, result_marks(report), result_title(report), check_rows(report)
        )


def _view(
    scene: Scene,
    simulator: Simulator | None,
    world: World,
    marks: tuple[Mark, ...],
    title: str,
    rows: tuple[Row, ...],
) -> Image.Image:
    with Renderer(scene, WIDTH, HEIGHT) as renderer:
        photo = renderer.render(simulator, CAMERA)
        things = [item for item in world.objects if item.type not in FURNITURE]
        corners = {item.id: renderer.project(corners_of(item), CAMERA) for item in things}
        corners = {name: points for name, points in corners.items() if np.isfinite(points).all()}
        sheet = Sheet((WIDTH, HEIGHT), title, rows)
        top = sheet.body[1]
        below = np.array([0.0, top])
        corners = {name: points + below for name, points in corners.items()}
        sheet.canvas.paste(Image.fromarray(photo), (0, top))
        draw_marks(sheet.canvas, marks, corners)
        draw_destinations(sheet.canvas, marks, corners, lambda points: renderer.project(points, CAMERA) + below)
    _sides(sheet.canvas, sheet.body)
    return sheet.finished()


def _sides(canvas: Canvas, body: tuple[int, int, int, int]) -> None:
    """Which side is which for the robot, which faces the picture."""
    left, _, right, bottom = body
    canvas.text((left + 24, bottom - 22), "robot's right", 15, INK, "lm", PAPER)
    canvas.text((right - 24, bottom - 22), "robot's left", 15, INK, "rm", PAPER)
