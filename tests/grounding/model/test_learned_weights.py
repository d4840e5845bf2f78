"""Learning the weights: gradients are those of the likelihood, odd texts bend little, probabilities stay ones."""

import numpy as np
import pytest
from believing import TABLE, block, grounder
from hypothesis import given
from hypothesis import strategies as st
from scipy import sparse

from grounding import World
from grounding.model.belief import believe
from grounding.model.cases import LONG, MISHEARD, UNKNOWN, Weights, doubts_of
from grounding.model.training import Problem, _likelihood, train


def problem_of(rows, text, gold, groups, shares, weights):
    """Candidates of texts; each text has as many options as rows."""
    options = np.bincount(text).astype(float)
    names = tuple(f"f{i}" for i in range(rows.shape[1]))
    doubts = np.column_stack([np.ones(len(options)), np.arange(len(options)) % 3, np.arange(len(options)) % 2])
    matrix = sparse.csr_matrix(rows)
    return Problem(names, matrix, text, gold, shares, groups, len(options), weights, options, doubts, 0)


@given(st.integers(0, 200))
def test_the_gradient_is_that_of_the_likelihood(seed):
    rng = np.random.default_rng(seed)
    problem = problem_of(
        rng.normal(size=(12, 4)), np.repeat([0, 1, 2], 4), np.array([(0, 0), (1, 0), (5, 1), (6, 2), (9, 3)]),
        np.array([0, 1, 1, 2]), np.array([1, 0.5, 0.5, 1]), np.array([1.0, 2.0, 3.0]),
    )  # fmt: skip
    at = rng.normal(size=7)
    step = 1e-6 * np.eye(7)
    numeric = [(_likelihood(problem, at + d)[0] - _likelihood(problem, at - d)[0]) / 2e-6 for d in step]
    np.testing.assert_allclose(_likelihood(problem, at)[1], numeric, rtol=1e-4, atol=1e-5)


def learned(odd):
    """Weights of texts with two options, of which all but so many mean the one that the only feature speaks for."""
    count = 100
    rows = np.tile([[1.0], [0.0]], (count, 1))
    text = np.repeat(np.arange(count), 2)
    gold = np.array([(2 * i + (i < odd), i) for i in range(count)])
    problem = problem_of(rows, text, gold, np.arange(count), np.ones(count), np.ones(count))
    return train(problem, Weights(f0=0.0), penalty=0.01)


def test_texts_that_mean_something_else_are_counted_as_misheard():
    few, many = learned(4), learned(30)
    assert few.misheard < many.misheard
    assert 0.01 < few.misheard < 0.5
    assert few["f0"] > 1.5


def test_weights_that_know_nothing_of_it_mishear_nothing():
    assert Weights().misheard == 0.0
    assert Weights({MISHEARD: 0.0}).misheard == pytest.approx(0.5)


WORLD = World((TABLE, block("a", "red", 0.5, 0.3), block("b", "blue", 0.6, 0.0), block("c", "green", 0.5, -0.3)))


@pytest.mark.parametrize("odds", [-9.0, -3.0, 0.0])
def test_what_is_misheard_is_shared_among_all_options(odds):
    parses = grounder().parser.parse("take the red block")
    meanings = grounder().hear(parses, grounder().scene(WORLD)).meanings
    sure = believe(meanings, Weights({**grounder().weights, MISHEARD: -99.0}))
    belief = believe(meanings, Weights({**grounder().weights, MISHEARD: odds}))
    misheard = 1 / (1 + np.exp(-odds))
    assert sum(share for _, share in belief.options) == pytest.approx(1.0)
    assert min(share for _, share in belief.options) >= misheard / len(belief.options) - 1e-12
    best = dict(sure.options)[("a",)]
    assert belief.probability(("a",)) == pytest.approx((1 - misheard) * best + misheard / len(belief.options))


def test_long_texts_and_unknown_words_make_mishearing_likelier():
    weights = Weights({MISHEARD: -2.0, LONG: 0.5, UNKNOWN: 0.3})
    chances = [weights.mishearing(doubts_of(words, 0)) for words in (1, 10, 20, 40)]
    assert chances[0] == chances[1] == weights.misheard
    assert chances[1] < chances[2] < chances[3] < 1
    assert weights.mishearing(doubts_of(5, 2)) > weights.misheard
    assert Weights().mishearing(doubts_of(40, 3)) == 0.0
