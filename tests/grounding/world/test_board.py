"""Boards: found where everything stands on squares, and then the squares are the places."""

import functools

import numpy as np
import pytest

from grounding.geometry.layout import Layout
from grounding.grounder import Grounder
from grounding.world import World, make_object
from grounding.world.board import find_board
from grounding.world.scene import Scene

EDGE, PITCH, SIDE = 0.05, 0.065, 6
TABLE = make_object("table", "table", "white", (0.65, 0.0, 0.0), size=(SIDE * PITCH, SIDE * PITCH, 0.02))


@functools.cache
def grounder():
    return Grounder.load()


def centre(row, column):
    """The middle of a square, counted from the corner on the robot's right that is near to it."""
    return np.array([0.65 + (row - (SIDE - 1) / 2) * PITCH, (column - (SIDE - 1) / 2) * PITCH])


def block(name, color, row, column, level=0, kind="block", off=0.0):
    x, y = centre(row, column) + off
    return make_object(name, kind, color, (x, y, 0.035 + EDGE * level), size=(EDGE, EDGE, EDGE))


WORLD = World((
    TABLE, block("r", "red", 2, 2), block("b", "blue", 5, 5), block("g", "green", 4, 1), block("y", "yellow", 4, 1, 1),
))  # fmt: skip


def test_squares_are_found_and_fill_the_table():
    board = find_board(WORLD, EDGE)
    assert board.shape == (SIDE, SIDE)
    assert board.pitch == pytest.approx(PITCH)
    assert len(board.centres) == SIDE**2


def test_what_stands_beside_a_square_is_on_no_board():
    crooked = World((*WORLD.objects, block("o", "orange", 0, 3, off=0.012)))
    assert find_board(crooked, EDGE) is None
    assert find_board(World((TABLE, block("r", "red", 2, 2))), EDGE) is None


@pytest.mark.parametrize(("text", "square", "level"), [
    ("move the red block two squares forward", (4, 2), 0), ("move the red block one square to the left", (2, 3), 0),
    ("put the red block in the near right corner", (0, 0), 0), ("put the red block in the far left corner", (5, 5), 1),
    ("put the red block one square in front of the blue block", (4, 5), 0), ("put the red block on the yellow block",
                                                                             (4, 1), 2),
])  # fmt: skip
def test_places_are_squares_also_those_where_something_stands(text, square, level):
    action = grounder().ground(text, WORLD).actions[0]
    assert action.destination.position == pytest.approx((*centre(*square), 0.035 + EDGE * level), abs=1e-4)


def test_a_scene_knows_its_board():
    assert Scene(Layout(WORLD)).board.shape == (SIDE, SIDE)
