"""The pictures of a run: rendered where OpenGL starts, drawn from above elsewhere."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from PIL import Image

from integration.errors import UsageError
from integration.plans import result_plan, understood_plan
from integration.report import FAILED, Report, Step
from motion import RenderingUnavailable, rendering_available

UNDERSTOOD, RESULT = "understood.png", "result.png"
HOW_TO_RENDER = (
    "the pictures are plans seen from above, because no OpenGL starts here; for rendered ones install the Debian "
    "package libegl1 or libosmesa6 (apt install libegl1) and leave MUJOCO_GL unset"
)
_COMPRESSION = 3


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
    hint = None if rendering_available() else HOW_TO_RENDER
    written: list[str] = []
    steps: list[Step] = []
    for name, drawn in _pictures(report).items():
        start = time.perf_counter()
        try:
            image = drawn[0]() if hint is None else drawn[1]()
        except RenderingUnavailable:
            hint = HOW_TO_RENDER
            image = drawn[1]()
        written.append(str(_save(image, folder / name)))
        steps.append(Step(f"draw {name}", time.perf_counter() - start))
    return report.with_pictures(tuple(written), tuple(steps)), hint


def _pictures(report: Report) -> dict[str, tuple[Callable[[], Image.Image], Callable[[], Image.Image]]]:
    """Names of files, each with how it is rendered and how it is drawn from above."""
    from integration.views import result_view, understood_view

    found = {
        UNDERSTOOD: (
            lambda: understood_view(report.grounding, report.world),
            lambda: understood_plan(report.grounding, report.world),
        )
    }
    if report.checks or report.outcome == FAILED:
        found[RESULT] = (lambda: result_view(report), lambda: result_plan(report))
    return found


def _save(image: Image.Image, path: Path) -> Path:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        image.save(path, compress_level=_COMPRESSION)
    except OSError as error:
        raise UsageError(f"{path} cannot be written: {error.strerror or error}") from error
    return path
