"""Degrees: ranks are Poisson-binomial, everything lies in [0, 1], nothing depends on the order of objects."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.lexicon import between, degrees

NOISE = 0.3
members = st.integers(1, 6).flatmap(
    lambda n: st.tuples(
        st.lists(st.floats(0, 1), min_size=n, max_size=n), st.lists(st.floats(-3, 3), min_size=n, max_size=n)
    )
)


def enumerated(weights, key, index):
    """P(i is a member and index - 1 other members lie beyond it), summed over who is a member and who lies beyond."""
    n = len(weights)
    found = np.zeros(n)
    for i in range(n):
        others = [j for j in range(n) if j != i]
        beyond = {j: weights[j] / (1 + np.exp(-(key[j] - key[i]) / NOISE)) for j in others}
        for chosen in itertools.combinations(others, index - 1):
            chance = weights[i]
            for j in others:
                chance *= beyond[j] if j in chosen else 1 - beyond[j]
            found[i] += chance
    return found


@given(members, st.integers(1, 6))
def test_ranks_are_those_of_brute_force(drawn, index):
    weights, key = map(np.array, drawn)
    np.testing.assert_allclose(degrees.ranked(weights, key, index, NOISE), enumerated(weights, key, index), atol=1e-9)


@given(members, st.integers(1, 6))
def test_the_last_is_the_first_the_other_way_round(drawn, index):
    weights, key = map(np.array, drawn)
    np.testing.assert_array_equal(
        degrees.ranked(weights, key, -index, NOISE), degrees.ranked(weights, -key, index, NOISE)
    )


@given(members)
def test_somebody_is_of_a_rank_at_most_once(drawn):
    weights, key = map(np.array, drawn)
    ranks = np.array([degrees.ranked(weights, key, index, NOISE) for index in range(1, len(weights) + 1)])
    assert (ranks >= -1e-12).all()
    np.testing.assert_allclose(ranks.sum(axis=0), weights, atol=1e-9)  # every member is of exactly one rank


@given(st.lists(st.integers(-40, 40), min_size=2, max_size=7, unique=True), st.integers(1, 7))
def test_ranks_of_what_lies_far_apart_are_certain(places, index):
    key = np.array(places, dtype=float)
    found = degrees.ranked(np.ones(len(key)), key, index, 0.02)
    assert found.sum() <= 1 + 1e-9
    if index <= len(key):
        assert np.argmax(found) == np.argsort(-key)[index - 1]
        assert found.max() == pytest.approx(1.0)


@given(members, st.integers(-3, 3).filter(bool), st.randoms(use_true_random=False))
def test_order_says_nothing(drawn, index, random):
    weights, key = map(np.array, drawn)
    order = list(range(len(weights)))
    random.shuffle(order)
    np.testing.assert_allclose(
        degrees.ranked(weights[order], key[order], index, NOISE), degrees.ranked(weights, key, index, NOISE)[order],
        atol=1e-12,
    )  # fmt: skip


@given(members)
def test_who_is_no_member_has_no_rank_and_bars_nobody(drawn):
    weights, key = map(np.array, drawn)
    more = degrees.ranked(np.append(weights, 0.0), np.append(key, 9.0), 1, NOISE)
    assert more[-1] == 0
    np.testing.assert_allclose(more[:-1], degrees.ranked(weights, key, 1, NOISE), atol=1e-12)


def test_of_nobody_there_is_no_rank():
    assert degrees.ranked(np.zeros(0), np.zeros(0), 1, NOISE).shape == (0,)


@given(st.floats(-1e6, 1e6))
def test_the_logistic_does_not_overflow(x):
    value = float(degrees.logistic(np.array([x]))[0])
    assert 0 <= value <= 1
    assert value == pytest.approx(1 - float(degrees.logistic(np.array([-x]))[0]), abs=1e-12)


@given(st.floats(0.1, 0.9), st.floats(-0.3, 0.3))
def test_between_does_not_know_which_is_the_first(along, across):
    one, other = np.array([0.3, 0.2]), np.array([0.8, -0.1])
    span = other - one
    point = (one + along * span + across * np.array([-span[1], span[0]]))[None]
    there, back = between.truth(point, one, other, 0.05)[0], between.truth(point, other, one, 0.05)[0]
    assert there == pytest.approx(back, rel=1e-9)
    assert 0 <= there <= 1
    middle = between.truth(((one + other) / 2)[None], one, other, 0.05)[0]
    assert there <= middle + 1e-12


def test_between_a_place_and_itself_is_nothing():
    assert between.truth(np.zeros((2, 2)), np.ones(2), np.ones(2), 0.05).tolist() == [0, 0]
