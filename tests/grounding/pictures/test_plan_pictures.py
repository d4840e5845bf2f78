import subprocess
import sys

import numpy as np
import pytest

from grounding import World, make_object
from grounding.pictures import Mark, Row, draw_plan
from grounding.pictures.canvas import shortened, text_width, wrapped
from grounding.pictures.palette import MARKS, OBJECT_COLORS
from grounding.pictures.plan import View

TABLE = make_object("table", "table", "white", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04))


def world(*blocks):
    return World((TABLE, *blocks))


def where(image, color):
    """Mean row and column of the pixels of a colour."""
    found = np.argwhere(np.abs(np.asarray(image, dtype=int) - color).max(axis=2) <= 8)
    return found.mean(axis=0)


def test_left_is_left_and_far_is_up():
    blocks = world(
        make_object("l", color="red", position=(0.6, 0.4, 0.736)),
        make_object("r", color="blue", position=(0.6, -0.4, 0.736)),
        make_object("f", color="green", position=(0.8, 0, 0.736)),
        make_object("n", color="purple", position=(0.4, 0, 0.736)),
    )
    image = draw_plan(blocks)
    assert where(image, OBJECT_COLORS["red"])[1] < where(image, OBJECT_COLORS["blue"])[1]
    assert where(image, OBJECT_COLORS["green"])[0] < where(image, OBJECT_COLORS["purple"])[0]


def test_rings_are_around_what_they_mark():
    blocks = world(make_object("a", position=(0.6, 0.4, 0.736)), make_object("b", position=(0.6, -0.4, 0.736)))
    for name in ("a", "b"):
        image = draw_plan(blocks, [Mark("it", "object", (name,), 0.9, MARKS[0])], rows=())
        view = View(blocks, image.width)
        expected = view(blocks[name].position)[0]
        assert where(image, MARKS[0])[1] == pytest.approx(expected[0], abs=6)


def test_everything_is_inside_the_picture_wherever_it_is():
    blocks = world(make_object("a", position=(2.5, 1.6, 0.5)), make_object("b", position=(-0.4, -2.0, 0.736)))
    view = View(blocks)
    for name in ("a", "b"):
        x, y = view(blocks[name].position)[0]
        assert 0 < x < 1280
        assert 0 < y < view.height


def test_a_world_without_anything_is_drawn():
    assert draw_plan(World(())).width == 1280


def test_marks_of_objects_that_are_gone_are_left_out():
    draw_plan(world(), [Mark("it", "object", ("gone",), 0.9, MARKS[0], np.array([0.6, 0, 0.7]))])


def test_the_legend_makes_the_sheet_higher():
    low = draw_plan(world(), rows=())
    high = draw_plan(world(), rows=[Row("passed", "a" * 400, "detail " * 80, "1.0 mm")] * 5, title="word " * 90)
    assert high.height > low.height + 100
    assert high.width == low.width


def test_texts_are_shortened_to_their_room():
    text = "the red block to the left of the row of five blocks on the right"
    assert text_width(shortened(text, 17, 200), 17) <= 200
    assert "..." in shortened(text, 17, 200)
    lines = wrapped(text, 17, 180)
    assert len(lines) == 2
    assert all(text_width(line, 17) <= 180 for line in lines)


def test_drawing_needs_neither_motion_nor_a_simulator():
    code = "import grounding.pictures, sys; print([m for m in ('motion', 'mujoco', 'integration') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"
