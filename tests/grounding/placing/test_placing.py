"""Destinations: laws of mirrors, lengths and heights, and that every place is free and supported."""

import functools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import models
from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.model.belief import believe, read
from grounding.model.evaluator import EVEN
from grounding.model.phrases import PhraseReader
from grounding.placing import destination, find_spot
from grounding.world import FURNITURE, World, load_world, make_object
from grounding.world.scene import Scene

TABLE = load_world(models.SCENES / "four.json")["table"]
HEIGHT = 0.736  # of the centre of a block on the table
EDGE = 0.05
UP = np.array([0, 0, EDGE])


def laid(**blocks):
    """A world of blocks given as colour, x, y and, for those in a tower, how many lie below."""
    return World((TABLE, *(make_object(name, color=color, position=(x, y, HEIGHT + EDGE * sum(level)))
                           for name, (color, x, y, *level) in blocks.items())))  # fmt: skip


WORLD = laid(red=("red", 0.6, 0.1), blue=("blue", 0.75, 0.35), green=("green", 0.5, -0.35), base=("yellow", 0.7, -0.2),
             top=("purple", 0.7, -0.2, 1), gray=("gray", 0.5, 0.35))  # fmt: skip


@functools.cache
def parser():
    return Parser.load()


@functools.cache
def parsed(text):
    return tuple(parser().parse(text, 4))


def believed(text, world=WORLD):
    return believe(read(parsed(text), Scene(Layout(world))), EVEN)


def told(text, world=WORLD, moved="red"):
    return destination(believed(text, world), (moved,))


def where(text, world=WORLD, moved="red"):
    """The destination that a text tells, as (x, y, z)."""
    found = told(text, world, moved)
    assert found is not None, text
    return np.array(found.position)


def mirrored(world):
    return World(tuple(o.moved(o.position * (1, -1, 1)) for o in world.objects))


def swapped(text):
    sides = {"left": "right", "right": "left", "east": "west", "west": "east"}
    return " ".join(sides.get(word, word) for word in text.split())


PLAIN = [
    "move the red block two spaces to the left of the blue block",
    "put the red block to the right of the green block",
    "move the red block three spaces to the left",
    "slide the red block up two spaces and one to the right",
    "place the red block next to the blue block",
    "put the red block on the left side of the table",
    "put the red block between the gray block and the green block",
    "move the red block so that it is below the blue block and to the right of the gray block",
    "move the red block one space west of the green block",
    "put the red block in the top left corner of the table",
    "move the red block left until it touches the gray block",
]  # fmt: skip


@pytest.mark.parametrize("text", PLAIN)
def test_in_a_mirror_left_is_right(text):
    here, there = where(text), where(swapped(text), mirrored(WORLD))
    assert np.allclose(here * (1, -1, 1), there, atol=0.3 * EDGE)


DIRECTED = [("left of", (0, 1)), ("right of", (0, -1)), ("behind", (1, 0)), ("in front of", (-1, 0)),
            ("below", (-1, 0)), ("north of", (1, 0)), ("east of", (0, -1))]  # fmt: skip


@pytest.mark.parametrize(("said", "way"), DIRECTED)
@pytest.mark.parametrize("reference", ["blue", "green"])
def test_a_side_of_something_is_on_that_side_of_it(said, way, reference):
    offset = (where(f"put the red block {said} the {reference} block") - WORLD[reference].position)[:2]
    along, across = offset @ way, offset @ (way[1], -way[0])
    assert EDGE * 0.99 < along < 3 * EDGE
    assert abs(across) < 0.7 * EDGE


@pytest.mark.parametrize("said", ["above", "over", "on top of"])
def test_what_is_above_something_is_on_it_where_things_are_stacked(said):
    place = where(f"put the red block {said} the green block")
    assert np.allclose(place - WORLD["green"].position, (0, 0, EDGE), atol=1e-6)


def test_what_is_above_something_is_beyond_it_on_a_flat_table():
    world = laid(red=("red", 0.65, -0.1), blue=("blue", 0.8, -0.6))
    place = where("put the red block above the blue block", world)
    assert place[0] > world["blue"].position[0] + 0.9 * EDGE


@pytest.mark.parametrize(("said", "way"), [("to the left", (0, 1)), ("up", (1, 0)), ("south", (-1, 0))])
def test_a_space_more_is_a_space_farther(said, way):
    """Where nothing is in the way, every space leads on by about a block and the gap beside it."""
    world = laid(red=("red", 0.65, -0.1), blue=("blue", 0.8, -0.6))
    reach = [(where(f"move the red block {n} {said}", world) - world["red"].position)[:2] @ way
             for n in ("one space", "two spaces", "three spaces")]  # fmt: skip
    steps = np.diff([0.0, *reach]) / EDGE
    assert ((steps > 0.8) & (steps < 1.8)).all()


def test_two_spaces_from_a_block_are_farther_than_one():
    far = [(where(f"put the red block {n} left of the green block") - WORLD["green"].position)[1] for n in (
        "one space", "two spaces", "four spaces")]  # fmt: skip
    assert far[0] < far[1] - 0.5 * EDGE
    assert far[1] < far[2] - EDGE


def test_a_diagonal_goes_so_far_along_both_axes():
    offset = (where("move the red block two spaces northwest") - WORLD["red"].position)[:2] / EDGE
    assert offset[0] == pytest.approx(offset[1], abs=0.3)
    assert offset[0] > 1.8


@pytest.mark.parametrize(
    ("said", "metres"), [("20 cm", 0.2), ("200 mm", 0.2), ("0.15 meters", 0.15), ("6 inches", 0.1524)]
)
def test_metric_distances_are_metres(said, metres):
    start = WORLD["red"].position
    assert where(f"move the red block {said} to the right")[1] == pytest.approx(start[1] - metres, abs=0.4 * EDGE)


def test_a_corner_without_a_side_is_one_of_the_four():
    x, y, _ = where("put the red block in the corner")
    assert abs(x - TABLE.position[0]) > 0.4 * TABLE.half_extents[0]
    assert abs(y - TABLE.position[1]) > 0.4 * TABLE.half_extents[1]


def test_toward_you_is_toward_the_robot():
    before = WORLD["red"].position
    after = where("pull the red block towards you two spaces")
    assert after[0] < before[0] - EDGE
    assert abs(after[1] - before[1]) < EDGE
    assert where("push the red block one space toward me")[0] > before[0] + 0.5 * EDGE


@pytest.mark.parametrize("text", ["put the red block on top of the blue block", "stack the red block on the blue block",
                                  "move the red block onto the blue block"])  # fmt: skip
def test_on_top_has_the_height(text):
    found = told(text)
    assert np.allclose(found.position, WORLD["blue"].position + UP, atol=1e-6)
    assert (found.relation, found.reference) == ("top", ("blue",))


@pytest.mark.parametrize("text", ["put the red block on top of the tower", "stack the red block on the stack"])
def test_a_tower_grows_at_its_top(text):
    assert np.allclose(where(text), WORLD["top"].position + UP, atol=1e-6)


def test_of_two_constraints_both_hold():
    place = where("put the red block above the green block and to the right of the blue block")
    assert place[0] > WORLD["green"].position[0] + 0.9 * EDGE
    assert place[1] < WORLD["blue"].position[1] - 0.9 * EDGE


@pytest.mark.parametrize(
    ("text", "axis"),
    [
        ("move the red block up until it is in line with the blue block", 0),
        ("move the red block right until it is in the same column as the green block", 1),
    ],
)
def test_alignment_shares_a_coordinate(text, axis):
    reference = "blue" if axis == 0 else "green"
    place = where(text)
    assert abs(place[axis] - WORLD[reference].position[axis]) < 0.4 * EDGE
    assert abs(place[1 - axis] - WORLD["red"].position[1 - axis]) < EDGE


def test_between_is_between():
    place = where("put the red block between the blue block and the gray block")[:2]
    ends = [WORLD[name].position[:2] for name in ("blue", "gray")]
    assert np.linalg.norm(place - np.mean(ends, axis=0)) < 0.7 * EDGE


def test_its_side_touches_what_is_on_that_side():
    place = where("move the red block so that its left side touches the right side of the green block")
    assert EDGE * 0.99 < WORLD["green"].position[1] - place[1] < 1.4 * EDGE
    assert abs(place[0] - WORLD["green"].position[0]) < 0.5 * EDGE


def test_a_later_sentence_tells_where_it_is_then():
    place = where("Move the red block to the right. It is now left of the green block.")
    assert place[1] < WORLD["red"].position[1]
    assert 0.99 * EDGE < place[1] - WORLD["green"].position[1] < 3 * EDGE


def test_it_is_what_was_spoken_of_before():
    place = where("There is a green block. Move the red block to the left of it.")
    assert 0.99 * EDGE < place[1] - WORLD["green"].position[1] < 3 * EDGE


def test_directions_that_begin_again_lead_from_what_is_named_then():
    place = where("move the red block down and to the right, one space to the left of the green block")
    assert place[1] > WORLD["green"].position[1] + 0.99 * EDGE
    assert place[0] < WORLD["red"].position[0]


def test_what_is_certain_is_told_of():
    """A place that is told exactly is more certain than one that is left open."""
    found = []
    for text in ("put the red block on the blue block", "move the red block to the left"):
        reading = believed(text).readings[0]
        reader, source = PhraseReader(reading.evaluator), reading.evaluator.scene.layout.index["red"]
        found.append(find_spot(reading.told.destination, source, reader).certainty)
    assert 0 < found[1] < found[0] <= 1


def test_a_row_that_is_to_come_about():
    world = laid(red=("red", 0.5, -0.3), a=("blue", 0.7, 0.1), b=("blue", 0.7, 0.04), c=("green", 0.5, 0.5))
    place = where("move the red block next to the blue blocks to make a row of three", world)
    assert abs(place[0] - 0.7) < 0.3 * EDGE
    assert min(abs(place[1] - y) for y in (0.16, -0.02)) < EDGE


WAYS = [
    "put the red block next to the {0} block",
    "put the red block {1} the {0} block",
    "move the red block two spaces {1} the {0} block",
    "put the red block in the middle of the table",
    "put the red block at the left edge",
    "put the red block in the bottom right corner",
    "move the red block up slightly",
    "move the red block closer to the {0} block",
    "put the red block on the {0} block",
]
COLORS = ("blue", "green", "yellow", "purple", "orange", "gray", "white")


@st.composite
def crowds(draw):
    """Blocks that do not overlap, the red one among them."""
    cells = draw(st.lists(st.tuples(st.integers(0, 6), st.integers(0, 10)), min_size=4, max_size=8, unique=True))
    names = ("red", *COLORS)[: len(cells)]
    return laid(**{name: (name, 0.45 + 0.06 * x, -0.3 + 0.06 * y) for name, (x, y) in zip(names, cells, strict=True)})


@settings(deadline=None, max_examples=60)
@given(crowds(), st.sampled_from(WAYS), st.sampled_from(("left of", "right of", "behind", "below")), st.data())
def test_places_are_free_and_supported(world, way, side, data):
    color = data.draw(st.sampled_from([o.color for o in world.things if o.color != "red"]))
    found = told(way.format(color, side), world)
    if found is None:
        return
    placed = world["red"].moved(found.position)
    others = [o for o in world.objects if o.type not in FURNITURE and o.id != "red"]
    assert not any((np.abs(o.position - placed.position) < (o.size + placed.size) / 2 - 1e-5).all() for o in others)
    bottom = placed.position[2] - placed.half_extents[2]
    below = [o for o in (*others, TABLE) if abs(o.position[2] + o.half_extents[2] - bottom) < 1e-4]
    assert any((np.abs(o.position - placed.position)[:2] <= o.half_extents[:2]).all() for o in below)
    assert (np.abs(placed.position - TABLE.position)[:2] <= TABLE.half_extents[:2] - EDGE / 2 + 1e-5).all()


@settings(deadline=None, max_examples=30)
@given(crowds(), st.sampled_from(WAYS), st.permutations(range(4)), st.data())
def test_the_order_of_objects_says_nothing(world, way, order, data):
    color = data.draw(st.sampled_from([o.color for o in world.things if o.color != "red"]))
    things = [o for o in world.objects if o.type not in FURNITURE]
    shuffled = World((TABLE, *[things[i] for i in order], *things[4:]))
    text = way.format(color, "behind")
    first, second = told(text, world), told(text, shuffled)
    assert (first is None) == (second is None)
    if first is not None and len(things) > 5:
        assert np.linalg.norm(np.subtract(first.position, second.position)) < 3 * EDGE


def test_a_full_table_has_no_room():
    tight = make_object("table", "table", color="white", position=(0.6, 0.0, 0.691), size=(0.11, 0.11, 0.04))
    corners = {"red": (-1, -1), "blue": (1, -1), "green": (-1, 1), "yellow": (1, 1)}
    blocks = [make_object(c, color=c, position=(0.6 + 0.026 * x, 0.026 * y, HEIGHT)) for c, (x, y) in corners.items()]
    assert told("put the red block to the right of the blue block", World((tight, *blocks))) is None


@pytest.mark.parametrize("text", ["pick up the red block", "move the red block"])
def test_without_words_of_place_there_is_none(text):
    assert told(text) is None


def region(text, world=WORLD, moved="red"):
    """The other places that a text leaves, as (k, 3)."""
    found = told(text, world, moved)
    assert found is not None, text
    return np.array(found.region).reshape(-1, 3)


@pytest.mark.parametrize(("said", "way"), DIRECTED)
def test_all_other_places_are_on_the_side_that_was_said_and_free(said, way):
    others = [WORLD[name].position for name in ("blue", "green", "base", "gray")]
    places = region(f"put the red block {said} the green block")
    assert len(places) > 5
    for place in places:
        offset = (place - WORLD["green"].position)[:2]
        assert offset @ way > 0.9 * EDGE
        assert min(np.abs(place - other)[:2].max() for other in others) >= EDGE - 1e-6
        assert place[2] == pytest.approx(HEIGHT)
        assert np.all(np.abs(place - TABLE.position)[:2] <= TABLE.half_extents[:2])


def test_other_places_are_told_the_best_first_and_apart_from_each_other():
    places = region("put the red block next to the blue block")
    gaps = np.abs(places - WORLD["blue"].position)[:, :2].max(axis=1)
    assert gaps[0] <= gaps[-1]
    apart = np.abs(places[:, None] - places)[..., :2].max(axis=2) + np.eye(len(places))
    assert apart.min() > 0.3 * EDGE


@pytest.mark.parametrize("text", ["move the red block 10 cm to the left", "put the red block on the green block"])
def test_what_is_exact_leaves_no_other_place(text):
    places = region(text)
    assert all(np.linalg.norm(place - where(text)) < 0.2 * EDGE for place in places)


def test_where_its_lane_is_taken_a_side_is_aslant():
    row = laid(**{f"n{k}": ("blue", 0.6, 0.3 - 0.07 * k) for k in range(9)}, red=("red", 0.75, -0.6))
    offset = (where("put the red block to the left of the rightmost blue block", row) - row["n8"].position)[:2]
    assert offset[1] > 0.7 * EDGE
    assert 0.9 * EDGE < abs(offset[0]) < 3 * EDGE
