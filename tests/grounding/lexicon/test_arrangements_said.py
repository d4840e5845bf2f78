"""Arrangements that nouns may mean: rows and columns, clusters and towers, and what a plural may mean."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import Setting, settings_of_blocks

import models
from grounding import load_world
from grounding.geometry.layout import Layout
from grounding.lexicon import arrangement
from grounding.world.scene import Scene

ROW = [(0.6, 0.08 * i) for i in range(4)]
FAR = [(0.9, -0.5), (0.45, -0.45)]
ALL = ("row", "column", "diagonal", "group", "circle", "tower")


def scene_of(points):
    return Setting(np.array(points), ("red",) * len(points)).scene()


def members(scene, found):
    return [frozenset(scene.layout.ids[i] for i in np.flatnonzero(candidate.mask)) for candidate in found]


def test_a_row_looks_most_like_a_row():
    scene = scene_of([*ROW, *FAR])
    found = arrangement.candidates(scene, ("row",), np.ones(scene.n, bool))
    assert members(scene, found)[0] == {"b0", "b1", "b2", "b3"}


def test_a_turned_row_is_a_column():
    scene = scene_of([(0.45 + y, 0.0) for _, y in ROW] + [(0.5, 0.5)])
    found = arrangement.candidates(scene, ("column",), np.ones(scene.n, bool))
    assert members(scene, found)[0] == {"b0", "b1", "b2", "b3"}


def test_a_number_decides_between_sets():
    scene = scene_of([*ROW, *[(0.8, 0.5 + 0.08 * i) for i in range(3)]])
    everything = np.ones(scene.n, bool)
    for number, expected in ((4, {"b0", "b1", "b2", "b3"}), (3, {"b4", "b5", "b6"})):
        assert members(scene, arrangement.candidates(scene, ("row",), everything, number))[0] == expected


def test_towers_are_what_is_stacked():
    scene = Scene(Layout(load_world(models.SCENES / "tower.json")))
    found = arrangement.candidates(scene, ("tower",), np.ones(scene.n, bool))
    assert set(members(scene, found)) == {frozenset({"b1", "b2", "b3"}), frozenset({"b4", "b5"})}


@given(settings_of_blocks(), st.sampled_from(ALL), st.none() | st.integers(2, 5))
@settings(max_examples=40, deadline=None)
def test_what_is_found_is_a_set_of_wanted_ones_and_looks_between_0_and_1(setting, kind, number):
    scene = setting.scene()
    wanted = np.array([item.color != "blue" for item in scene.layout.things])
    found = arrangement.candidates(scene, (kind,), wanted, number)
    keys = [candidate.mask.tobytes() for candidate in found]
    assert len(set(keys)) == len(keys)
    for candidate in found:
        assert 0 <= candidate.looks <= 1
        assert candidate.mask.any()
        assert not (candidate.mask & ~wanted).any()
    if found:
        shadows = arrangement.overshadowed(found)
        assert (shadows <= 0).all()
        assert shadows.max() == pytest.approx(0)


@given(settings_of_blocks(), st.sampled_from(["row", "column"]), st.floats(0.1, 2))
@settings(max_examples=30, deadline=None)
def test_bands_part_the_table(setting, kind, gap):
    scene = setting.scene()
    parts = arrangement.partition(scene, np.ones(scene.n, bool), kind, gap)
    assert (np.sum(parts, axis=0) == 1).all()
    axis = 0 if kind == "row" else 1
    for one, following in itertools.pairwise(parts):
        assert scene.xy[one, axis].min() > scene.xy[following, axis].max()


@given(settings_of_blocks(), st.none() | st.integers(1, 8), st.booleans())
@settings(max_examples=40, deadline=None)
def test_a_plural_means_all_that_match_or_so_many(setting, number, universal):
    scene = setting.scene()
    weights = np.array([1.0 if item.color == "red" else 0.0 for item in scene.layout.things])
    found = arrangement.collected(scene, weights, number, universal)
    if not weights.any():
        assert not found
    elif number is None or number == weights.sum():
        assert (found[0].mask == (weights > 0)).all()
    assert all(0 <= candidate.looks <= 1 for candidate in found)
