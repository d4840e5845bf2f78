"""What people would not say is not generated."""

import pytest

from grounding.corpus.making import make_corpus
from grounding.corpus.sense import is_sensible
from grounding.language.parser import Parser


@pytest.fixture(scope="module")
def parser():
    return Parser.load()


@pytest.mark.parametrize(
    "text",
    [
        "take the nearest block",
        "take the nearest block on the right",
        "take the block closest to the farthest block",  # one rank of each of two things
        "the block that is the nearest one to you",
        "take the block which stands by itself",
        "put it back",
    ],
)
def test_one_rank_by_distance_is_enough(parser, text):
    assert is_sensible(parser.parse(text, 1)[0].tree)


@pytest.mark.parametrize(
    "text",
    [
        "take the nearest block that is closest to you",
        "take the second nearest cube farthest from me",
        "the furthest brick that is the closest to you",
        "there is a block on itself",
        "bring it back",
        "please bring it back",
        "by itself pick up the red block",
    ],
)
def test_two_are_one_too_many(parser, text):
    assert not is_sensible(parser.parse(text, 1)[0].tree)


def test_what_is_generated_is_sensible():
    assert all(is_sensible(example.tree) for example in make_corpus(120, seed=8).examples)
