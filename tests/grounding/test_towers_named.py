"""Things that carry things: what stands where, by colours, and what yields to what."""

import functools

import pytest

from grounding.grounder import Grounder
from grounding.world import World, make_object

EDGE = 0.05
STACKS = {
    (0.50, 0.30): ("red", "green", "blue^"), (0.70, 0.10): ("red", "blue"), (0.55, -0.10): ("blue",),
    (0.75, -0.35): ("yellow", "red"), (0.45, -0.35): ("green",),
}  # fmt: skip


@functools.cache
def grounder():
    return Grounder.load()


def world():
    objects = [make_object("table", "table", "white", (0.6, 0.0, -0.01), size=(0.7, 1.4, 0.02))]
    for (x, y), colors in STACKS.items():
        for level, said in enumerate(colors):
            kind, color = ("pyramid" if said.endswith("^") else "block"), said.rstrip("^")
            name = f"{color[0]}{level}{'^' if kind == 'pyramid' else ''}@{x:.2f}"
            objects.append(make_object(name, kind, color, (x, y, 0.025 + EDGE * level), size=(EDGE, EDGE, EDGE)))
    return World(tuple(objects))


WORLD = world()


@pytest.mark.parametrize(("text", "name"), [
    ("pick up the blue prism", "b2^@0.50"), ("take the blue block off the red block", "b1@0.70"),
    ("grab the block from the yellow one", "r1@0.75"), ("lift the pyramid from the red and green tower", "b2^@0.50"),
    ("take the blue block on the red block", "b1@0.70"), ("pick up the single blue cube", "b0@0.55"),
    ("pick up the red block", "r1@0.75"),  # the two others carry something
])  # fmt: skip
def test_what_is_picked_up(text, name):
    result = grounder().ground(text, WORLD)
    assert [a.objects for a in result.actions] == [(name,)], result


@pytest.mark.parametrize(("text", "below"), [
    ("put the single green block on the red-blue tower", "b1@0.70"), ("put the lone green block over the blue block "
     "on the red one", "b1@0.70"), ("move the green block standing alone above the red and yellow stack", "r1@0.75"),
    ("put the prism on the green block", "g0@0.45"),
])  # fmt: skip
def test_what_something_is_put_on(text, below):
    action = grounder().ground(text, WORLD).actions[0]
    assert action.destination.position[:2] == pytest.approx(tuple(WORLD[below].position[:2]), abs=1e-6)
    assert action.destination.position[2] == pytest.approx(WORLD[below].position[2] + EDGE)


def test_nothing_is_put_on_what_is_pointed():
    result = grounder().ground("put the single green block on the blue pyramid", WORLD)
    assert result.outcome != "grounded" or result.actions[0].destination.reference != ("b2^@0.50",)


WUGS = World((
    make_object("table", "table", "white", (0.6, 0.0, -0.01), size=(0.7, 1.4, 0.02)),
    make_object("near", "wug", "red", (0.5, 0.2, 0.025)), make_object("far", "wug", "blue", (0.7, -0.3, 0.025)),
    make_object("block", "block", "red", (0.6, -0.2, 0.025)),
))  # fmt: skip


@pytest.mark.parametrize(("text", "outcome", "name"), [
    ("pick up the nearest wug", "grounded", "near"), ("take the red wug", "grounded", "near"),
    ("take the block", "grounded", "block"), ("pick up the wug", "ambiguous", None),
    ("take the gizmo", "no_referent", None),
])  # fmt: skip
def test_a_type_of_the_world_is_a_word(text, outcome, name):
    result = grounder().ground(text, WUGS)
    assert result.outcome == outcome
    assert [a.objects for a in result.actions] == ([] if name is None else [(name,)])
