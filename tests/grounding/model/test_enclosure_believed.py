"""Between and amid: chances of counts, turned and mirrored scenes, and phrases whose parts are counted."""

import itertools

import numpy as np
import pytest
from believing import believed, block
from hypothesis import given
from hypothesis import strategies as st

from grounding import World, make_object
from grounding.geometry.layout import Layout
from grounding.lexicon.between import Part, amid, between_two
from grounding.lexicon.degrees import at_least
from grounding.lexicon.where import Where
from grounding.world.scene import Scene

points = st.lists(st.tuples(st.integers(0, 6), st.integers(-6, 6)), min_size=3, max_size=7, unique=True)


def scene_of(places, turn=((1, 0), (0, 1))):
    xy = np.array(places, dtype=float) * 0.07 @ np.array(turn).T
    return Scene(Layout(World(tuple(
        make_object(f"b{i}", "block", "red", (0.8 + x, y, 0.736)) for i, (x, y) in enumerate(xy)
    ))))  # fmt: skip


@given(st.lists(st.floats(0, 1), min_size=1, max_size=6), st.integers(0, 7))
def test_chances_of_counts_are_those_of_brute_force(chances, count):
    wanted = sum(
        np.prod([p if bit else 1 - p for p, bit in zip(chances, bits, strict=True)])
        for bits in itertools.product((0, 1), repeat=len(chances))
        if sum(bits) >= count
    )
    assert at_least(np.array([chances]), count)[0] == pytest.approx(wanted, abs=1e-9)


@given(points, st.booleans(), st.integers(0, 3))
def test_a_turned_or_mirrored_scene_encloses_the_same(places, mirrored, quarters):
    turn = np.linalg.matrix_power(np.array([[0, -1], [1, 0]]), quarters) @ np.diag([1, -1 if mirrored else 1])
    n = len(places)
    parts = [Part(np.arange(n) % 2 * 1.0, 2), Part((np.arange(n) + 1) % 2 * 1.0, 1)]
    one, other = scene_of(places), scene_of(places, turn)
    for surrounding in (True, False):
        found = amid(Where.objects(one), one, parts, surrounding=surrounding)
        assert ((found >= -1e-9) & (found <= 1 + 1e-9)).all()
        np.testing.assert_allclose(found, amid(Where.objects(other), other, parts, surrounding=surrounding), atol=1e-6)


@given(points)
def test_between_two_does_not_depend_on_who_is_named_first(places):
    scene = scene_of(places)
    first = np.linspace(1.0, 0.5, scene.n)
    where = Where.objects(scene)
    there, back = between_two(where, scene, first, first[::-1]), between_two(where, scene, first[::-1], first)
    np.testing.assert_allclose(there, back)


def test_nothing_lies_between_where_there_is_one():
    scene = scene_of([(0, 0)])
    assert amid(Where.objects(scene), scene, [Part(np.ones(1), 2)], surrounding=False).tolist() == [0.0]


# Phrases: a yellow block with two reds and a blue around it, one with a red on one side, one amid four greens.

WORLD = World(tuple(
    block(name, color, 0.6 + 0.07 * x, 0.07 * y)
    for name, color, x, y in (
        ("y1", "yellow", 0, 0), ("r1", "red", 0, 1), ("r2", "red", 0, -1), ("u1", "blue", 1, 0),
        ("y2", "yellow", 0, 6), ("r3", "red", 0, 7),
        ("y3", "yellow", 0, -6), ("g1", "green", 1, -6), ("g2", "green", -1, -6), ("g3", "green", 0, -5),
        ("g4", "green", 0, -7),
    )
))  # fmt: skip


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("the yellow block between two red blocks and a blue block", "y1"),
        ("the yellow block surrounded by two red blocks and one blue block", "y1"),
        ("the yellow block in the middle of two red and one blue block", "y1"),
        ("the yellow block surrounded by four green blocks", "y3"),
        ("the yellow block surrounded by green blocks", "y3"),
        ("the yellow block between two red blocks", "y1"),
    ],
)
def test_counted_parts_tell_what_is_enclosed(text, name):
    best, second, *_ = believed(text, WORLD).listed()
    assert best.objects == (name,)
    assert best.probability > 2 * second.probability
