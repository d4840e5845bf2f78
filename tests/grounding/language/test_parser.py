import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from small_treebank import TREES, VOCABULARY

import models
from grounding.errors import LanguageError, ModelError
from grounding.language.grammar import Grammar
from grounding.language.measure import brackets
from grounding.language.parser import Parser
from grounding.language.rewriting import rewrite
from grounding.language.sentences import part_commands, split_sentences
from grounding.language.spelling import distance
from grounding.language.tokens import tokenize
from grounding.language.tree import Word, from_brackets

PARSER = Parser(Grammar.learn(TREES))
texts = st.lists(st.sampled_from(VOCABULARY) | st.text(max_size=8), max_size=12).map(" ".join)


def test_learned_sentences_are_parsed_as_they_were_learned() -> None:
    for tree in TREES:
        assert PARSER.parse(tree.text)[0].tree == tree


@settings(deadline=None)
@given(texts, st.integers(1, 6))
def test_any_text_is_parsed_or_refused(text: str, k: int) -> None:
    try:
        parses = PARSER.parse(text, k)
    except LanguageError:
        assert not any(character.isalnum() for character in text)
        return
    words = [token.text for token in rewrite(tokenize(text), PARSER._is_known) if token.is_word]
    assert 1 <= len(parses) <= k
    for parse in parses:
        read = [leaf.text for leaf in parse.tree.leaves]
        assert all(distance(one, other) <= 2 for one, other in zip(read, words, strict=True))
        assert all(one == other for one, other in zip(read, words, strict=True) if PARSER._is_known(other))
        assert [leaf.index for leaf in parse.tree.leaves] == list(range(len(words)))
        assert parse.unknown_words == tuple(word for word in read if not PARSER._is_known(word))
        assert {after for _, after in parse.mended} <= set(read)
    scores = [parse.log_probability for parse in parses]
    assert scores == sorted(scores, reverse=True)
    assert sum(parse.probability for parse in parses) == pytest.approx(1.0)
    shapes = [(parse.tree.tag, sorted(brackets(parse.tree).items())) for parse in parses]
    assert all(shape not in shapes[:place] for place, shape in enumerate(shapes))


@settings(deadline=None)
@given(texts, st.integers(1, 4))
def test_fewer_readings_are_the_first_of_more(text: str, k: int) -> None:
    if any(character.isalnum() for character in text):
        trees = [parse.tree for parse in PARSER.parse(text, 5)]
        assert [parse.tree for parse in PARSER.parse(text, k)] == trees[: min(k, len(trees))]


def test_both_attachments_are_kept_and_the_verb_decides() -> None:
    place = "(PP (IN on) (NP (NP (NN top)) (PP (IN of) (NP (DT the) (NN tower)))))"
    thing = "(NP (DT the) (JJ blue) (NN block))"
    low, _ = from_brackets(f"(VP (VB pick) (PRT (RP up)) (NP {thing} {place}))")
    high, _ = from_brackets(f"(VP (VB pick) (PRT (RP up)) {thing} {place})")
    picks = [parse.tree for parse in PARSER.parse("pick up the blue block on top of the tower")]
    assert picks[0] == low
    assert high in picks
    low, _ = from_brackets(f"(VP (VB put) (NP {thing} {place}))")
    high, _ = from_brackets(f"(VP (VB put) {thing} {place})")
    puts = [parse.tree for parse in PARSER.parse("put the blue block on top of the tower")]
    assert puts[0] == high
    assert low in puts


@pytest.mark.parametrize("text", ["Put it down.", "put it down", "PUT, it down!", "“put it down”"])
def test_punctuation_and_case_make_no_difference(text: str) -> None:
    (best, *_) = PARSER.parse(text)
    assert best.tree == TREES[9]
    assert best.complete


def test_unknown_words_are_tagged_and_reported() -> None:
    (best, *_) = PARSER.parse("take the greenish gizmo in the row")
    assert best.complete
    assert best.unknown_words == ("greenish", "gizmo")
    assert Word("gizmo", "NN", 3) in best.tree.leaves


def test_what_the_grammar_does_not_cover_is_understood_in_pieces() -> None:
    (best, *_) = PARSER.parse("the red block up up on")
    assert not best.complete
    assert best.tree.tag == "FRAG"
    assert best.tree.children[0].text == "the red block"


def test_sentences_are_parsed_each_for_itself() -> None:
    (best, *_) = PARSER.parse("Take the red block. Put it down.")
    assert best.complete
    assert [phrase.text for phrase in best.tree.phrases] == ["take the red block", "put it down"]
    assert [len(sentence) for sentence in split_sentences(tokenize("one two. ! three"))] == [2, 1]


@pytest.mark.parametrize(
    ("text", "lengths"),
    [
        ("there are two on the left - take the near one", [6, 4]), ("the top - left corner", [4]),
        ("here is a long row, take its last block", [5, 4]), ("on the left, take the red block", [7]),
        ("take the one that is red, put it down", [6, 3]), ("take the red block, put it down", [7]),
    ],
)  # fmt: skip
def test_dashes_and_commas_end_what_is_told_before_a_command(text, lengths):
    assert [len(sentence) for sentence in part_commands(tokenize(text))] == lengths


@pytest.mark.parametrize("text", ["", " ", "...", "?!"])
def test_texts_without_words_are_refused(text: str) -> None:
    with pytest.raises(LanguageError):
        PARSER.parse(text)


def test_no_reading_asked_for_and_an_empty_grammar_are_refused() -> None:
    with pytest.raises(LanguageError, match="k=0"):
        PARSER.parse("take it", 0)
    with pytest.raises(LanguageError, match="empty"):
        Parser(Grammar.learn([]))


def test_very_long_texts_are_parsed() -> None:
    (best, *_) = PARSER.parse("take the red block in the row " * 20)
    assert len(best.tree.leaves) == 140


def test_the_shipped_grammar_reads_the_first_instruction(tmp_path) -> None:
    (best, *_) = Parser.load().parse("pick up the middle block in the row of five blocks on the right")
    assert best.complete
    assert best.tree.tag == "VP"
    assert not best.unknown_words
    assert models.GRAMMAR.exists()
    with pytest.raises(ModelError):
        Parser.load(tmp_path / "none.json")
