"""Misspellings: the distance, the candidates, and what the parser makes of them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.language.lexicon import known_colors
from grounding.language.parser import Parser
from grounding.language.spelling import Speller, distance

words = st.text("abcde", max_size=7)


@pytest.fixture(scope="module")
def parser():
    return Parser.load()


@given(words, words)
def test_the_distance_is_symmetric_and_zero_for_the_same_word(one, other):
    assert distance(one, other) == distance(other, one)
    assert (distance(one, other) == 0) == (one == other)
    assert abs(len(one) - len(other)) <= distance(one, other) <= max(len(one), len(other))


@pytest.mark.parametrize(
    ("one", "other", "edits"),
    [("block", "blcok", 1), ("block", "bock", 1), ("block", "blocks", 1), ("red", "der", 2), ("", "abc", 3)],
)
def test_one_edit_is_a_letter_more_or_less_another_or_two_swapped(one, other, edits):
    assert distance(one, other) == edits


def test_candidates_are_near_and_of_the_vocabulary():
    speller = Speller(["block", "black", "row", "leftmost", "red"])
    assert {spelling.word for spelling in speller.candidates("blck")} == {"block", "black"}
    assert [spelling.word for spelling in speller.candidates("lefmotst")] == ["leftmost"]
    assert not speller.candidates("ro")  # too short to tell
    assert not speller.candidates("xylophone")
    assert not speller.candidates("rod")  # a word of its own


@pytest.mark.parametrize("color", known_colors())
def test_no_colour_becomes_another(parser, color):
    (parse,) = parser.parse(f"take the {color} block", 1)
    assert color in [leaf.text for leaf in parse.tree.leaves]
    assert not parse.mended


@pytest.mark.parametrize(
    ("written", "mended"),
    [
        ("pick up teh gren blokc", (("teh", "the"), ("gren", "green"), ("blokc", "block"))),
        ("pick up the block closet to you", (("closet", "closest"),)),
        ("take the Yelow cube in the midle of the rwo", (("Yelow", "yellow"), ("midle", "middle"), ("rwo", "row"))),
        ("take the furtherest block", (("furtherest", "furthest"),)),
        ("take the left-most block", ()),
        ("take the LEFT most block", ()),
        ("take the leftmost block", ()),
    ],
)
def test_misspellings_are_mended_and_told(parser, written, mended):
    best = parser.parse(written)[0]
    assert best.mended == mended
    assert not best.unknown_words
    assert all(read in [leaf.text for leaf in best.tree.leaves] for _, read in mended)


@pytest.mark.parametrize("word", ["spoon", "plate", "stick", "clock", "rod", "zorblaxian"])
def test_words_of_their_own_stay_unknown(parser, word):
    best = parser.parse(f"pick up the {word}")[0]
    assert best.unknown_words == () if parser.grammar.words.is_known(word) else (word,)
    assert not best.mended
    assert best.tree.leaves[-1].tag == "NN"


@pytest.mark.parametrize("word", ["taking", "stacking", "using", "sliding"])
def test_forms_of_known_verbs_are_no_misspellings(parser, word):
    assert not Speller(["take", "stack", "use", "slide", "making", "sticking", "suing", "siding"]).candidates(word)
