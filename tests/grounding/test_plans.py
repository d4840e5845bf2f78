"""What takes several moves: the moves leave what was asked for, or it is said why they cannot be made."""

import functools

import numpy as np
import pytest

from grounding.course import world_after
from grounding.grounder import Grounder
from grounding.world import World, make_object

EDGE = 0.05


@functools.cache
def grounder():
    return Grounder.load()


def thing(name, color, x, y, z=0.025, kind="block"):
    return make_object(name, kind, color, (x, y, z), size=(EDGE, EDGE, EDGE))


WORLD = World((
    make_object("table", "table", "white", (0.6, 0.0, -0.01), size=(0.7, 1.4, 0.02)),
    thing("r1", "red", 0.5, 0.3), thing("r2", "red", 0.62, -0.3), thing("b1", "blue", 0.7, 0.2),
    thing("b2", "blue", 0.6, -0.1), thing("low", "green", 0.6, 0.5), thing("high", "yellow", 0.6, 0.5, 0.075),
    thing("tip", "orange", 0.45, 0.0, kind="pyramid"),
))  # fmt: skip


def after(text, world=WORLD):
    """The world after all moves that a text asks for."""
    result = grounder().ground(text, world)
    assert result.outcome == "grounded", result
    for action in result.actions:
        assert action.action == "place"
        for other in world.things:
            if other.id not in action.objects:
                apart = np.abs(np.array(action.destination.position) - other.position)
                assert (apart > 0.9 * EDGE).any(), f"{action.objects} would be put into {other.id}"
        world = world_after(world, action)
    return world


@pytest.mark.parametrize("text", [
    "swap the nearest red block and the farthest blue block", "exchange the leftmost red block and the "
    "leftmost blue block", "switch the positions of the two red blocks",
])  # fmt: skip
def test_what_is_swapped_stands_where_the_other_stood(text):
    world = after(text)
    moved = [item.id for item in WORLD.things if not np.allclose(item.position, world[item.id].position)]
    assert len(moved) == 2
    first, second = moved
    assert world[first].position == pytest.approx(WORLD[second].position)
    assert world[second].position == pytest.approx(WORLD[first].position)


@pytest.mark.parametrize(("text", "names"), [
    ("stack the red blocks", {"r1", "r2"}), ("build a tower of the two blue blocks", {"b1", "b2"}),
    ("make a tower with the orange pyramid and the nearest red block", {"tip", "r1", "r2"}),
])  # fmt: skip
def test_what_is_stacked_is_one_tower_with_what_is_pointed_on_top(text, names):
    world = after(text)
    tower = sorted((world[name] for name in names if world[name].position[2] > 0.03 or any(
        np.allclose(world[name].position[:2], world[o].position[:2]) for o in names - {name})),
        key=lambda item: item.position[2])  # fmt: skip
    assert len(tower) >= 2
    assert [item.position[2] for item in tower] == pytest.approx([0.025 + EDGE * i for i in range(len(tower))])
    assert all(item.type == "block" for item in tower[:-1])


def test_a_tower_is_taken_apart_from_its_top():
    result = grounder().ground("take the tower apart", WORLD)
    assert [(a.action, a.objects) for a in result.actions] == [("clear", ("high",))]


@pytest.mark.parametrize(("text", "says"), [
    ("build a tower of three blocks", "of which blocks"), ("swap the green block and the nearest red block", "carries"),
    ("unstack the red blocks", "stacked"),
])  # fmt: skip
def test_what_cannot_be_done_so_is_refused_with_a_remedy(text, says):
    result = grounder().ground(text, WORLD)
    assert result.outcome in ("not_understood", "no_referent")
    assert says in result.explanation
