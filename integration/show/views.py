"""The two pictures rendered: what was understood, and the end state, each seen from before the robot."""

from __future__ import annotations

from types import TracebackType

import numpy as np
from PIL import Image

from grounding.pictures import Canvas, Mark, Row, Sheet, mark_rows, marks_of
from grounding.pictures.outlines import corners_of
from grounding.pictures.overlay import draw_destinations, draw_marks, draw_names
from grounding.pictures.palette import INK, PAPER
from grounding.result import Grounding
from grounding.world import World
from integration.execute.report import Report
from integration.show.from_above import check_rows, result_marks, result_title
from integration.worlds_and_scenes import scene_of
from motion import Camera, Renderer, Simulator

WIDTH, HEIGHT = 1280, 860
CAMERA = Camera(np.array([2.25, 0.0, 2.05]), np.array([0.46, 0.0, 1.05]), 44.0)
_TABLE = np.array([0.65, 0.0, 0.691])  # the centre of the table that `_CLOSE` suits, in [m]
_CLOSE = Camera(np.array([2.1, 0.0, 2.0]), np.array([0.62, 0.0, 0.76]), 40.0)


class Studio:
    """Renders a world before and after; close it when done, or use it as a context manager.

    Args:
        world: whose objects are rendered, wherever they will be.
        size: width and height of the view in pixels.
        camera: that looks at it.

    Raises:
        RenderingUnavailable: no OpenGL can be started.
    """

    def __init__(self, world: World, size: tuple[int, int] = (WIDTH, HEIGHT), camera: Camera = CAMERA) -> None:
        self._size, self._camera = size, camera
        self._renderer = Renderer(scene_of(world), *size)

    def __enter__(self) -> Studio:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Frees OpenGL's memory."""
        self._renderer.close()

    def understood(self, grounding: Grounding, world: World) -> Image.Image:
        """The scene, with what the phrases mean marked in it."""
        marks = marks_of(grounding)
        return self.marked(world, marks, grounding.instruction, mark_rows(marks))

    def marked(self, world: World, marks: tuple[Mark, ...], title: str, rows: tuple[Row, ...]) -> Image.Image:
        """The scene with marks in it, a title above and a legend below."""
        with Simulator(scene_of(world)) as simulator:
            return self._view(simulator, world, marks, title, rows)

    def result(self, report: Report) -> Image.Image:
        """The scene at the end, with the checks as its caption."""
        world = report.final_world
        with Simulator(scene_of(world), report.state) as simulator:
            return self._view(simulator, world, result_marks(report), result_title(report), check_rows(report))

    def _view(
        self, simulator: Simulator, world: World, marks: tuple[Mark, ...], title: str, rows: tuple[Row, ...]
    ) -> Image.Image:
        sheet = Sheet(self._size, title, rows)
        below = np.array([0.0, sheet.body[1]])

        def project(points: np.ndarray) -> np.ndarray:
            return self._renderer.project(points, self._camera) + below

        corners = {item.id: project(corners_of(item)) for item in world.things}
        corners = {name: points for name, points in corners.items() if np.isfinite(points).all()}
        sheet.canvas.paste(Image.fromarray(self._renderer.render(simulator, self._camera)), (0, sheet.body[1]))
        draw_marks(sheet.canvas, marks, corners)
        draw_names(sheet.canvas, marks, corners)
        draw_destinations(sheet.canvas, marks, corners, project)
        _sides(sheet.canvas, sheet.body)
        return sheet.finished()


def close_camera(world: World) -> Camera:
    """A camera that shows the table of a world, wherever it stands, and what lies on it, from before the robot."""
    table = next((item.position for item in world.objects if item.type == "table"), _TABLE)
    return Camera(_CLOSE.position + (table - _TABLE), _CLOSE.target + (table - _TABLE), _CLOSE.field_of_view)


def _sides(canvas: Canvas, body: tuple[int, int, int, int]) -> None:
    """Writes which side is which for the robot, which faces the picture."""
    left, _, right, bottom = body
    canvas.text((left + 24, bottom - 22), "robot's right", 15, INK, "lm", PAPER)
    canvas.text((right - 24, bottom - 22), "robot's left", 15, INK, "rm", PAPER)
