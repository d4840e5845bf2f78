"""Where sentences end: marks, dashes between clauses, and commands that run into what was told before."""

import pytest

from grounding.language.sentences import part_commands, split_sentences
from grounding.language.tokens import tokenize


def lengths(sentences):
    return [len(sentence) for sentence in sentences]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("there are two on the left - take the near one", [6, 4]), ("the top - left corner", [4]),
        ("on the left, take the red block", [7]), ("one two. ! three", [2, 1]),
    ],
)  # fmt: skip
def test_marks_and_dashes_end_sentences(text, words):
    assert lengths(split_sentences(tokenize(text))) == words


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("here is a long row, take its last block", [5, 4]), ("on the left, take the red block", [7]),
        ("the nearest one is red, put it down", [5, 3]), ("take the red block, put it down", [7]),
        ("there are two red blocks here take the near one", [6, 4]),
        ("put it on the block on the left Take the red one", [8, 4]),
    ],
)  # fmt: skip
def test_commands_are_parted_from_what_is_told(text, words):
    assert lengths(part_commands(tokenize(text))) == words
