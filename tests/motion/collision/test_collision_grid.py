import itertools

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from motion.collision.grid import bisected, dense, resampled

PATHS = st.lists(st.lists(st.floats(-3, 3), min_size=7, max_size=7).map(np.array), min_size=2, max_size=4)
GRIDS = st.floats(0.05, 0.5)


@given(PATHS, GRIDS)
def test_no_joint_moves_by_more_than_the_grid(path, grid):
    points = list(dense(path, grid))
    assert all(np.max(np.abs(second - first)) <= grid + 1e-9 for first, second in itertools.pairwise(points))
    assert all(any(np.allclose(point, waypoint) for point in points) for waypoint in path)


@given(PATHS, GRIDS)
def test_samples_of_a_trajectory_are_thinned_to_the_grid(path, grid):
    points = resampled(np.array(path), grid)
    assert np.allclose(points[0], path[0])
    assert np.allclose(points[-1], path[-1])
    assert np.max(np.abs(np.diff(points, axis=0)), initial=0.0) <= grid + 1e-9


@given(st.integers(1, 300))
def test_halves_come_first_and_nothing_is_left_out(steps):
    order = bisected(steps)
    assert order[:2] == [0, steps]
    assert sorted(order) == list(range(steps + 1))
    if steps % 2 == 0 and steps & (steps - 1) == 0:
        assert order[2] == steps // 2


def test_a_path_without_waypoints_has_no_configurations():
    assert list(dense([])) == []
