"""Numbers and ranks in one word."""

import pytest

from grounding.language.lexicon import meanings
from grounding.language.number_words import number_of
from grounding.symbols import Cardinal, Ordinal


@pytest.mark.parametrize(
    ("word", "symbol"),
    [
        ("thirty", Cardinal(30)), ("thirtieth", Ordinal(30)), ("twenty-first", Ordinal(21)),
        ("hundredth", Ordinal(100)), ("ninety-nine", Cardinal(99)), ("hundred", Cardinal(100)),
        ("twelfth", Ordinal(12)), ("forty-second", Ordinal(42)),
    ],
)  # fmt: skip
def test_large_numbers_and_ranks_are_known(word, symbol):
    assert meanings(word) == {symbol}


@pytest.mark.parametrize("word", ["left-hand", "twenty-blue", "ieth", "y", "one-two", "tooth", "", "-", "-one"])
def test_other_words_are_no_numbers(word):
    assert number_of(word) is None
