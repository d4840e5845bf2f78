import numpy as np
import pytest

from integration.execute.distances import distances_outside

SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


def test_inside_is_negative_and_outside_positive():
    found = distances_outside(SQUARE, [[0.5, 0.5], [0.5, 0.9], [2.0, 0.5], [2.0, 2.0]])
    assert found == pytest.approx([-0.5, -0.1, 1.0, np.sqrt(2)])


def test_distances_do_not_depend_on_where_the_outline_begins():
    points = np.random.default_rng(0).uniform(-1, 2, (50, 2))
    assert distances_outside(np.roll(SQUARE, 2, axis=0), points) == pytest.approx(distances_outside(SQUARE, points))
