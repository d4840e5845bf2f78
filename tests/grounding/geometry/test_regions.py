"""Regions: what is left in the world is right in its mirror, and the words for places mean what people mean."""

import functools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.corpus.composer import compose
from grounding.corpus.tabletop import TABLE
from grounding.geometry.regions import in_region
from grounding.symbols import SPATIAL_REFERENCES
from grounding.world import make_object

seeds = st.integers(0, 199)
SWAPPED = {"left": "right", "right": "left"}
OPPOSITE = {"left": "right", "front": "back"}
Z = 0.736


@functools.cache
def world_of(seed):
    return compose(np.random.default_rng(seed)).world


def mirrored(items):
    return [item.moved(item.position * (1, -1, 1), item.orientation * (1, 1, 1, -1)) for item in items]


@st.composite
def references(draw):
    world = world_of(draw(seeds))
    return world.things, draw(st.lists(st.sampled_from(world.objects), min_size=1, max_size=4, unique_by=id))


@given(references(), st.sampled_from(SPATIAL_REFERENCES))
def test_a_mirror_swaps_left_and_right(given_, relation):
    things, reference = given_
    inside = in_region(relation, reference, things)
    other = in_region(SWAPPED.get(relation, relation), mirrored(reference), mirrored(things))
    assert inside.tolist() == other.tolist()


@given(references(), st.sampled_from(SPATIAL_REFERENCES))
def test_each_thing_is_judged_by_itself(given_, relation):
    things, reference = given_
    together = in_region(relation, reference, things)
    assert together.shape == (len(things),)
    assert together.tolist() == [bool(in_region(relation, reference, [item])[0]) for item in things]


@given(references(), st.sampled_from(sorted(OPPOSITE)))
def test_nothing_is_on_opposite_sides(given_, relation):
    things, reference = given_
    both = in_region(relation, reference, things) & in_region(OPPOSITE[relation], reference, things)
    assert not both.any()


@given(references(), st.sampled_from(("between", "center")))
def test_the_order_of_the_reference_says_nothing(given_, relation):
    things, reference = given_
    forth, back = in_region(relation, reference, things), in_region(relation, reference[::-1], things)
    assert forth.tolist() == back.tolist()


def block(x, y, z=Z, edge=0.05):
    return make_object(f"at {x} {y} {z}".replace(" ", "_"), position=(x, y, z), size=(edge,) * 3)


@pytest.mark.parametrize(
    ("relation", "place", "inside"),
    [
        ("left", (0.6, 0.2), True), ("left", (0.6, -0.2), False), ("right", (0.6, -0.2), True),
        ("back", (0.8, 0.0), True), ("back", (0.4, 0.0), False), ("front", (0.4, 0.0), True),
        ("left", (0.9, 0.1), False), ("near", (0.6, 0.08), True), ("near", (0.6, 0.4), False),
    ],
)  # fmt: skip
def test_beside_a_block(relation, place, inside):
    assert in_region(relation, [block(0.6, 0.0)], [block(*place)]).tolist() == [inside]


def test_on_and_under():
    low, high = block(0.6, 0.0), block(0.61, 0.01, Z + 0.05)
    assert in_region("top", [low], [high, block(0.6, 0.2, Z + 0.05)]).tolist() == [True, False]
    assert in_region("bottom", [high], [low, block(0.6, 0.2)]).tolist() == [True, False]


def test_between_two_and_amid_several():
    ends = [block(0.6, -0.3), block(0.6, 0.3)]
    asked = [block(0.6, 0.0), block(0.6, 0.5), block(0.9, 0.0), ends[0]]
    assert in_region("between", ends, asked).tolist() == [True, False, False, False]
    assert in_region("between", ends[:1], asked).tolist() == [False] * 4
    four = [block(x, y) for x in (0.4, 0.8) for y in (-0.3, 0.3)]
    assert in_region("between", four, asked[:2]).tolist() == [True, False]


@pytest.mark.parametrize(
    ("relation", "axis", "sign"), [("left", 1, 1), ("right", 1, -1), ("back", 0, 1), ("front", 0, -1)]
)
def test_a_table_has_halves(relation, axis, sign):
    things = [block(x, y) for x in (0.45, 0.85) for y in (-0.4, 0.4)]
    inside = in_region(relation, [TABLE], things)
    assert inside.tolist() == [sign * (item.position - TABLE.position)[axis] > 0 for item in things]


def test_nothing_asked_and_nothing_referred_to():
    assert in_region("left", [block(0.6, 0.0)], []).tolist() == []
    assert in_region("left", [], [block(0.6, 0.0)]).tolist() == [True]
