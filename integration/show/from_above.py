"""The two pictures as plans seen from above, for machines that cannot render."""

from __future__ import annotations

from PIL import Image

from grounding.pictures import Mark, Row, draw_plan, marks_of
from grounding.pictures.palette import FAILED, PASSED
from grounding.result import Grounding
from grounding.world import World
from integration.execute.checks import gathered
from integration.execute.report import DONE, Report
from integration.show.report_text import limit, measured


def understood_from_above(grounding: Grounding, world: World) -> Image.Image:
    """The world from above, with what the phrases mean marked in it."""
    return draw_plan(world, marks_of(grounding), grounding.instruction)


def result_from_above(report: Report) -> Image.Image:
    """The world from above as it was observed at the end, with the checks as its caption."""
    hands = {
        item.arm: report.final_world[item.object].position for item in report.handled if item.action == "pick"
    }
    return draw_plan(report.final_world, result_marks(report), result_title(report), check_rows(report), hands=hands)


def result_marks(report: Report) -> tuple[Mark, ...]:
    """Marks of what was handled, in the colour of the outcome."""
    names = tuple(dict.fromkeys(item.object for item in report.handled))
    color = PASSED if report.outcome == DONE else FAILED
    return (Mark(report.message, "object", names, 1.0, color),) if names else ()


def result_title(report: Report) -> str:
    """The outcome in one line."""
    return f"{'Done' if report.outcome == DONE else 'Failed'}: {report.message}"


def check_rows(report: Report) -> tuple[Row, ...]:
    """The checks as a caption."""
    return tuple(
        Row("passed" if check.passed else "failed", check.meaning, limit(check, count), measured(check))
        for check, count in gathered(report.checks)
    )
