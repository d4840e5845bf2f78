import os
import subprocess
import sys

import numpy as np
import pytest
from by_hand import middle_of_the_row, nearest_on_the_green_tower, scene
from PIL import Image

from grounding import Grounding
from grounding.pictures.palette import MARKS, PASSED
from integration.errors import UsageError
from integration.execute.executor import Executor
from integration.show.from_above import result_from_above, understood_from_above
from integration.show.pictures import save_pictures
from integration.show.views import Studio
from motion import rendering_available

needs_opengl = pytest.mark.skipif(not rendering_available(), reason="no OpenGL starts here")


def understood_view(grounding, world):
    with Studio(world) as studio:
        return studio.understood(grounding, world)


def result_view(report):
    with Studio(report.world) as studio:
        return studio.result(report)


def pixels(image, color):
    """How many pixels of the picture have a colour."""
    return int((np.abs(np.asarray(image, dtype=int) - color).max(axis=2) <= 6).sum())


@pytest.fixture(scope="module")
def report():
    return Executor().execute(middle_of_the_row(), scene("default"))


@pytest.mark.parametrize("draw", [understood_from_above, pytest.param(understood_view, marks=needs_opengl)])
def test_block_and_row_are_marked_in_two_colours(draw):
    world, grounding = scene("default"), middle_of_the_row()
    marked = draw(grounding, world)
    plain = draw(Grounding(grounding.instruction, "grounded"), world)
    for color in MARKS[:2]:
        assert pixels(marked, color) > pixels(plain, color) + 300


@pytest.mark.parametrize("draw", [result_from_above, pytest.param(result_view, marks=needs_opengl)])
def test_the_end_shows_ticks_and_the_block_ringed(draw, report):
    assert pixels(draw(report), PASSED) > 500


@pytest.mark.parametrize("draw", [understood_from_above, pytest.param(understood_view, marks=needs_opengl)])
def test_a_place_shows_where_to(draw):
    world, grounding = scene("tower"), nearest_on_the_green_tower()
    assert draw(grounding, world).size[0] == 1280
    assert pixels(draw(grounding, world), MARKS[0]) > 300


def test_two_files_are_written(report, tmp_path):
    told, _ = save_pictures(report, tmp_path / "new")
    assert told.pictures == (str(tmp_path / "new" / "understood.png"), str(tmp_path / "new" / "result.png"))
    for name in told.pictures:
        with Image.open(name) as image:
            assert image.size[0] == 1280


def test_only_what_was_understood_where_nothing_was_done(tmp_path):
    report = Executor().execute(Grounding("sing", "not_understood"), scene("four"))
    told, _ = save_pictures(report, tmp_path)
    assert [name.rpartition("/")[2] for name in told.pictures] == ["understood.png"]


def test_a_folder_that_cannot_be_made_is_refused(report, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(UsageError, match="cannot be written"):
        save_pictures(report, tmp_path / "file")


def test_without_opengl_plans_are_drawn_and_the_hint_names_packages(tmp_path):
    code = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from pathlib import Path\n"
        "from by_hand import middle_of_the_row, scene\n"
        "from integration.execute.executor import Executor\n"
        "from integration.show.pictures import save_pictures\n"
        "report, hint = save_pictures(Executor().execute(middle_of_the_row(), scene('default')), Path(sys.argv[2]))\n"
        "print(hint, *report.pictures)\n"
    )
    result = subprocess.run(
        [sys.executable, "-c", code, os.path.dirname(os.path.dirname(__file__)), str(tmp_path)],
        env={**os.environ, "MUJOCO_GL": "disable"}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert "libegl1" in result.stdout
    with Image.open(tmp_path / "understood.png") as image:
        drawn = image.convert("RGB")
    assert np.array_equal(np.asarray(drawn), np.asarray(understood_from_above(middle_of_the_row(), scene("default"))))
