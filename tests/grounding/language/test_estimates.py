import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.language.estimates import BackOff

OUTCOMES = "abcd"
events = st.lists(st.tuples(st.sampled_from("xy"), st.sampled_from("uv"), st.sampled_from(OUTCOMES)), min_size=1)


def table(seen: list[tuple[str, str, str]], novelty: float = 1.0) -> BackOff:
    return BackOff.count((((first, first + second), outcome, 1.0) for first, second, outcome in seen), novelty)


@given(events, st.sampled_from("xy"), st.sampled_from("uvw"), st.floats(0.1, 10.0))
def test_probabilities_sum_to_one(seen: list[tuple[str, str, str]], first: str, second: str, novelty: float) -> None:
    model = table(seen, novelty)
    chances = [model.probability((first, first + second), outcome, 1 / len(OUTCOMES)) for outcome in OUTCOMES]
    assert sum(chances) == pytest.approx(1.0)
    assert min(chances) > 0.0


@given(events)
def test_an_unseen_specific_context_is_as_the_general_one(seen: list[tuple[str, str, str]]) -> None:
    model = table(seen)
    for outcome in OUTCOMES:
        general = model.probability(("x",), outcome, 0.25)
        assert model.probability(("x", "xw"), outcome, 0.25) == general
