"""Measurements of a world: ranks, selections and sets, and that a mirror swaps left and right."""

import functools
import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grounding.corpus.composer import compose
from grounding.geometry.layout import ABSOLUTE, Layout
from grounding.geometry.masks import indices_of, single
from grounding.symbols import LAST
from grounding.world import World, make_object

seeds = st.integers(0, 199)
DIRECTIONS = (*ABSOLUTE, "center")
SWAPPED = {"left": "right", "right": "left"}


@functools.cache
def layout_of(seed):
    return Layout(compose(np.random.default_rng(seed)).world)


@st.composite
def layouts_and_sets(draw):
    layout = layout_of(draw(seeds))
    return layout, draw(st.integers(0, layout.everything))


def mirrored(layout):
    return Layout(World(tuple(item.moved(item.position * (1, -1, 1)) for item in layout.world.objects)))


@given(layouts_and_sets(), st.sampled_from(DIRECTIONS))
def test_ranks_are_an_order_of_the_set(given_, direction):
    layout, mask = given_
    order = layout.ranked(mask, direction)
    assert sorted(order) == list(indices_of(mask))
    if mask:
        extent = dict(zip(indices_of(mask), layout.extent(mask, direction), strict=True))
        values = [extent[i] for i in order]
        assert all(a > b - 2e-4 for a, b in itertools.pairwise(values))


@given(layouts_and_sets(), st.sampled_from(DIRECTIONS), st.integers(-3, 35))
def test_the_nth_is_the_nth_of_the_ranks(given_, direction, index):
    layout, mask = given_
    order = layout.ranked(mask, direction)
    chosen = layout.nth(mask, direction, index)
    if index == LAST and order:
        assert chosen == 1 << order[-1]
    elif 1 <= index <= len(order):
        assert chosen == 1 << order[index - 1]
        assert single(chosen)
    else:
        assert chosen == 0


@given(layouts_and_sets(), st.sampled_from(DIRECTIONS), st.integers(-1, 35))
def test_the_most_extreme_are_the_first_ones(given_, direction, count):
    layout, mask = given_
    chosen = layout.extreme(mask, direction, count)
    if 1 <= count <= mask.bit_count():
        assert chosen.bit_count() == count
        assert not chosen & ~mask
        assert all(layout.nth(mask, direction, i + 1) & chosen for i in range(count))
    else:
        assert chosen == 0


@given(layouts_and_sets(), st.sampled_from(DIRECTIONS))
def test_the_last_of_one_direction_is_the_first_of_the_other(given_, direction):
    layout, mask = given_
    pairs = {"left": "right", "front": "back", "near": "far", "top": "bottom"}
    if direction not in pairs or not mask:
        return
    extent = np.sort(layout.extent(mask, direction))
    if len(extent) < 2 or extent[1] - extent[0] > 1e-3:
        assert layout.nth(mask, direction, LAST) == layout.nth(mask, pairs[direction], 1)


@given(layouts_and_sets())
def test_the_median_has_as_many_on_either_side(given_):
    layout, mask = given_
    middle = layout.median(mask)
    if mask.bit_count() % 2 == 0:
        assert middle == 0
    else:
        assert single(middle)
        assert middle & mask


@pytest.mark.parametrize("direction", ["left", "back"])
@pytest.mark.parametrize("count", [1, 3, 5, 7])
def test_the_median_of_a_line_is_its_middle(count, direction):
    step = {"left": (0, 0.1, 0), "back": (0.1, 0, 0)}[direction]
    objects = [make_object(f"b{i}", position=np.array((0.6, 0, 0.7)) + np.multiply(step, i)) for i in range(count)]
    layout = Layout(World(tuple(objects)))
    assert layout.median(layout.everything) == 1 << count // 2
    assert layout.nth(layout.everything, direction, (count + 1) // 2) == 1 << count // 2


@given(layouts_and_sets(), st.sampled_from(DIRECTIONS))
@settings(max_examples=40)
def test_a_mirror_swaps_left_and_right(given_, direction):
    layout, mask = given_
    other = mirrored(layout)
    extent = layout.extent(mask, direction) if mask else np.zeros(0)
    np.testing.assert_allclose(
        extent, other.extent(mask, SWAPPED.get(direction, direction)) if mask else extent, atol=1e-12
    )
    if len(np.unique(np.round(extent, 3))) == len(extent):
        assert layout.ranked(mask, direction) == other.ranked(mask, SWAPPED.get(direction, direction))


@given(layouts_and_sets())
def test_names_and_masks_are_the_same_sets(given_):
    layout, mask = given_
    assert layout.mask(layout.names(mask)) == mask
    assert layout.mask((*layout.names(mask), "table", "nobody")) == mask


@given(seeds)
def test_matching_narrows(seed):
    layout = layout_of(seed)
    assert layout.matching(None, None) == layout.everything
    assert layout.matching("block", None) == layout.everything
    union = 0
    for color in layout.colors:
        chosen = layout.matching("block", color)
        assert {layout.things[i].color for i in indices_of(chosen)} == {color}
        union |= chosen
    assert union == layout.everything
    assert layout.matching("block", "no such colour") == 0
    assert layout.matching("elephant", None) == 0


def test_a_colour_nobody_knows_may_be_any_that_is_not_seen():
    objects = [make_object("a", color="red"), make_object("b", position=(0, 1, 0)), make_object("c", "mug")]
    layout = Layout(World(tuple(objects)))
    assert layout.names(layout.matching("block", "red")) == ("a",)
    assert layout.names(layout.matching("block", "blue")) == ("b",)


@given(seeds)
@settings(max_examples=25)
def test_clear_tops_carry_nothing(seed):
    layout = layout_of(seed)
    for i, item in enumerate(layout.things):
        carries = any(
            abs(other.position[2] - item.position[2] - (item.size[2] + other.size[2]) / 2) < 1e-3
            and (np.abs(other.position - item.position)[:2] < item.size[:2] / 2).all()
            for other in layout.things
        )
        assert bool(layout.clear_top >> i & 1) is not carries


@given(seeds, st.data())
def test_distances_are_to_the_nearest_reference(seed, data):
    layout = layout_of(seed)
    reference = tuple(data.draw(st.lists(st.sampled_from(layout.ids), min_size=1, max_size=3, unique=True)))
    distance = layout.distance_to(layout.everything, reference)
    for i, item in enumerate(layout.things):
        every = [np.linalg.norm((item.position - layout.world[name].position)[:2]) for name in reference]
        assert distance[i] == pytest.approx(min(every))


@pytest.mark.parametrize("count", [0, 1, 2])
@pytest.mark.parametrize("furniture", [0, 1])
def test_small_worlds(count, furniture):
    objects = [make_object(f"b{i}", position=(0.6, 0.2 * i, 0.7)) for i in range(count)]
    objects += [make_object("table", "table", position=(0.6, 0, 0.6), size=(1, 2, 0.1))] * furniture
    layout = Layout(World(tuple(objects)))
    assert layout.size == count
    assert layout.edge > 0
    for direction in DIRECTIONS:
        assert len(layout.ranked(layout.everything, direction)) == count
        assert layout.nth(layout.everything, direction, 1).bit_count() == min(count, 1)
        assert layout.ranked(0, direction) == ()
    assert layout.median(layout.everything).bit_count() == count % 2
    assert layout.clear_top == layout.everything
    assert all(a.count == 2 for a in layout.arrangements)
    assert set(layout.by_members) == {(a.kind, a.mask) for a in layout.arrangements}
