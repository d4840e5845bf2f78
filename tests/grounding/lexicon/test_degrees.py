"""Degrees: ranks of uncertain sets are probabilities, counts are those of independent coins."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.lexicon.degrees import at_least, counting, gaussian, logistic, peak, ranked, softened

chances = st.lists(st.floats(0, 1), min_size=1, max_size=5)


@given(chances)
def test_counts_are_those_of_independent_coins(ps):
    expected = np.zeros(len(ps) + 1)
    for coins in itertools.product((0, 1), repeat=len(ps)):
        expected[sum(coins)] += np.prod([p if coin else 1 - p for p, coin in zip(ps, coins, strict=True)])
    np.testing.assert_allclose(counting(np.array([ps]), len(ps) + 1)[0], expected, atol=1e-9)
    for count in range(len(ps) + 1):
        assert at_least(np.array([ps]), count)[0] == pytest.approx(expected[count:].sum(), abs=1e-9)


@given(st.permutations(range(5)), st.integers(1, 5))
def test_of_a_certain_set_one_has_each_rank(order, index):
    key = np.array(order, dtype=float)
    held = ranked(np.ones(5), key, index, 1e-3)
    assert held[order.index(5 - index)] == pytest.approx(1)
    assert held.sum() == pytest.approx(1)


@given(st.lists(st.floats(0, 1), min_size=1, max_size=6), st.data())
def test_the_last_is_the_first_from_behind(weights, data):
    key = np.array(data.draw(st.lists(st.floats(-1, 1), min_size=len(weights), max_size=len(weights))))
    held = ranked(np.array(weights), key, -1, 0.1)
    np.testing.assert_allclose(held, ranked(np.array(weights), -key, 1, 0.1))
    assert (held <= np.array(weights) + 1e-12).all()


def test_nothing_has_no_rank():
    assert ranked(np.zeros(0), np.zeros(0), 1, 0.1).shape == (0,)
    assert peak(np.zeros(0)) > 0


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6))
def test_degrees_rise_and_fade_without_overflow(one, other):
    low, high = sorted((one, other))
    rising = logistic(np.array([low, high]))
    assert 0 <= rising[0] <= rising[1] <= 1
    assert logistic(np.array(0.0)) == pytest.approx(0.5)
    assert gaussian(np.array(abs(low)), 1.0) == gaussian(np.array(-abs(low)), 1.0)
    assert 0 < softened(np.array(0.0)) < softened(np.array(1.0)) == 1
