"""Arrangements: what is laid is found, whatever the objects are called, wherever they lie, seen in a mirror or not."""

import functools
from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grounding.corpus.composer import compose
from grounding.corpus.tabletop import heap, line, ring
from grounding.geometry.arrangements import find_arrangements
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of, mask_of
from grounding.world import World, make_object

EDGE = 0.05
seeds = st.integers(0, 2**32 - 1)


@functools.cache
def composed(seed):
    return compose(np.random.default_rng(seed))


def arrangements_in(places):
    """All that is found among cubes on the floor plan, or in space."""
    places = np.asarray(places, dtype=float)
    if places.shape[1] == 2:
        places = np.column_stack([places, np.full(len(places), 0.7)])
    return find_arrangements(places, np.full(len(places), EDGE))


def found_in(places):
    """(kind, indices) of all that is found."""
    return {(a.kind, tuple(indices_of(a.mask))) for a in arrangements_in(places)}


def members(world):
    """(kind, ids) of all that is found in a world, with how well it is formed."""
    layout = Layout(world)
    return {
        (a.kind, frozenset(layout.names(a.mask))): np.round([a.deviation, a.regularity, a.separation, a.angle], 6)
        for a in layout.arrangements
    }


def same(first, second):
    assert set(first) == set(second)
    for key, measures in first.items():
        np.testing.assert_allclose(measures, second[key], atol=1e-4, rtol=1e-3)


def mapped(world, place):
    return World(tuple(item.moved(place(item.position)) for item in world.objects))


@given(seeds)
@settings(max_examples=15)
def test_a_mirror_keeps_rows_rows(seed):
    world = composed(seed % 500).world
    same(members(world), members(mapped(world, lambda p: p * (1, -1, 1))))


@given(seeds, st.floats(-0.5, 0.5))
@settings(max_examples=15)
def test_moving_everything_aside_changes_nothing(seed, shift):
    world = composed(seed % 500).world
    same(members(world), members(mapped(world, lambda p: p + np.array((0, shift, 0)))))


@given(seeds)
@settings(max_examples=15)
def test_a_quarter_turn_makes_columns_of_rows(seed):
    world = composed(seed % 500).world
    turned = members(mapped(world, lambda p: np.array([p[1], p[0], p[2]])))
    swap = {"row": "column", "column": "row"}
    for (kind, ids), measures in members(world).items():
        if kind in swap and measures[3] < np.pi / 4 - 1e-3:
            assert (swap[kind], ids) in turned


@given(seeds, st.randoms(use_true_random=False))
@settings(max_examples=15)
def test_order_and_names_say_nothing(seed, random):
    world = composed(seed % 500).world
    names = [item.id for item in world.things]
    others = [f"z{i}" for i in range(len(names))]
    random.shuffle(others)
    rename = dict(zip(names, others, strict=True))
    objects = [
        make_object(rename.get(o.id, o.id), o.type, o.color, o.position, o.orientation, o.size) for o in world.objects
    ]
    random.shuffle(objects)
    renamed = {(kind, frozenset(rename[i] for i in ids)): m for (kind, ids), m in members(world).items()}
    same(renamed, members(World(tuple(objects))))


def test_what_is_composed_is_found():
    laid, found = Counter(), Counter()
    for seed in range(100):
        composition = composed(seed)
        layout = Layout(composition.world)
        for container in composition.containers:
            laid[container.kind] += 1
            found[container.kind] += (container.kind, layout.mask(container.objects)) in layout.by_members
    lines = {kind: found[kind] / laid[kind] for kind in ("row", "column")}
    assert found["tower"] == laid["tower"]
    assert found["circle"] >= 0.95 * laid["circle"]
    assert min(lines.values()) >= 0.9
    assert sum(lines.values()) / 2 >= 0.93
    assert found["group"] >= 0.6 * laid["group"]  # clutter near a group makes another group of it


@pytest.mark.parametrize("count", range(2, 9))
@pytest.mark.parametrize(("kind", "direction"), [("row", np.pi / 2), ("column", 0.0)])
def test_lines(kind, direction, count):
    everything = tuple(range(count))
    assert (kind, everything) in found_in(line(count, 0.08, direction))
    for lean in (-0.3, 0.3):
        assert (kind, everything) in found_in(line(count, 0.08, direction + lean))


def test_a_line_ends_where_the_gap_is_wide():
    places = np.concatenate([line(4, 0.07, np.pi / 2), [[0.0, 0.5]]])
    rows = {a.mask: a.prominence for a in arrangements_in(places) if a.kind == "row"}
    assert max(rows, key=rows.__getitem__) == 0b1111


@pytest.mark.parametrize("count", range(5, 10))
@given(start=st.floats(0, 6.3))
@settings(max_examples=10)
def test_rings(count, start):
    assert ("circle", tuple(range(count))) in found_in(ring(count, 0.08, start))


@pytest.mark.parametrize("count", range(2, 6))
def test_towers(count):
    places = [(0.6, 0.1, 0.7 + EDGE * level) for level in range(count)] + [(0.6, 0.5, 0.7)]
    found = found_in(places)
    assert ("tower", tuple(range(count))) in found
    assert not any(kind == "tower" and members_ != tuple(range(count)) for kind, members_ in found)
    assert not any(a.evident for a in arrangements_in(places) if a.kind in ("row", "column", "circle"))


@given(seeds, st.integers(3, 7))
def test_groups_apart_from_the_rest(seed, count):
    places = heap(count, 0.08, np.random.default_rng(seed))
    everything = tuple(range(count))
    assert ("group", everything) in found_in(np.concatenate([places, [[1.5, 0.0], [0.0, 1.5]]]))


@given(st.lists(st.tuples(*[st.floats(-1, 1)] * 3), max_size=12))
def test_any_places_can_be_looked_at(places):
    found = find_arrangements(np.array(places).reshape(-1, 3), np.full(len(places), EDGE))
    for a in found:
        assert a.count == a.mask.bit_count() >= 2
        assert a.mask < 1 << len(places)
        assert np.isfinite([a.deviation, a.regularity, a.separation, a.angle, a.prominence]).all()
        assert 0 <= a.regularity <= 1
        assert isinstance(a.evident, bool)
    assert len({(a.kind, a.mask) for a in found}) == len(found)


@pytest.mark.parametrize("count", [0, 1, 2])
def test_few_objects(count):
    assert len(found_in(np.zeros((count, 2)) + np.arange(count)[:, None])) <= 2


@pytest.mark.parametrize("together", [3, 6])
def test_objects_in_one_place_do_no_harm(together):
    found_in(np.zeros((together, 2)))


def test_two_hundred_objects():
    rng = np.random.default_rng(0)
    places = rng.uniform((0.3, -1.5), (2.0, 1.5), (200, 2))
    places[:7] = np.array((0.2, 0.0)) + line(7, 0.08, np.pi / 2)
    found = found_in(places)
    assert any(kind == "row" and set(range(7)) <= set(m) for kind, m in found)


def test_prominent_ones_share_no_member_within_a_kind():
    for seed in range(20):
        layout = Layout(composed(seed).world)
        taken = Counter()
        kept = layout.prominent(layout.arrangements)
        assert list(kept) == sorted(kept, key=lambda a: -a.prominence)
        for a in kept:
            assert not taken[a.kind] & a.mask
            taken[a.kind] |= a.mask


@given(st.frozensets(st.integers(0, 300)))
def test_masks_are_sets(indices):
    assert list(indices_of(mask_of(indices))) == sorted(indices)
    assert mask_of(indices).bit_count() == len(indices)
