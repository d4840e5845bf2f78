"""Literal readings: laws of mirrors and of order, presuppositions, and silence where words are not read."""

import functools

import numpy as np
import pytest

import models
from grounding import Grounder
from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.literal import believe_literally, read_literally
from grounding.model.belief import believe
from grounding.model.belief import read as read_meanings
from grounding.model.evaluator import EVEN
from grounding.world import World, load_world, make_object
from grounding.world.scene import Scene

TABLE = load_world(models.SCENES / "four.json")["table"]
HEIGHT = 0.736  # of the centre of a block on the table
EDGE = 0.05
SIDES = {"left": "right", "right": "left", "leftmost": "rightmost", "rightmost": "leftmost"}


def laid(**blocks):
    """A world of blocks given as colour, x, y and, for those in a tower, how many lie below."""
    return World((TABLE, *(make_object(name, color=color, position=(x, y, HEIGHT + EDGE * sum(level)))
                           for name, (color, x, y, *level) in blocks.items())))  # fmt: skip


WORLD = laid(
    a=("red", 0.45, 0.5), b=("red", 0.62, 0.3), c=("blue", 0.62, 0.13), d=("green", 0.8, -0.1),
    e=("green", 0.8, -0.155), f=("yellow", 0.5, -0.42), g=("blue", 0.7, -0.6), top=("blue", 0.7, -0.6, 1),
)  # fmt: skip


@functools.cache
def parser():
    return Parser.load()


@functools.cache
def tree(text):
    return parser().parse(text, 1)[0].tree


def read(text, world=WORLD, history=()):
    return read_literally(tree(text), Scene(Layout(world)), history)


def options(text, world=WORLD):
    found = read(text, world)
    return None if found is None else set(found.options)


def mirrored(world):
    return World(tuple(o.moved(o.position * (1, -1, 1)) for o in world.objects))


TEXTS = [
    "pick up the leftmost block", "take the red block on the right", "the block to the left of the yellow block",
    "pick up the second block from the left", "grab the rightmost red block",
    "the green block to the right of the other", "pick up the two rightmost blocks",
    "the block in front of the leftmost blue block",
]  # fmt: skip


@pytest.mark.parametrize("text", TEXTS)
def test_a_mirrored_world_takes_mirrored_words(text):
    swapped = " ".join(SIDES.get(word, word) for word in text.split())
    assert options(text) == options(swapped, mirrored(WORLD))


@pytest.mark.parametrize("text", TEXTS)
def test_the_order_of_objects_does_not_matter(text):
    turned = World((WORLD.objects[0], *WORLD.objects[:0:-1]))
    found, again = options(text), options(text, turned)
    assert (found is None) == (again is None)
    assert {frozenset(names) for names in found or ()} == {frozenset(names) for names in again or ()}


def test_what_several_fit_is_left_open():
    assert options("take the red block") == {("a",), ("b",)}


def test_what_one_fits_is_meant():
    assert options("take the yellow block") == {("f",)}


@pytest.mark.parametrize(
    "text", ["pick up the third red block from the left", "take the three red blocks", "pick up the row of six blocks"]
)
def test_what_there_are_not_so_many_of_is_missing(text):
    found = read(text)
    assert not found.options
    assert found.missing


def test_what_lies_nowhere_is_missing():
    assert read("take the block behind the tower of two blocks").missing


def test_a_rank_sorts_all_that_is_there():
    order = [options(f"the {rank} block from the left") for rank in ("first", "second", "third", "fourth")]
    places = [WORLD[next(iter(found))[0]].position[1] for found in order]
    assert places == sorted(places, reverse=True)


def test_indefinite_references_are_existential():
    assert options("the yellow block") == {("f",)}
    touching = options("the block touching a green block")
    assert touching == {("d",), ("e",)}


def test_what_is_too_close_to_call_is_not_read():
    close = laid(a=("red", 0.5, 0.2), b=("red", 0.6, 0.204), c=("blue", 0.6, -0.3))
    assert read("take the leftmost block", close) is None


@pytest.mark.parametrize("text", ["take the yellow elephant", "take the block that is not red"])
def test_words_beyond_it_are_met_with_silence(text):
    assert read(text) is None


def test_it_is_what_was_handled_before():
    scene = Scene(Layout(WORLD))
    found = read_literally(tree("move it to the left"), scene, (scene.layout.index["c"],))
    assert found.options == (("c",),)


def test_a_destination_that_is_not_there_is_missing():
    assert read("put the yellow block next to the row of six blocks").missing
    assert "itself" in str(read("put the yellow block behind the yellow block").missing)


def test_it_is_open_where_to_if_the_place_is_that_of_several():
    rival = read("put the yellow block behind the red block").rival
    assert rival is not None
    assert rival.text == "the red block"
    assert len(rival.ids) > 1
    assert read("put the yellow block behind a red block").rival is None


def test_relations_are_marked_as_vague():
    assert not read("take the leftmost block").vague
    assert read("the block to the left of the yellow block").vague


def test_belief_prefers_what_singles_something_out():
    scene = Scene(Layout(WORLD))
    parses = parser().parse("put the block on the right of the yellow block on the table", 4)
    meant = believe(read_meanings(parses, scene), EVEN)
    belief = believe_literally(parses, scene, meant)
    likely = [read_literally(parses[r.place].tree, scene) for r, share in zip(meant.readings, meant.shares, strict=True)
              if share > 0.1]  # fmt: skip
    assert len(belief.options) == min(len(found.options) for found in likely if found is not None and found.options)
    assert np.isclose(sum(share for _, share in belief.options), 1.0)


@functools.cache
def grounder():
    return Grounder.load()


@pytest.mark.parametrize(
    ("text", "outcome"),
    [
        ("take the yellow block", "grounded"),
        ("take the red block", "ambiguous"),
        ("take the third red block from the left", "no_referent"),
        ("put the yellow block next to the row of six blocks", "no_referent"),
        ("put the yellow block behind the red block", "ambiguous"),
    ],
)
def test_outcomes_follow(text, outcome):
    result = grounder().ground(text, WORLD)
    assert result.outcome == outcome
    assert result.explanation or outcome == "grounded"


def test_what_is_read_literally_alone_is_answered():
    alone = Grounder(grounder().parser, grounder().learned, without=("meanings",))
    result = alone.ground("take the yellow block", WORLD)
    assert result.outcome == "grounded"
    assert result.actions[0].objects == ("f",)
    assert result.phrases


SPREAD = laid(a=("red", 0.5, 0.2), b=("red", 0.6, 0.32), c=("red", 0.7, 0.61), d=("red", 0.6, -0.3))


@pytest.mark.parametrize(
    ("text", "ids"),
    [
        ("take the three blocks on the left", "abc"),
        ("clear the left side of the table", "abc"),
        ("take all four blocks", "abcd"),
    ],
)
def test_sets_that_hold_literally_are_meant_though_nothing_but_places_tells_blocks_apart(text, ids):
    result = grounder().ground(text, SPREAD)
    assert result.outcome == "grounded"
    assert result.actions[0].objects == tuple(ids)


def test_the_top_block_may_be_the_highest_of_all():
    far = laid(a=("red", 0.45, 0.5), b=("red", 0.45, 0.5, 1), c=("green", 0.45, 0.445), d=("red", 0.8, -0.3),
               e=("green", 0.8, -0.355))  # fmt: skip
    flat = World(tuple(o for o in far.objects if o.id != "b"))
    assert grounder().ground("take the green block touching the top red block", flat).actions[0].objects == ("e",)
    believed = grounder().understand("take the top red block", far).options()
    assert {option.objects for option in believed[:2]} == {("b",), ("d",)}


def test_what_lies_on_the_table_is_all_that_is_there_unless_one_alone_lies_on_it_directly():
    assert options("take the highest block on the table") == {("top",)}
    assert options("take all the blue blocks on the table") == {("c", "g", "top")}
    stacked = laid(a=("blue", 0.7, -0.6), b=("blue", 0.7, -0.6, 1), c=("red", 0.5, 0.2))
    assert options("take the blue block on the table", stacked) == {("a",)}


def test_what_is_outside_of_a_row_is_no_part_of_it():
    row = {f"r{i}": ("red", 0.6, 0.3 - 0.1 * i) for i in range(4)}
    world = laid(**row, out=("red", 0.85, 0.3), blue=("blue", 0.6, -0.5))
    assert options("take the red block outside the row", world) == {("out",)}
    assert options("take the red block outside of the row of four", world) == {("out",)}


@pytest.mark.parametrize(
    "text",
    ["make a tower of two by putting the leftmost red block on the yellow block",
     "put the leftmost red block on the yellow block to make a tower of two"],
)  # fmt: skip
def test_what_is_to_be_made_need_not_be_there(text):
    flat = World(tuple(o for o in WORLD.objects if o.id != "top"))
    result = grounder().ground(text, flat)
    assert result.outcome == "grounded"
    assert [(a.action, a.objects) for a in result.actions] == [("place", ("a",))]


def test_who_asks_for_something_to_be_made_of_nothing_that_is_named_is_told_what_to_say():
    flat = World(tuple(o for o in WORLD.objects if o.id != "top"))
    assert "which block goes where" in grounder().ground("build a tower of nine", flat).explanation
    assert "to make one" not in grounder().ground("lift the top block of the tower of nine", flat).explanation


@pytest.mark.parametrize(("verb", "kind"), [("remove", "clear"), ("take", "pick")])
def test_what_only_the_literal_reading_proposes_is_handled_as_is_said(verb, kind):
    result = grounder().ground(f"{verb} all blocks on the left", SPREAD)
    assert {a.action for a in (*result.actions, *result.alternatives)} == {kind}
