from math import exp

import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_treebank import TREES, VOCABULARY

from grounding.language.tags import TagModel

MODEL = TagModel.learn(TREES)


@given(st.text(min_size=1, max_size=12) | st.sampled_from(VOCABULARY))
def test_probabilities_of_a_word_sum_to_one(word: str) -> None:
    chances = MODEL.log_probabilities(word)
    assert sum(exp(chance) for chance in chances.values()) == pytest.approx(1.0)


@given(st.text(min_size=1, max_size=12) | st.sampled_from(VOCABULARY))
def test_every_tag_that_is_tried_for_a_rare_word_has_an_emission(word: str) -> None:
    for tag, chance in MODEL.log_probabilities(word).items():
        if MODEL.is_rare(word, tag):
            assert MODEL.log_emission(word, tag, chance) <= 0.0


def test_known_words_keep_their_tags() -> None:
    for tree in TREES:
        for leaf in tree.leaves:
            chances = MODEL.log_probabilities(leaf.text)
            assert leaf.tag in chances
            if len(MODEL.counts[leaf.text]) == 1:
                assert max(chances, key=chances.__getitem__) == leaf.tag


@pytest.mark.parametrize(("word", "tag"), [("7", "CD"), ("greebles", "NNS"), ("glass", "NN")])
def test_new_words_are_tagged_by_shape_and_ending(word: str, tag: str) -> None:
    assert not MODEL.is_known(word)
    chances = MODEL.log_probabilities(word)
    assert max(chances, key=chances.__getitem__) == tag
