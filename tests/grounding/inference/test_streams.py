"""Alternatives come in the order of their probability, all of them, and no sooner than they are asked for."""

import itertools
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.inference.streams import Stream, expand, ranked_sets

logs = st.lists(st.floats(-20, 0), max_size=5).map(lambda values: sorted(values, reverse=True))


@given(st.lists(st.floats(-30, 30), max_size=7), st.floats(-5, 0))
def test_all_assignments_in_order(log_odds, rest):
    found = list(ranked_sets(log_odds, rest))
    expected = []
    for truth in itertools.product((False, True), repeat=len(log_odds)):
        chosen = frozenset(i for i, true in enumerate(truth) if true)
        log = -sum(math.log1p(math.exp(-x if true else x)) for x, true in zip(log_odds, truth, strict=True))
        expected.append((log + rest, chosen))
    assert len({chosen for _, chosen in found}) == len(found) == len(expected)
    assert [log for log, _ in found] == pytest.approx(sorted((log for log, _ in expected), reverse=True), abs=1e-9)
    of = {chosen: log for log, chosen in expected}
    assert all(log == pytest.approx(of[chosen], abs=1e-9) for log, chosen in found)


@given(logs, st.lists(logs, min_size=5, max_size=5))
def test_continuations_in_order(base, after):
    found = list(
        expand(((log, i) for i, log in enumerate(base)), lambda i: ((x, (i, j)) for j, x in enumerate(after[i])))
    )
    expected = sorted((log + x for i, log in enumerate(base) for x in after[i]), reverse=True)
    assert [log for log, _ in found] == pytest.approx(expected)
    assert len({value for _, value in found}) == len(expected)


def test_what_cannot_win_is_not_looked_at():
    opened = []

    def follow(value):
        opened.append(value)
        return [(-1.0, value)]

    assert next(expand([(0.0, "a"), (-0.5, "b"), (-1.5, "c")], follow)) == (-1.0, "a")
    assert opened == ["a", "b"]


def test_a_stream_is_made_once_and_read_often():
    made = []

    def source():
        for i in range(3):
            made.append(i)
            yield -float(i), i

    stream = Stream(source())
    assert next(iter(stream)) == (0.0, 0)
    assert made == [0]
    assert list(stream) == list(stream) == [(0.0, 0), (-1.0, 1), (-2.0, 2)]
    assert made == [0, 1, 2]
