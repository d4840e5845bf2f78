import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding import make_object
from grounding.pictures.outlines import convex_hull, corners_of, outline_of, rounded_hull

points = st.lists(st.tuples(st.floats(-1, 1), st.floats(-1, 1)), min_size=3, max_size=12)


@given(points)
def test_a_rounded_hull_keeps_its_distance(cloud):
    outline = rounded_hull(np.array(cloud), 0.1)
    for point in cloud:
        assert np.linalg.norm(outline - point, axis=1).min() >= 0.1 - 1e-9


def test_the_hull_of_a_square_with_points_inside():
    assert len(convex_hull([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5], [0.5, 0]])) == 4


def test_corners_of_a_turned_block():
    half = np.pi / 8
    block = make_object("a", position=(1, 2, 3), orientation=(np.cos(half), 0, 0, np.sin(half)), size=(0.2, 0.2, 0.4))
    corners = corners_of(block)
    assert corners.mean(axis=0) == pytest.approx([1, 2, 3])
    assert corners[:4, 2] == pytest.approx(2.8)
    assert np.ptp(outline_of(block), axis=0) == pytest.approx([0.2 * np.sqrt(2)] * 2)
