"""The pictures of a run: rendered where OpenGL starts, drawn from above elsewhere."""

from __future__ import annotations

import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType

from PIL import Image

from grounding.result import Grounding
from grounding.world import World
from integration.errors import UsageError
from integration.execute.report import FAILED, Report, Step
from integration.show.from_above import result_from_above, understood_from_above
from integration.show.views import Studio
from motion import MotionError, RenderingUnavailable

UNDERSTOOD, RESULT = "understood.png", "result.png"
HOW_TO_RENDER = (
    "the pictures are plans seen from above, because no OpenGL starts here; for rendered ones install the Debian "
    "package libegl1 or libosmesa6 (apt install libegl1) and leave MUJOCO_GL unset"
)
_COMPRESSION = 3


class Drawing:
    """Draws the pictures of one run while it goes on, in a thread of its own, to which OpenGL's context belongs.

    Args:
        grounding: what was understood.
        world: as it was given.
        folder: where `understood.png` and `result.png` are written; made if it is missing.
    """

    def __init__(self, grounding: Grounding, world: World, folder: Path) -> None:
        self._folder = folder
        self._studio: Studio | None = None
        self._hint: str | None = None
        self._steps: list[Step] = []
        self._written: list[str] = []
        self._thread = ThreadPoolExecutor(max_workers=1)
        self._begun = self._thread.submit(self._understood, grounding, world)

    def __enter__(self) -> Drawing:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._thread.submit(self._close)
        self._thread.shutdown()

    def finished(self, report: Report) -> tuple[Report, str | None]:
        """The report with the files' names and the steps they took, and a hint for people, or None.

        Raises:
            UsageError: the folder cannot be written to.
        """
        self._begun.result()
        if report.checks or report.outcome == FAILED:
            self._thread.submit(self._result, report).result()
        return report.with_pictures(tuple(self._written), tuple(self._steps)), self._hint

    def _understood(self, grounding: Grounding, world: World) -> None:
        with self._timed("start the renderer"):
            try:
                self._studio = Studio(world)
            except RenderingUnavailable:
                self._hint = HOW_TO_RENDER
            except MotionError:  # a world that cannot be simulated can be drawn from above all the same
                self._hint = None
        with self._timed(f"draw {UNDERSTOOD}"):
            studio = self._studio
            drawn = understood_from_above(grounding, world) if studio is None else studio.understood(grounding, world)
            self._save(drawn, UNDERSTOOD)

    def _result(self, report: Report) -> None:
        with self._timed(f"draw {RESULT}"):
            self._save(result_from_above(report) if self._studio is None else self._studio.result(report), RESULT)

    def _close(self) -> None:
        if self._studio is not None:
            self._studio.close()

    def _save(self, image: Image.Image, name: str) -> None:
        path = self._folder / name
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            image.save(path, compress_level=_COMPRESSION)
        except OSError as error:
            raise UsageError(f"{path} cannot be written: {error.strerror or error}") from error
        self._written.append(str(path))

    @contextmanager
    def _timed(self, name: str) -> Iterator[None]:
        start = time.perf_counter()
        yield
        self._steps.append(Step(name, time.perf_counter() - start))


def save_pictures(report: Report, folder: Path) -> tuple[Report, str | None]:
    """Write what was understood and, where something was done, how it ended; see `Drawing`."""
    with Drawing(report.grounding, report.world, folder) as drawing:
        return drawing.finished(report)
