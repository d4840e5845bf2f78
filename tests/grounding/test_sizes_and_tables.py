"""Sizes of single things, and which of several tables is meant."""

import functools

import numpy as np
import pytest

from grounding.grounder import Grounder
from grounding.world import World, make_object


@functools.cache
def grounder():
    return Grounder.load()


def box(name, color, x, y, *size):
    return make_object(name, "block", color, (x, y, size[2] / 2), size=size)


def table(name, color, y):
    return make_object(name, "table", color, (0.65, y, -0.02), size=(0.6, 0.7, 0.04))


SIZES = World((
    table("table", "white", 0.0), box("big", "red", 0.6, 0.2, 0.08, 0.08, 0.08),
    box("small", "red", 0.6, -0.2, 0.04, 0.04, 0.04), box("tall", "blue", 0.75, 0.1, 0.04, 0.04, 0.12),
    box("flat", "blue", 0.75, -0.1, 0.1, 0.05, 0.03),
))  # fmt: skip
TABLES = World((
    table("left", "brown", 0.45), table("right", "white", -0.45), box("a", "red", 0.6, 0.4, 0.05, 0.05, 0.05),
    box("b", "red", 0.6, -0.4, 0.05, 0.05, 0.05), box("c", "blue", 0.75, -0.55, 0.05, 0.05, 0.05),
))  # fmt: skip


@pytest.mark.parametrize(("text", "name"), [
    ("pick up the big red block", "big"), ("take the small red one", "small"), ("grab the biggest block", "big"),
    ("pick up the tallest block", "tall"), ("lift the smaller of the red blocks", "small"),
    ("take the long blue block", "flat"),
])  # fmt: skip
def test_sizes_tell_things_apart_where_they_differ(text, name):
    assert [a.objects for a in grounder().ground(text, SIZES).actions] == [(name,)]


@pytest.mark.parametrize(("text", "name"), [
    ("pick up the red block on the left table", "a"), ("take the red block that is on the white table", "b"),
    ("grab the red block from the brown table", "a"),
])  # fmt: skip
def test_things_stand_on_the_table_that_is_named(text, name):
    assert [a.objects for a in grounder().ground(text, TABLES).actions] == [(name,)]


@pytest.mark.parametrize(("text", "on"), [
    ("put the blue block on the brown table", "left"), ("move the blue block to the other table", "left"),
    ("put the blue block on the right table", "right"), ("put the blue block next to the red block on the left table",
                                                         "left"),
])  # fmt: skip
def test_things_are_put_on_the_table_that_is_named(text, on):
    action = grounder().ground(text, TABLES).actions[0]
    there = TABLES[on]
    assert action.objects == ("c",)
    assert (np.abs(np.array(action.destination.position[:2]) - there.position[:2]) <= there.half_extents[:2]).all()


def test_what_is_on_another_table_is_not_there():
    assert grounder().ground("pick up the blue block on the brown table", TABLES).outcome == "no_referent"


def test_an_edge_is_where_the_table_ends():
    action = grounder().ground("put the big red block at the left edge of the table", SIZES).actions[0]
    assert action.destination.position[1] > 0.35 - 0.1
