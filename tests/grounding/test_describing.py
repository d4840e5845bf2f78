"""Descriptions: a name tells an object from its rivals, and what is missing is what is missing."""

import functools
import re

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from grounding.corpus.composer import compose
from grounding.describing import name_object, name_objects
from grounding.geometry.layout import Layout
from grounding.world import World, make_object

DIRECTIONS = {"leftmost": "left", "rightmost": "right", "nearest": "near", "farthest": "far", "middle": "center"}
RANKS = {"": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "sixth": 6}


@functools.cache
def layout_of(seed):
    return Layout(compose(np.random.default_rng(seed)).world)


def meant(layout, text, among):
    """The objects that a name means, by a reading of its words."""
    match = re.fullmatch(r"the (?:(\w+) )??(?:(\w+) )?(?:(\w+) )?block(?: (\S+))?", text)
    assert match, text
    words = [word for word in match.groups()[:3] if word]
    if match.group(4):
        return {match.group(4)}
    pool, rank, direction = layout.mask(among), 1, None
    for word in words:
        if word in DIRECTIONS:
            direction = DIRECTIONS[word]
        elif word in RANKS:
            rank = RANKS[word]
        else:
            pool &= layout.matching("block", word)
    return set(layout.names(pool if direction is None else layout.nth(pool, direction, rank)))


@given(st.integers(0, 199), st.data())
def test_a_name_means_one_among_all_or_among_the_rivals(seed, data):
    layout = layout_of(seed)
    rivals = data.draw(st.lists(st.sampled_from(layout.ids), min_size=1, unique=True))
    name = data.draw(st.sampled_from(rivals))
    text = name_object(layout, name, rivals)
    assert {name} in (meant(layout, text, layout.ids), meant(layout, text, rivals))


@given(st.integers(0, 199))
def test_names_of_a_world_differ(seed):
    layout = layout_of(seed)
    names = [name_object(layout, name) for name in layout.ids]
    assert len(set(names)) == len(names)


def world(*colors):
    return World(tuple(make_object(f"b{i}", color=c, position=(0.6, 0.1 * i, 0.7)) for i, c in enumerate(colors)))


def test_examples():
    layout = Layout(world("red", "blue", "red"))
    assert name_object(layout, "b1") == "the blue block"
    assert name_object(layout, "b2") == "the leftmost red block"
    assert name_objects(layout, ("b1",)) == "the blue block"
    assert name_objects(layout, ("b0", "b1")) == "the rightmost red block and the blue block"
    assert name_objects(layout, ("b0", "b1", "b2")) == "the row of three"


def test_furniture_is_called_what_it_is():
    layout = Layout(World((*world("red").objects, make_object("t1", "table"))))
    assert name_object(layout, "t1") == "the table"
