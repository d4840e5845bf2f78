"""Sentences end at marks, and where a command begins that runs into what was said before."""

import pytest

from grounding.language.sentences import part_commands, split_sentences
from grounding.language.tokens import tokenize


def said(sentences):
    return [" ".join(token.text for token in sentence) for sentence in sentences]


@pytest.mark.parametrize(
    ("text", "parted"),
    [
        ("There are two near the edge Take the far one", ["there are two near the edge", "take the far one"]),
        ("there is a pile on the left take its top", ["there is a pile on the left", "take its top"]),
        ("the lone cube is the farthest, put it on the pile", ["the lone cube is the farthest", "put it on the pile"]),
        ("pick the cube that stands alone, move it back", ["pick the cube that stands alone", "move it back"]),
        ("There Are Two Cubes, Take One", ["there are two cubes", "take one"]),
        ("take the red cube and put it down", ["take the red cube and put it down"]),
        ("in the far corner, take the red cube", ["in the far corner take the red cube"]),
        ("if it is red, take it", ["if it is red take it"]),
        ("take one, then move it", ["take one then move it"]),
        ("pick a place in the row", ["pick a place in the row"]),
    ],
)
def test_commands_begin_sentences(text, parted):
    assert said(part_commands(tokenize(text))) == parted


@pytest.mark.parametrize("text", ["There are two cubes Take one", "take one. then, move it!", "a - b", "one; two"])
def test_nothing_is_lost_or_moved(text):
    words = [token for token in tokenize(text) if token.is_word]
    for split in (split_sentences, part_commands):
        assert [token for sentence in split(tokenize(text)) for token in sentence] == words


def test_marks_alone_part_less():
    tokens = tokenize("there is a pile on the left take its top")
    assert len(split_sentences(tokens)) == 1
    assert len(part_commands(tokens)) == 2
