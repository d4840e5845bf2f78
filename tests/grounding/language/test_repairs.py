import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.language.repairs import without_slips
from grounding.language.tokens import tokenize

SLIPS = [
    ("take the red, sorry, no, the blue one", "take the blue one"),
    ("the green, sorry, I mean the blue one", "the blue one"),
    ("please take the left, no wait, the right one of those two", "please take the right one of those two"),
    ("I'd say the left... sorry, the right one", "i 'd say the right one"),
    ("take the red block - oops - the red cube", "take the red cube"),
    ("lift the front one, no, the back one, no, the middle one", "lift the middle one"),
    ("put it on the red one, sorry, on the blue one", "put it on the blue one"),
]
PLAIN = [
    "take the green, i mean the leftmost green",
    "no, not that one. take the red one",
    "take the block with no neighbours",
    "sorry, take the red one",
    "take the red one, no blue one is near it",
    "take the block that has no block on it, the one at the back",
]


@pytest.mark.parametrize(("said", "meant"), SLIPS)
def test_a_slip_is_replaced_by_its_repair(said, meant):
    assert " ".join(token.text for token in without_slips(tokenize(said))) == meant


@pytest.mark.parametrize("text", PLAIN)
def test_what_is_no_slip_stays(text):
    assert without_slips(tokenize(text)) == tokenize(text)


SAID = ["the", "red", "one", ",", "...", ".", "sorry", "no", "i", "mean", "wait"]


@given(st.lists(st.sampled_from(SAID), min_size=1))
def test_what_is_left_is_a_part_of_what_was_said(words):
    tokens = tokenize(" ".join(words))
    left = without_slips(tokens)
    rest = iter(tokens)
    assert all(token in rest for token in left)
    assert left
