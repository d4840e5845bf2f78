"""The pictures of a run: rendered where OpenGL starts, drawn from above elsewhere."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from PIL import Image

from integration.errors import UsageError
from integration.plans import result_plan, understood_plan
from integration.report import FAILED, Report, Step
from integration.views import Studio
from motion import MotionError, RenderingUnavailable

UNDERSTOOD, RESULT = "understood.png", "result.png"
HOW_TO_RENDER = (
    "the pictures are plans seen from above, because no OpenGL starts here; for rendered ones install the Debian "
    "package libegl1 or libosmesa6 (apt install libegl1) and leave MUJOCO_GL unset"
)
_COMPRESSION = 3

Draw = Callable[[], Image.Image]


def save_pictures(report: Report, folder: Path) -> tuple[Report, str | None]:
    """Write what was understood and, where something was done, how it ended.

    Args:
        report: of a run.
        folder: where `understood.png` and `result.png` are written; made if it is missing.

    Returns:
        the report with the files' names, and a hint for people, or None.

    Raises:
        UsageError: the folder cannot be written to.
    """
    hint, studio = None, None
    begun = time.perf_counter()
    try:
        studio = Studio(report.world)
    except RenderingUnavailable:
        hint = HOW_TO_RENDER
    except MotionError:  # a world that cannot be simulated can be drawn from above all the same
        hint = None
    written: list[str] = []
    steps = [Step("start the renderer", time.perf_counter() - begun)]
    try:
        for name, rendered, drawn in _pictures(report, studio):
            start = time.perf_counter()
            written.append(str(_save(drawn() if rendered is None else rendered(), folder / name)))
            steps.append(Step(f"draw {name}", time.perf_counter() - start))
    finally:
        if studio is not None:
            studio.close()
    return report.with_pictures(tuple(written), tuple(steps)), hint


def _pictures(report: Report, studio: Studio | None) -> Iterator[tuple[str, Draw | None, Draw]]:
    """Names of files, each with how it is rendered, if it can be, and how it is drawn from above."""
    yield (
        UNDERSTOOD,
        None if studio is None else partial(studio.understood, report.grounding, report.world),
        partial(understood_plan, report.grounding, report.world),
    )
    if report.checks or report.outcome == FAILED:
        yield RESULT, None if studio is None else partial(studio.result, report), partial(result_plan, report)


def _save(image: Image.Image, path: Path) -> Path:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        image.save(path, compress_level=_COMPRESSION)
    except OSError as error:
        raise UsageError(f"{path} cannot be written: {error.strerror or error}") from error
    return path
