"""Nouns: the words of a noun phrase say its head, what restricts it and what selects within."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.language.tree import Phrase, Word, from_brackets
from grounding.meaning.nouns import is_measuring, read_noun, read_words

TAGS = {"the": "DT", "a": "DT", "all": "DT", "two": "CD", "three": "CD", "five": "CD", "blocks": "NNS", "ones": "NNS"}


def words(text):
    return tuple(Word(word, TAGS.get(word, "JJ"), place) for place, word in enumerate(text.split()))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("the red block", {"head": "block", "colors": ("red",), "definite": True, "plural": False}),
        ("a red or blue block", {"head": "block", "colors": ("red", "blue"), "definite": False}),
        ("the five red blocks", {"head": "block", "number": 5, "plural": True}),
        ("all blocks", {"head": "block", "universal": True, "plural": True}),
        ("the second block", {"head": "block", "ordinals": (2,)}),
        ("the last block", {"head": "block", "ordinals": (-1,)}),
        ("the second to last block", {"ordinals": (-2,)}),
        ("the leftmost block", {"head": "block", "directions": ("left",)}),
        ("the top left block", {"head": "block", "directions": ("up", "left")}),
        ("the nearest block", {"head": "block", "distance": "near"}),
        ("the far block", {"head": "block", "distance": "far"}),
        ("the middle block", {"head": "block", "middle": True}),
        ("the lone block", {"head": "block", "lone": True, "unstacked": False}),
        ("the single block", {"head": "block", "lone": True, "unstacked": True}),
        ("the other block", {"head": "block", "other": True}),
        ("the others", {"head": "block", "other": True, "plural": True}),
        ("the only block", {"head": "block", "only": True}),
        ("the row", {"head": "container", "kinds": ("row",)}),
        ("the pair", {"head": "container", "kinds": ("group",), "number": 2}),
        ("the tallest tower", {"head": "container", "kinds": ("tower",), "size": 1}),
        ("the back left corner", {"head": "place", "place": "corner", "directions": ("back", "left")}),
        ("the far corner", {"head": "place", "directions": ("back",)}),
        ("the near edge", {"head": "place", "directions": ("front",)}),
        ("the left", {"head": "place", "place": None, "directions": ("left",)}),
        ("your left", {"head": "place", "agent": "robot"}),
        ("you", {"head": "agent", "agent": "robot"}),
        ("me", {"head": "agent", "agent": "speaker"}),
        ("it", {"head": "pronoun"}),
        ("the table", {"head": "table"}),
        ("two spaces", {"head": "measure", "number": 2}),
    ],
)
def test_words_say(text, said):
    noun = read_words(words(text))
    assert {name: getattr(noun, name) for name in said} == said


def test_a_word_that_nobody_knows_makes_a_thing_strange():
    noun = read_noun(from_brackets("(NP (DT the) (JJ red) (NN wug))")[0])
    assert noun.strange
    assert noun.unknown == ("wug",)
    assert not read_noun(from_brackets("(NP (DT the) (JJ red) (NN block))")[0]).strange


@pytest.mark.parametrize(
    ("brackets", "measures"),
    [
        ("(NP (CD two) (NNS spaces))", True), ("(NP (CD two) (NNS blocks))", True),
        ("(NP (DT the) (CD two) (NNS blocks))", False), ("(NP (DT the) (JJ red) (NN block))", False),
    ],
)  # fmt: skip
def test_a_measure_is_told_from_a_thing(brackets, measures):
    assert is_measuring(read_noun(from_brackets(brackets)[0])) == measures


def test_nested_heads_are_one_noun_with_all_modifiers():
    noun = read_noun(from_brackets(
        "(NP (NP (NP (DT the) (JJ red) (NN block)) (PP (IN in) (NP (DT the) (NN row))))"
        " (PP (IN on) (NP (DT the) (NN left))))"
    )[0])  # fmt: skip
    assert noun.colors == ("red",)
    assert [modifier.text for modifier in noun.modifiers] == ["in the row", "on the left"]


def test_colours_are_counted_one_by_one():
    noun = read_words(words("three green and two blue blocks"))
    assert noun.counted == ((3, "green"), (2, "blue"))
    assert noun.number == 5


@given(st.lists(st.sampled_from("the a red blue leftmost second nearest middle five row block corner it".split()),
                min_size=1, max_size=6))  # fmt: skip
def test_reading_is_the_same_each_time(chosen):
    phrase = Phrase("NP", words(" ".join(chosen)))
    assert read_noun(phrase) == read_noun(Phrase("NP", words(" ".join(chosen)))) == read_words(phrase.words)
