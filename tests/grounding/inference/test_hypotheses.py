"""The k best sets and combinations are those of trying everything."""

import itertools
import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from grounding.inference.hypotheses import Hypothesis, best_combinations, best_sets

odds = st.lists(st.floats(-30, 30), max_size=8)


def everything(log_odds):
    """All truth assignments with their log probability, the likeliest first."""
    found = []
    for truth in itertools.product((False, True), repeat=len(log_odds)):
        log = -sum(math.log1p(math.exp(-x if true else x)) for x, true in zip(log_odds, truth, strict=True))
        found.append((frozenset(i for i, true in enumerate(truth) if true), log))
    return sorted(found, key=lambda item: -item[1])


@given(odds, st.integers(1, 12))
def test_the_best_sets_are_those_of_trying_all(log_odds, count):
    found = best_sets(log_odds, count, least=-math.inf)
    expected = everything(log_odds)
    assert len(found) == min(count, len(expected))
    assert [log for _, log in found] == pytest.approx([log for _, log in expected[:count]], abs=1e-9)
    assert len({chosen for chosen, _ in found}) == len(found)
    of = dict(expected)
    assert all(log == pytest.approx(of[chosen], abs=1e-9) for chosen, log in found)


@given(odds, st.integers(1, 300), st.floats(-20, -0.1))
def test_only_what_is_likely_enough_is_kept(log_odds, count, least):
    found = best_sets(log_odds, count, least)
    best = found[0][1]
    assert all(log >= best + least - 1e-9 for _, log in found)
    clear = [chosen for chosen, log in everything(log_odds)[:count] if log > best + least + 1e-6]
    assert {chosen for chosen, _ in found} >= set(clear) or len(found) == count


@given(odds)
def test_one_set_is_the_first_of_many(log_odds):
    assert best_sets(log_odds, 1) == best_sets(log_odds, 20)[:1]


@pytest.mark.parametrize("huge", [1e3, 1e6])
def test_certainty_does_not_overflow(huge):
    assert best_sets([huge, -huge], 4) == [(frozenset({0}), pytest.approx(0.0))]


lists = st.lists(
    st.lists(st.floats(-50, 0), min_size=1, max_size=4).map(lambda logs: sorted(logs, reverse=True)), max_size=4
)


@given(lists, st.integers(1, 20))
def test_the_best_combinations_are_those_of_trying_all(logs, count):
    choices = [[Hypothesis(frozenset(), log) for log in row] for row in logs]
    every = sorted((sum(h.log_probability for h in taken) for taken in itertools.product(*choices)), reverse=True)
    found = best_combinations(choices, count)
    assert [sum(h.log_probability for h in taken) for taken in found] == pytest.approx(every[:count])
    assert len({tuple(map(id, taken)) for taken in found}) == len(found)
    for taken in found:
        assert all(h in row for h, row in zip(taken, choices, strict=True))


@given(lists, st.integers(1, 20))
def test_nothing_to_take_from_gives_no_combination(logs, count):
    assume(logs)
    assert best_combinations([*([Hypothesis(frozenset(), log) for log in row] for row in logs), []], count) == []
