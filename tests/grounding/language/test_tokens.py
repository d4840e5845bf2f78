import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.errors import LanguageError
from grounding.language.tokens import tokenize


def words(text: str) -> list[str]:
    return [token.text for token in tokenize(text)]


@given(st.text())
def test_any_text_gives_tokens_in_order_or_a_language_error(text: str) -> None:
    try:
        tokens = tokenize(text)
    except LanguageError:
        return
    position = 0
    for token in tokens:
        assert position <= token.start < token.end
        assert token.original == text[token.start : token.end]
        assert token.text
        assert not any(character.isspace() for character in token.text)
        position = token.end


@given(st.lists(st.from_regex(r"[a-z]{1,8}(-[a-z]{1,5})?", fullmatch=True), min_size=1))
def test_plain_words_come_back(plain: list[str]) -> None:
    assert words(" ".join(plain)) == plain


@given(st.from_regex(r"[A-Za-z0-9 ,.'-]{1,40}", fullmatch=True))
def test_case_makes_no_difference(text: str) -> None:
    try:
        lower = words(text.lower())
    except LanguageError:
        return
    assert words(text.upper()) == lower


def test_nothing_but_visible_characters_is_lost() -> None:
    text = "Robot, pick up “the red one” (left-hand side): it's 2.5 cm away!"
    kept = "".join(token.original for token in tokenize(text))
    assert kept == text.replace(" ", "")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Pick up the block.", ["pick", "up", "the", "block", "."]),
        ("the right-hand side", ["the", "right-hand", "side"]),
        ("it’s", ["it", "'s"]),
        ("the robot's left", ["the", "robot", "'s", "left"]),
        ("don't", ["do", "n't"]),
        ("I'd like 5 blocks, not 2.5", ["i", "'d", "like", "5", "blocks", ",", "not", "2.5"]),
        ("the 3rd one", ["the", "3rd", "one"]),
        ("ﬁrst", ["first"]),
    ],
)
def test_conventions(text: str, expected: list[str]) -> None:
    assert words(text) == expected


@pytest.mark.parametrize("text", ["", "   \n\t", "\u200b\u00ad", "\x00"])
def test_nothing_to_read_is_refused(text: str) -> None:
    with pytest.raises(LanguageError, match="without words"):
        tokenize(text)
