import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motion.errors import LimitViolation
from motion.path.trajectory import KNOT_SPACINGS, Trajectory, check_limits, rest, timed
from motion.robot.recipe import recipe

LIMITS = recipe().limits
NAMES = [f"j{i}" for i in range(7)]
WIDE = np.full(7, 10.0)


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10_000), st.integers(2, 6), st.sampled_from(KNOT_SPACINGS))
def test_any_path_keeps_all_limits_and_goes_from_rest_to_rest(seed, count, spacing):
    rng = np.random.default_rng(seed)
    path = list(np.cumsum(rng.uniform(-0.7, 0.7, (count, 7)), axis=0))
    trajectory = timed(path, LIMITS, spacing=spacing)
    check_limits(trajectory, NAMES, -WIDE, WIDE, LIMITS)
    assert np.allclose(trajectory.positions[[0, -1]], [path[0], path[-1]])
    assert np.allclose(trajectory.velocities[[0, -1]], 0, atol=1e-9)
    numeric = np.gradient(trajectory.positions, trajectory.period, axis=0)
    assert np.abs(numeric - trajectory.velocities)[2:-2].max() < 1e-3


def test_straight_moves_are_straight_and_use_a_limit_fully():
    first, last = np.zeros(7), np.array([1.0, -0.5, 0.2, 0.8, -2.0, 0.1, 0.0])
    trajectory = timed([first, last], LIMITS)
    share = trajectory.positions @ last / (last @ last)
    assert np.allclose(trajectory.positions, share[:, None] * last, atol=1e-9)
    use = np.abs(trajectory.accelerations).max(axis=0) / LIMITS.acceleration
    assert use.max() == pytest.approx(1.0, abs=0.01)


def test_waypoints_on_a_line_cost_nothing():
    last = np.array([1.0, -0.5, 0.2, 0.8, -2.0, 0.1, 0.3])
    direct = timed([np.zeros(7), last], LIMITS)
    stepped = timed([last * k / 20 for k in range(21)], LIMITS)
    assert stepped.duration == pytest.approx(direct.duration, rel=0.01)


def test_half_the_speed_takes_twice_as_long():
    path = [np.zeros(7), np.full(7, 0.6)]
    assert timed(path, LIMITS, 0.5).duration == pytest.approx(2 * timed(path, LIMITS).duration, rel=0.01)


def test_standing_still():
    trajectory = rest(np.ones(7), 0.5)
    assert trajectory.duration == pytest.approx(0.5)
    assert timed([np.ones(7), np.ones(7)], LIMITS).duration == 0


@pytest.mark.parametrize("quantity", ["position", "velocity", "acceleration", "jerk"])
def test_every_limit_is_noticed_and_named(quantity):
    good = timed([np.zeros(7), np.full(7, 0.5)], LIMITS)
    upper = WIDE.copy()
    rows = {name: getattr(good, name).copy() for name in ("positions", "velocities", "accelerations")}
    if quantity == "position":
        upper[3] = 0.4
    elif quantity == "jerk":
        rows["accelerations"][100, 3] *= 0.9
    else:
        rows["velocities" if quantity == "velocity" else "accelerations"][:, 3] *= 20
    if quantity == "acceleration":
        rows["accelerations"][:, 3] = 5
    with pytest.raises(LimitViolation, match=f"{quantity} of j3") as caught:
        check_limits(Trajectory(good.period, **rows), NAMES, -WIDE, upper, LIMITS)
    assert caught.value.joint == "j3"
