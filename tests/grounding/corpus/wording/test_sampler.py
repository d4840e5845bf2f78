"""Sentences drawn from the productions: the same from the same seed, on what was asked for, as trees ought to be."""

import numpy as np
import pytest

from grounding.corpus.wording import FAMILIES, MARKS, PRODUCTIONS, Topics, sample, sample_tree, sentences_of
from grounding.corpus.wording.words import USUAL_TAGS
from grounding.errors import CorpusError
from grounding.language.events import Child, tree_events
from grounding.language.lexicon import known_colors
from grounding.language.sentences import split_sentences
from grounding.language.tags import TagModel
from grounding.language.tokens import tokenize
from grounding.language.tree import Phrase, from_brackets


def drawn(count, seed=0, topics=None):
    rng = np.random.default_rng(seed)
    return [sample(rng, topics) if topics else sample(rng) for _ in range(count)]


def test_the_same_seed_gives_the_same_sentences():
    assert drawn(40, 3) == drawn(40, 3)
    assert drawn(40, 3) != drawn(40, 4)


def test_trees_are_numbered_and_survive_being_written_and_read():
    for one in drawn(300):
        assert [leaf.index for leaf in one.tree.leaves] == list(range(len(one.tree.leaves)))
        assert from_brackets(str(one.tree))[0] == one.tree
        assert all(phrase.children for phrase in one.tree.preorder())


def test_words_are_what_the_tokenizer_makes_of_the_text():
    for one in drawn(300, 1):
        (words,) = split_sentences(tokenize(one.tree.text.replace(" 's", "'s").replace(" 'd", "'d")))
        assert [word.text for word in words] == [leaf.text for leaf in one.tree.leaves]


def test_sentences_of_a_text_make_up_the_text():
    for one in drawn(300, 2):
        parts = sentences_of(one.tree)
        assert " ".join(part.text for part in parts) == one.tree.text
        assert all(part.tag != "FRAG" and part.leaves[0].index == 0 for part in parts)


def test_every_production_is_used_sooner_or_later():
    used = {name for one in drawn(12000, 5) for name in one.productions}
    names = {production.name for productions in PRODUCTIONS.values() for production in productions}
    assert len(names) > 500
    assert len(names - used) < 0.01 * len(names), sorted(names - used)


@pytest.mark.parametrize("family", FAMILIES)
def test_families_are_kept_to(family):
    for one in drawn(60, topics=Topics(families=frozenset({family}))):
        assert one.family == family
        assert one.productions[0].startswith(family + ".")


@pytest.mark.parametrize("mark", MARKS)
def test_what_is_left_out_is_not_spoken_of(mark):
    banned = {p.name for productions in PRODUCTIONS.values() for p in productions if mark in p.marks}
    for one in drawn(150, topics=Topics(without=frozenset({mark}))):
        assert not banned & set(one.productions)


def test_without_colours_no_colour_is_named():
    for one in drawn(200, topics=Topics(without=frozenset({"color"}))):
        assert not set(known_colors()) & {leaf.text for leaf in one.tree.leaves}


def test_without_several_there_is_one_sentence():
    topics = Topics(without=frozenset({"several"}))
    assert all(one.tree.tag != "FRAG" for one in drawn(200, topics=topics))
    assert any(one.tree.tag == "FRAG" for one in drawn(200))


def test_everything_left_out_still_gives_sentences():
    rng = np.random.default_rng(0)
    assert all(isinstance(sample_tree(rng, Topics(without=frozenset(MARKS))), Phrase) for _ in range(50))


@pytest.mark.parametrize("wrong", [{"families": frozenset({"dance"})}, {"without": frozenset({"smell"})}])
def test_topics_nobody_knows_are_refused_by_name(wrong):
    with pytest.raises(CorpusError, match=r"dance|smell"):
        Topics(**wrong)
    with pytest.raises(CorpusError, match="none"):
        Topics(families=frozenset())


def test_prepositional_phrases_have_the_word_that_names_the_relation_as_head():
    words = TagModel.learn([one.tree for one in drawn(500)])
    heads = {
        event.label for one in drawn(200) for event in tree_events(one.tree, words)
        if isinstance(event, Child) and event.tag == "PP"
    }  # fmt: skip
    assert {"IN:behind", "JJ:next", "JJS:closest", "VBG:touching"} <= heads


def test_usual_tags_are_one_a_word():
    assert USUAL_TAGS["near"] == "IN"
    assert USUAL_TAGS["put"] == "VB"
