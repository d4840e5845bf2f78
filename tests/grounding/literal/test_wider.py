"""What is missing: only what no sense of the words finds, and what a text speaks of beside what it handles."""

import functools

import pytest

import models
from grounding import Grounder
from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.literal.presupposed import absences
from grounding.literal.reader import LiteralReader
from grounding.literal.values import FAINT, FIRM, Missing
from grounding.literal.wider import held, is_missing, looks_stacked
from grounding.meaning.nouns import Noun
from grounding.world import World, load_world, make_object
from grounding.world.scene import Scene

TABLE = load_world(models.SCENES / "four.json")["table"]
HEIGHT = 0.736  # of the centre of a block on the table
EDGE = 0.05


def laid(**blocks):
    """A world of blocks given as colour, x, y and, for those in a tower, how many lie below."""
    return World((TABLE, *(make_object(name, color=color, position=(x, y, HEIGHT + EDGE * sum(level)))
                           for name, (color, x, y, *level) in blocks.items())))  # fmt: skip


ROW = [("red", 0.55, 0.3), ("green", 0.55, 0.2), ("blue", 0.55, 0.1), ("red", 0.55, 0.0)]
LOOSE = laid(a=("red", 0.45, 0.5), b=("blue", 0.75, 0.2), c=("green", 0.5, -0.2), d=("yellow", 0.8, -0.5))
LINED = laid(**{f"r{i}": block for i, block in enumerate(ROW)}, far=("yellow", 0.8, -0.5))
AHEAD = laid(a=("red", 0.5, 0.2), b=("blue", 0.556, 0.2), c=("green", 0.612, 0.2), d=("yellow", 0.8, -0.5))
STACKED = laid(a=("red", 0.5, 0.2), b=("blue", 0.5, 0.2, 1), c=("green", 0.7, -0.3))
TOWER = Noun(head="container", kinds=("tower",), text="the tower")


@functools.cache
def grounder():
    return Grounder.load()


@functools.cache
def parser():
    return Parser.load()


def scene(world):
    return Scene(Layout(world))


def group(number):
    return Noun(head="container", kinds=("group",), number=number, text=f"the group of {number}")


def gone(text, world):
    """What a text presupposes and is not there, in the likeliest parse."""
    return [str(missing) for missing in absences(parser().parse(text, 1)[0].tree, LiteralReader(scene(world)))]


def test_what_seems_stacked_from_above_lies_one_behind_the_other():
    assert looks_stacked(scene(AHEAD), TOWER)
    assert not looks_stacked(scene(LOOSE), TOWER)
    sideways = World(tuple(o if o.type == "table" else o.moved((o.position[1] + 0.4, o.position[0] - 0.4, HEIGHT))
                           for o in AHEAD.objects))  # fmt: skip
    assert not looks_stacked(scene(sideways), TOWER)


def test_a_number_that_nothing_has_is_held_by_nothing():
    assert held(group(6), scene(LINED)) < held(group(4), scene(LINED))
    several = Noun(head="block", plural=True, number=3, colors=("red",), text="the three red blocks")
    assert held(several, scene(LINED)) < 0.05


def test_a_noun_counts_however_well_the_rest_agrees():
    row = Missing("no group", FAINT, group(6), shape=True)
    assert is_missing(row, 1.0, scene(LINED), ("robot",))
    assert not is_missing(Missing("no group", FAINT, group(4), shape=True), 1.0, scene(LINED), ("robot",))


def test_people_speak_loosely_where_all_things_look_alike():
    alike = scene(laid(**{f"b{i}": ("red", x, y) for i, (_, x, y) in enumerate(ROW)}))
    loose = Missing("none", FAINT, Noun(head="block", text="the one behind it"))
    assert not is_missing(loose, 0.5, alike, ("robot",))
    assert is_missing(Missing("none", FIRM), 0.5, alike, ("robot",))


@pytest.mark.parametrize(
    ("text", "world"),
    [
        ("take the second block from the bottom of the tower", LOOSE),
        ("pick up the block opposite of the row of seven", LINED),
        ("get the fifth block in the row of four", LINED),
        ("take the block that looks like the purple elephants above the green one of the tower", LOOSE),
    ],
)
def test_what_is_presupposed_is_looked_for_within_a_text(text, world):
    assert gone(text, world)


@pytest.mark.parametrize("text", ["take the yellow block", "build the tower with the red block", "take a red block"])
def test_nothing_is_missing_of_what_is_there_or_is_to_be_built(text):
    assert not gone(text, LOOSE)


@pytest.mark.parametrize(
    ("text", "world"),
    [
        ("take the top block of the tower", LOOSE),
        ("get the third block of the stack of six", STACKED),
        ("there is a blue block next to a yellow block. pick it up", LOOSE),
        ("put the red block behind the two white blocks", LOOSE),
        ("move the yellow block behind five blocks", LOOSE),
        ("pick up the green block touching the yellow one", LOOSE),
        ("clear all the blocks to the left of the leftmost block", LOOSE),
    ],
)
def test_no_referent_is_invented(text, world):
    result = grounder().ground(text, world)
    assert result.outcome == "no_referent"
    assert result.explanation


@pytest.mark.parametrize(
    ("text", "world", "expected"),
    [
        ("take the top block of the tower", STACKED, "b"),
        ("take the leftmost block in the row of four", LINED, "r0"),
        ("take the second farthest block that is the farthest to the left", LOOSE, "b"),
    ],
)
def test_what_is_there_is_not_missed(text, world, expected):
    result = grounder().ground(text, world)
    assert result.outcome != "no_referent"
    if result.outcome == "grounded":
        assert result.actions[0].objects == (expected,)
