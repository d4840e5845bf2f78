"""The table of words: what is shipped is sound, and bad tables are refused with file, entry and what would be right."""

import re

import pytest

from grounding.errors import LexiconError
from grounding.lexicon import words as w
from grounding.lexicon.vocabulary import WORDS, read_vocabulary, vocabulary

SHIPPED = WORDS.read_text(encoding="utf-8")


def refused(tmp_path, text):
    path = tmp_path / "table.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(LexiconError, match=re.escape(str(path))) as error:
        read_vocabulary(path)
    return str(error.value)


def test_a_copy_of_the_shipped_table_says_the_same(tmp_path):
    path = tmp_path / "table.toml"
    path.write_text(SHIPPED, encoding="utf-8")
    assert read_vocabulary(path) == vocabulary()


def test_a_word_said_twice_is_refused(tmp_path):
    told = refused(tmp_path, SHIPPED.replace('right = "right ', 'right = "left right ', 1))
    assert "[direction]" in told
    assert "'left'" in told
    assert "keep one of them" in told


def test_a_word_twice_in_one_value_is_refused_even_where_several_may_be_said(tmp_path):
    told = refused(tmp_path, SHIPPED.replace('row = "row ', 'row = "row row ', 1))
    assert "[arrangement]" in told
    assert "'row'" in told


def test_an_unknown_family_is_refused(tmp_path):
    told = refused(tmp_path, f'{SHIPPED}\n[weather]\nsun = "sunny"\n')
    assert "[weather]" in told
    assert "known are" in told
    assert "direction" in told


def test_a_missing_family_is_refused(tmp_path):
    start = SHIPPED.index("[negation]")
    without = SHIPPED[:start] + SHIPPED[SHIPPED.index("[", start + 1) :]
    assert "[negation] is missing" in refused(tmp_path, without)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("[direction\nleft", "no TOML"),
        (f'direction = "left"\n{SHIPPED[SHIPPED.index("[compass]"):]}', "expected [direction] to be a section"),
        (SHIPPED.replace('middle = "middle', 'few = 3\nmiddle = "middle', 1), "[middle] few: expected words in quotes"),
    ],
)
def test_what_is_no_table_is_refused(tmp_path, text, says):
    assert says in refused(tmp_path, text)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(LexiconError, match=r"nowhere\.toml"):
        read_vocabulary(tmp_path / "nowhere.toml")


@pytest.mark.parametrize(
    ("word", "names"),
    [
        ("left", ("left",)), ("leftmost", ("left",)), ("northeast", ("back", "right")), ("ne", ("back", "right")),
        ("left-hand", ("left",)), ("southernmost", ("front",)), ("topmost", ("up",)), ("red", ()), ("most", ()),
    ],
)  # fmt: skip
def test_directions_are_named_by_words_and_by_how_they_are_formed(word, names):
    assert w.directions(word) == names


def test_opposites_are_mutual_and_directions_of_the_table():
    values = {vocabulary().value("direction", word) for word in vocabulary().words("direction")}
    assert set(w.OPPOSITE) == values
    assert all(w.OPPOSITE[w.OPPOSITE[name]] == name != w.OPPOSITE[name] for name in values)
    assert not {"up", "down"} & set(w.flat(values))


def test_ranking_words_are_words_of_distance_with_the_same_side():
    for word in vocabulary().words("ranking"):
        assert w.distance(word) == vocabulary().value("ranking", word)
