"""Training: the gradient is the value's, merging rows changes nothing, and the same rows give the same weights."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import optimize

from grounding.factors import TrainingSet, train
from grounding.factors.training import Objective

names = st.integers(0, 5)
candidates = st.lists(st.tuples(st.lists(names.map("r{}".format), max_size=3), st.booleans()), min_size=1, max_size=5)
phrases = st.lists(
    st.tuples(st.lists(names.map("f{}".format), min_size=1, max_size=3, unique=True), candidates),
    min_size=1,
    max_size=5,
)


def training_set(content):
    data = TrainingSet()
    for facts, rows in content:
        data.add(facts, rows)
    return data


def plain_value(data, content, weights, penalty):
    """The objective as the formula has it, row by row and without merging."""
    value = 0.5 * penalty * float((weights**2).sum())
    for facts, rows in content:
        for roles, label in rows:
            score = sum(weights[data.facts[f], data.roles[r]] for f in facts for r in set(roles))
            value += np.logaddexp(0.0, -score if label else score)
    return value


@given(phrases, st.floats(0, 3), st.integers(0, 99))
def test_merged_rows_weigh_as_much_as_single_ones(content, penalty, seed):
    data = training_set(content)
    weights = np.random.default_rng(seed).normal(size=(len(data.facts), len(data.roles)))
    value, _ = Objective(data, penalty)(weights.ravel())
    assert value == pytest.approx(plain_value(data, content, weights, penalty))


@given(phrases, st.floats(0, 3), st.integers(0, 99))
def test_the_gradient_is_that_of_the_value(content, penalty, seed):
    data = training_set(content)
    if not data.roles:
        return
    objective = Objective(data, penalty)
    flat = np.random.default_rng(seed).normal(size=len(data.facts) * len(data.roles))
    _, gradient = objective(flat)
    numeric = optimize.approx_fprime(flat, lambda x: objective(x)[0], 1e-6)
    np.testing.assert_allclose(gradient, numeric, atol=1e-4 * (1 + np.abs(gradient).max()))


def test_adding_a_phrase_twice_counts_it_twice():
    content = [(["f1", "f2"], [(["r1"], True), (["r2"], False), (["r2", "r2"], False)])]
    once, twice = training_set(content), training_set(content * 2)
    assert {row: 2 * count for row, count in once.rows.items()} == twice.rows
    assert len(once.rows) == 2  # equal rows are merged; a role counts once


def separable(count=40):
    rng = np.random.default_rng(0)
    content = []
    for _ in range(count):
        fact = f"f{rng.integers(2)}"
        roles = [f"r{i}" for i in range(3)]
        content.append(([fact], [([role], role == ("r0" if fact == "f0" else "r1")) for role in roles]))
    return content


def test_what_can_be_told_apart_is_learned():
    factor = train(training_set(separable()), penalty=0.1)
    for fact, right in (("f0", "r0"), ("f1", "r1")):
        odds = factor.role_weights([fact])
        assert odds[right] > 0 > max(value for role, value in odds.items() if role != right)


def test_the_same_rows_give_the_same_weights():
    first, second = (train(training_set(separable()), penalty=0.3) for _ in range(2))
    assert (first.facts, first.roles) == (second.facts, second.roles)
    assert np.array_equal(first.weights, second.weights)


def test_a_stronger_penalty_gives_smaller_weights():
    sizes = [np.abs(train(training_set(separable()), penalty).weights).sum() for penalty in (0.01, 0.1, 1.0, 10.0)]
    assert sizes == sorted(sizes, reverse=True)


def test_every_step_is_told():
    steps = []
    train(training_set(separable()), on_step=lambda: steps.append(1))
    assert steps


def test_nothing_to_learn_from():
    factor = train(TrainingSet())
    assert factor.weights.size == 0
    assert factor.feature_count == 0
    assert factor.role_weights(["f0"]) == {}


def test_phrases_without_candidates_leave_no_trace():
    data = training_set([(["f1"], [])])
    assert not data.rows
    assert not data.contexts


@given(phrases, st.integers(1, 5), st.floats(0, 3), st.integers(0, 99))
def test_counted_rows_weigh_as_much_as_that_many_single_ones(content, times, penalty, seed):
    counted, single = TrainingSet(), training_set(content * times)
    for facts, rows in content:
        counted.add_counted(facts, [(roles, label, times) for roles, label in rows])
    if not single.roles:
        return
    flat = np.random.default_rng(seed).normal(size=len(single.facts) * len(single.roles))
    value, gradient = Objective(counted, penalty)(flat)
    expected, slope = Objective(single, penalty)(flat)
    assert value == pytest.approx(expected)
    np.testing.assert_allclose(gradient, slope, atol=1e-9 * (1 + np.abs(slope).max()))


@given(phrases, st.floats(0.5, 1e4), st.integers(0, 99))
def test_the_gradient_of_counted_rows_is_that_of_their_value(content, count, seed):
    data = TrainingSet()
    for facts, rows in content:
        data.add_counted(facts, [(roles, label, count) for roles, label in rows])
    if not data.roles:
        return
    objective = Objective(data, 0.3)
    flat = np.random.default_rng(seed).normal(size=len(data.facts) * len(data.roles))
    _, gradient = objective(flat)
    numeric = optimize.approx_fprime(flat, lambda x: objective(x)[0], 1e-6)
    np.testing.assert_allclose(gradient, numeric, atol=1e-4 * (1 + np.abs(gradient).max()))


def strict(role):
    return 10.0 if role == "r0" else 0.1 if role == "r1" else 1.0


@given(phrases, st.floats(0.1, 3), st.integers(0, 99))
def test_the_gradient_is_the_value_s_where_some_roles_are_held_nearer_to_zero(content, penalty, seed):
    objective = Objective(training_set(content), penalty, strict)
    weights = np.random.default_rng(seed).normal(size=int(np.prod(objective.shape)))
    value, gradient = objective(weights)
    numeric = optimize.approx_fprime(weights, lambda flat: objective(flat)[0], 1e-6)
    assert np.allclose(gradient, numeric, atol=1e-3 * max(1.0, abs(value)))


def test_strict_roles_get_smaller_weights():
    free, held = (train(training_set(separable()), 0.3, strictness=of) for of in (lambda _: 1.0, strict))
    column = free.roles.index("r0")
    assert np.abs(held.weights[:, column]).sum() < np.abs(free.weights[:, column]).sum()
