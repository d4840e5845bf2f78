"""Sets that several words may mean: bands cover what they part, clusters are apart, numbers are heeded."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import models
from grounding import World, load_world, make_object
from grounding.geometry.layout import Layout
from grounding.lexicon import arrangement
from grounding.world.scene import Scene

places = st.lists(st.tuples(st.integers(0, 12), st.integers(-14, 14)), min_size=1, max_size=9, unique=True)


def scene_of(cells):
    """Blocks on a grid of 6 cm, no two of which touch."""
    return Scene(
        Layout(World(tuple(make_object(f"b{i}", position=(0.4 + 0.06 * x, 0.06 * y, 0.736))
                           for i, (x, y) in enumerate(cells))))
    )  # fmt: skip


@given(places, st.sampled_from(["row", "column"]), st.sampled_from(arrangement.GAPS))
@settings(max_examples=60)
def test_bands_part_all_in_order(cells, kind, gap):
    scene = scene_of(cells)
    wanted = np.ones(scene.n, dtype=bool)
    parts = arrangement.partition(scene, wanted, kind, gap)
    assert np.array(parts).sum(axis=0).tolist() == [1] * scene.n
    axis = 0 if kind == "row" else 1
    for before, after in pairwise(parts):
        assert scene.xy[before, axis].min() - scene.xy[after, axis].max() > gap * scene.edge - 1e-9


@given(places)
@settings(max_examples=40)
def test_bands_leave_out_what_is_not_wanted(cells):
    scene = scene_of(cells)
    wanted = np.arange(scene.n) % 2 == 0
    for part in arrangement.partition(scene, wanted, "row", 0.6):
        assert not (part & ~wanted).any()


@given(places)
@settings(max_examples=40)
def test_clusters_are_sets_of_at_least_two_with_weights(cells):
    scene = scene_of(cells)
    for candidate in arrangement.clusters(scene, np.ones(scene.n, dtype=bool)):
        assert candidate.mask.sum() >= 2
        assert 0 <= candidate.looks <= 1


def test_two_heaps_are_two_clusters():
    scene = scene_of([(0, 10), (1, 10), (0, 11), (10, -10), (11, -10)])
    best = sorted(arrangement.clusters(scene, np.ones(5, dtype=bool)), key=lambda c: -c.looks)[:2]
    assert {frozenset(np.flatnonzero(c.mask).tolist()) for c in best} == {frozenset((0, 1, 2)), frozenset((3, 4))}


@pytest.mark.parametrize(
    ("name", "kind", "count", "members"),
    [
        ("default", "row", 5, {"b1", "b2", "b3", "b4", "b5"}), ("seven", "row", 4, {"b1", "b2", "b3", "b4"}),
        ("twelve", "column", 4, {"b10", "b7", "b8", "b9"}), ("tower", "tower", 3, {"b1", "b2", "b3"}),
        ("tower", "tower", 2, {"b4", "b5"}), ("groups", "row", 3, {"b6", "b7", "b8"}),
    ],
)  # fmt: skip
def test_arrangements_with_their_number(name, kind, count, members):
    scene = Scene(Layout(load_world(models.SCENES / f"{name}.json")))
    found = arrangement.candidates(scene, (kind,), np.ones(scene.n, dtype=bool), count)
    assert {scene.layout.ids[i] for i in np.flatnonzero(found[0].mask)} == members
    worth = [c.looks * arrangement.numbered(c.mask, count) for c in found]
    assert worth == sorted(worth, reverse=True)
    assert all(0 < held <= 1 for held in worth)


def test_a_missing_number_makes_doubtful():
    scene = Scene(Layout(load_world(models.SCENES / "seven.json")))
    right, wrong = (arrangement.candidates(scene, ("row",), np.ones(scene.n, dtype=bool), count) for count in (4, 9))
    assert max(c.looks * arrangement.numbered(c.mask, 4) for c in right) > 0.5
    assert max((c.looks * arrangement.numbered(c.mask, 9) for c in wrong), default=0.0) < 0.2


def test_plurals_are_all_that_match_or_so_many():
    scene = Scene(Layout(load_world(models.SCENES / "four.json")))
    red = np.array([item.color == "red" for item in scene.layout.things], dtype=float)
    (everything, *_) = arrangement.collected(scene, red, None, True)
    assert everything.mask.tolist() == (red > 0).tolist()
    assert everything.looks == 1
    (two, *_) = arrangement.collected(scene, red, 2, False)
    assert two.mask.tolist() == (red > 0).tolist()
    (too_few, *_) = arrangement.collected(scene, red, 3, False)
    assert too_few.mask.sum() == 2
    assert too_few.looks < 0.5
    assert arrangement.collected(scene, np.zeros(4), 2, False) == []


def test_who_counts_more_than_stand_out_means_the_next_as_well():
    scene = scene_of([(0, 0), (0, 2), (0, 4), (8, 9)])
    (three, *_) = arrangement.collected(scene, np.array([1.0, 0.2, 0.15, 0.001]), 3, False)
    assert three.mask.tolist() == [True, True, True, False]
    assert 0.1 < three.looks < 1
    for universal in (False, True):  # "all four" are four
        (four, *_) = arrangement.collected(scene, np.array([1.0, 0.2, 0.15, 0.001]), 4, universal)
        assert four.mask.all()
        assert four.looks < 0.2
