"""Measures of shapes: free of scale, place and order; a quarter turn makes columns of rows; laid shapes are good."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grounding.corpus.tabletop import heap, line, ring
from grounding.geometry.shapes import FAR, MEASURES, Subsets, measure
from grounding.space import ARRANGEMENT_KINDS

EDGE = 0.05
NAMES = {name: i for i, name in enumerate(MEASURES)}
seeds = st.integers(0, 2**32 - 1)
kinds = st.sampled_from(ARRANGEMENT_KINDS)
TOGETHER = {"rtol": 1e-5, "atol": 1e-6}


def scattered(seed, count=7, sets=12):
    """Places without ties, and sets of them."""
    rng = np.random.default_rng(seed)
    members = rng.random((sets, count)) < rng.uniform(0.3, 0.9)
    members[:, :2] |= members.sum(axis=1, keepdims=True) < 2  # the axis of a point is anything
    return rng.uniform(-0.5, 0.5, (count, 3)), members


def upright(places):
    return np.column_stack([places, np.full(len(places), 0.7)])


def measured(kind, places, members=None, edge=EDGE):
    places = np.asarray(places, dtype=float)
    places = upright(places) if places.shape[1] == 2 else places
    members = np.ones((1, len(places)), dtype=bool) if members is None else members
    return measure(kind, Subsets(places, edge, members))


def of(values, name):
    return values[:, NAMES[name]]


@given(seeds, kinds)
@settings(max_examples=40)
def test_a_batch_is_as_good_as_one_by_one(seed, kind):
    places, members = scattered(seed)
    whole = measured(kind, places, members)
    assert whole.shape == (len(members), len(MEASURES))
    single = [measured(kind, places, row[None]) for row in members]
    np.testing.assert_allclose(whole, np.concatenate(single), **TOGETHER)


@given(seeds, kinds)
@settings(max_examples=40)
def test_values_are_bounded(seed, kind):
    places, members = scattered(seed)
    values = measured(kind, places, members)
    assert np.isfinite(values).all()
    assert (values >= 0).all()
    assert (values <= FAR).all()
    for name in ("likelihood", "coherence", "ordering", "orientation"):
        assert (of(values, name) <= 1 + 1e-9).all()


@given(seeds, kinds, st.floats(0.2, 5))
@settings(max_examples=40)
def test_scale_says_nothing(seed, kind, scale):
    places, members = scattered(seed)
    np.testing.assert_allclose(
        measured(kind, places, members), measured(kind, places * scale, members, EDGE * scale), rtol=1e-4, atol=1e-5
    )


@given(seeds, kinds, st.floats(-3, 3), st.floats(-3, 3))
@settings(max_examples=40)
def test_place_says_nothing(seed, kind, x, y):
    places, members = scattered(seed)
    np.testing.assert_allclose(
        measured(kind, places, members), measured(kind, places + np.array((x, y, 0.3)), members), rtol=1e-4, atol=1e-5
    )


@given(seeds, kinds)
@settings(max_examples=40)
def test_order_says_nothing(seed, kind):
    places, members = scattered(seed)
    order = np.random.default_rng(seed).permutation(len(places))
    np.testing.assert_allclose(
        measured(kind, places, members), measured(kind, places[order], members[:, order]), **TOGETHER
    )


@given(seeds, kinds)
@settings(max_examples=40)
def test_a_mirror_changes_nothing(seed, kind):
    places, members = scattered(seed)
    mirrored = places * (1, -1, 1)
    np.testing.assert_allclose(measured(kind, places, members), measured(kind, mirrored, members), **TOGETHER)


@given(seeds)
@settings(max_examples=40)
def test_a_quarter_turn_makes_columns_of_rows(seed):
    places, members = scattered(seed)
    turned = np.column_stack([-places[:, 1], places[:, 0], places[:, 2]])
    np.testing.assert_allclose(measured("row", places, members), measured("column", turned, members), **TOGETHER)
    for kind in ("group", "circle", "tower"):
        np.testing.assert_allclose(measured(kind, places, members), measured(kind, turned, members), **TOGETHER)


@pytest.mark.parametrize("count", range(3, 9))
@pytest.mark.parametrize(("kind", "direction"), [("row", np.pi / 2), ("column", 0.0)])
def test_even_lines_are_perfect(kind, direction, count):
    alone = measured(kind, line(count, 0.08, direction))
    for name, value in (("likelihood", 1), ("fit", 0), ("coherence", 1), ("ordering", 1), ("orientation", 0)):
        assert of(alone, name) == pytest.approx(value, abs=1e-6)
    other = measured("row" if kind == "column" else "column", line(count, 0.08, direction))
    assert of(other, "orientation") == pytest.approx(1)


def test_a_row_that_goes_on_is_not_distinct():
    places = line(6, 0.08, np.pi / 2)
    members = np.ones((2, 6), dtype=bool)
    members[1, 5] = False
    apart = np.concatenate([places, [[1.0, 1.0]]])
    whole, part = measured("row", apart, np.column_stack([members, [False, False]]))
    assert whole[NAMES["distinction"]] > 2
    assert part[NAMES["distinction"]] == pytest.approx(0, abs=1e-6)
    assert whole[NAMES["separation"]] > part[NAMES["separation"]] == pytest.approx(1)


def test_something_in_between_spoils_the_order():
    places = line(5, 0.08, np.pi / 2)
    members = np.array([[True, True, False, True, True]])
    assert of(measured("row", places, members), "ordering") == pytest.approx(4 / 5)


@pytest.mark.parametrize("count", range(5, 10))
@given(start=st.floats(0, 6.3))
@settings(max_examples=10)
def test_rings_are_circles(count, start):
    values = measured("circle", ring(count, 0.1, start))
    for name, value in (("likelihood", 1), ("fit", 0), ("coherence", 1), ("ordering", 1)):
        assert of(values, name) == pytest.approx(value, abs=1e-3)


@pytest.mark.parametrize("count", range(3, 6))
def test_what_is_in_line_is_no_circle(count):
    values = measured("circle", line(count, 0.08, 0.3))
    assert of(values, "likelihood") == 0
    assert of(values, "fit") == FAR


@pytest.mark.parametrize("count", range(2, 6))
def test_towers(count):
    places = np.array([(0.6, 0.1, 0.7 + EDGE * level) for level in range(count)] + [(0.6, 0.5, 0.7)])
    members = np.ones((2, count + 1), dtype=bool)
    members[0, -1] = False
    tower, not_one = measured("tower", places, members)
    assert tower[NAMES["fit"]] == pytest.approx(0, abs=1e-9)
    assert tower[NAMES["coherence"]] == pytest.approx(1)
    assert tower[NAMES["orientation"]] == pytest.approx(0, abs=1e-6)
    assert not_one[NAMES["fit"]] > 1


@given(seeds, st.integers(3, 6))
@settings(max_examples=20)
def test_a_heap_apart_is_a_group(seed, count):
    places = np.concatenate([heap(count, 0.08, np.random.default_rng(seed)), [[1.5, 0.0], [0.0, 1.5]]])
    members = np.zeros((2, count + 2), dtype=bool)
    members[0, :count] = True
    members[1] = True
    group, everything = measured("group", places, members)
    assert group[NAMES["likelihood"]] == 1
    assert group[NAMES["separation"]] > 2
    assert group[NAMES["fit"]] < everything[NAMES["fit"]]


@pytest.mark.parametrize("kind", ARRANGEMENT_KINDS)
@pytest.mark.parametrize("places", [np.zeros((1, 3)), np.zeros((3, 3)), np.full((2, 3), 0.3)])
def test_a_lone_object_and_objects_in_one_place_do_no_harm(kind, places):
    assert np.isfinite(measured(kind, places)).all()
