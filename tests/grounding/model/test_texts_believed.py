"""What whole texts ask for: statements, givers and takers, what was counted before, in scenes whose answer is plain."""

import numpy as np
import pytest
from believing import TABLE, believed, block, first, grounder, laid

from grounding import World
from grounding.geometry.layout import Layout
from grounding.literal.belief import believe_literally
from grounding.model.belief import believe as weigh
from grounding.model.belief import read
from grounding.model.evaluator import EVEN
from grounding.world.scene import Scene

# Two near each other at the far left, a tower at the far right, one alone at the near right, one in the middle.
WORLD = laid(one=(0.92, 0.55), two=(0.84, 0.55), base=(0.9, -0.5), top=(0.9, -0.5, 1), near=(0.4, -0.55),
             beside=(0.9, -0.3), mid=(0.6, 0.0))  # fmt: skip


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("There are two cubes at the far left. Take the lower one and put it on the tower.", "two"),
        ("There are two cubes at the far left. The lower moves right by two spaces.", "two"),
        ("Of the two cubes at the top left, the top one moves right by two spaces.", "one"),
        ("There are two cubes at the top left take the upper one and move it right", "one"),
    ],
)
def test_a_rank_without_a_noun_is_one_of_those_that_were_counted(text, name):
    assert first(text, WORLD)[1] == (name,)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("The bottom right cube joins the cube in the middle.", "near"),
        ("The bottom right cube moves two spaces to the left.", "near"),
        ("The bottom right cube, put it on the tower.", "near"),
        ("The top of the tower moves two spaces down.", "top"),
        ("Move the cube on top of the tower two spaces down.", "top"),
        ("Take the cube from the top of the tower and put it in the middle.", "top"),
    ],
)
def test_statements_tell_what_moves(text, name):
    assert first(text, WORLD) == ("place", (name,))


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("The tower loses its top, which moves to the middle.", "top"),
        ("The tower moves one of its cubes two spaces down.", "top"),
        ("The cube in the bottom right corner becomes a tower, taking a cube from the tower.", "top"),
        ("The tower gains a floor from the cube in the middle.", "mid"),
        ("The tower takes a cube just below it. It comes from the bottom right corner.", "near"),
        ("The tower takes the cube to its left as a new floor.", "beside"),
        ("The cube in the middle is joined on the left by the cube in the bottom right corner.", "near"),
        ("A second tower forms at the far left, using the cube in the middle.", "mid"),
    ],
)
def test_givers_and_takers_tell_what_moves(text, name):
    assert first(text, WORLD) == ("place", (name,))


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("Move the cube at the far left that is highest to the middle.", "one"),
        ("Move the cube that is second lowest on the table to the left.", "mid"),
        ("Move the cube at the very bottom two spaces up.", "near"),
        ("Move the cube to the furthest right that carries nothing to the middle.", "near"),
        ("Move the cube all the way to the bottom two spaces up.", "near"),
    ],
)
def test_what_is_furthest_is_found(text, name):
    assert first(text, WORLD)[1] == (name,)


def test_the_one_in_a_row_is_alone_there_and_the_first_is_not():
    rows = laid(a=(0.8, 0.3), b=(0.8, 0.1), c=(0.8, -0.1), alone=(0.6, 0.0), d=(0.4, 0.2), e=(0.4, -0.2))
    for text, name in (
        ("move the cube in the second row up", "alone"),
        ("move the first cube in the third row up", "d"),
        ("move the last cube in the first row up", "c"),
    ):
        assert first(text, rows)[1] == (name,)


def test_a_definite_noun_means_the_one_of_which_it_holds_best():
    best, second, *_ = believed("move the cube at the bottom up", WORLD).listed()
    assert best.objects == ("near",)
    assert best.probability > 1.3 * second.probability


@pytest.mark.parametrize("text", ["the top cube moves left", "move the cube at the back left two spaces right"])
def test_shares_sum_to_one(text):
    assert np.isclose(sum(share for _, share in believed(text, WORLD).options), 1.0)


def test_what_differs_by_place_only_is_never_literal_beyond_doubt():
    parses = grounder().parser.parse("take the leftmost cube")
    for colors, alike in ((("gray", "gray", "gray"), True), (("red", "blue", "red"), False)):
        blocks = [block(f"b{i}", color, 0.6, 0.4 - 0.4 * i) for i, color in enumerate(colors)]
        scene = Scene(Layout(World((TABLE, *blocks))))
        literal = believe_literally(parses, scene, weigh(read(parses, scene), EVEN))
        assert [names for (_, names), _ in literal.options] == [("b0",)]
        assert literal.alike == alike
