"""Words written apart, together or with hyphens come out in one spelling, in their places."""

import pytest

from grounding.language.parser import Parser
from grounding.language.rewriting import rewrite
from grounding.language.tokens import tokenize


@pytest.fixture(scope="module")
def known():
    return Parser.load()._is_known


@pytest.mark.parametrize(
    ("written", "read"),
    [
        ("the left-most block", "the leftmost block"),
        ("the left most block", "the leftmost block"),
        ("the north west corner", "the northwest corner"),
        ("the South-East corner", "the southeast corner"),
        ("NE of the tower", "northeast of the tower"),
        ("on your right hand side", "on your right-hand side"),
        ("with your right hand", "with your right hand"),
        ("the three-block stack", "the three block stack"),
        ("a two-story tower", "a two story tower"),
        ("the second-closest one", "the second closest one"),
        ("the top-left cube", "the top left cube"),
        ("pickup the block thats in-between", "pick up the block that 's in between"),
        ("move it infront of the tower", "move it in front of the tower"),
        ("put in on the tower", "put it on the tower"),
        ("the third cube form the left", "the third cube from the left"),
        ("form a row", "form a row"),
        ("the centre", "the center"),
        ("take the the block", "take the block"),
        ("so its next to its left side", "so it 's next to its left side"),
        ("furtherest tot he left", "furthest to the left"),
        ("the left-hand side", "the left-hand side"),
        ("the cube all the way on the right", "the cube furthest on the right"),
        ("the cube all of the way to the back", "the cube furthest to the back"),
        ("shift it all the way", "shift it all the way"),
        ("the cube on it's left", "the cube on its left"),
        ("the furthest most cube", "the furthest cube"),
        ("the far most of the two", "the farthest of the two"),
        ("the cube to it's lower right", "the cube to its lower right"),
        ("it's left of the tower", "it 's left of the tower"),
        ("the blorb-quux", "the blorb-quux"),
    ],
)
def test_one_spelling(written, read, known):
    tokens = rewrite(tokenize(written), known)
    assert " ".join(token.text for token in tokens) == read
    position = 0
    for token in tokens:
        assert position <= token.start < token.end <= len(written)
        assert written[token.start : token.end] == token.original
        position = token.end


def test_what_is_in_one_spelling_stays(known):
    for text in ("pick up the leftmost block that's on the left", "move it two spaces north, then left"):
        tokens = rewrite(tokenize(text), known)
        assert rewrite(tokens, known) == tokens
