"""Trees compared with their annotation: by tag and words, whatever the tree."""

import pytest

from grounding.inference import Hypothesis
from grounding.language.tree import from_brackets
from grounding.learning.evaluation import found, score_tree
from grounding.symbols import parse_symbols

GOLD = "(VP {action(pick)} (VB take) (NP {object(b1)} (NP {object(b1) object(b2)} (DT the) (NN block)) (PP {object(b2)} (IN on) (NP {object(b2)} (DT the) (NN left)))))"  # fmt: skip  # noqa: E501


def read(text):
    """A tree with its symbols by identity, and the hypothesis that would be exactly right for it."""
    tree, notes = from_brackets(text)
    symbols = {id(phrase): parse_symbols(note) for phrase, note in zip(tree.preorder(), notes, strict=True)}

    def hypothesis(phrase):
        chances = dict.fromkeys(symbols[id(phrase)], 0.8)
        return Hypothesis(symbols[id(phrase)], 0.0, tuple(map(hypothesis, phrase.phrases)), chances)

    return tree, symbols, hypothesis(tree)


def test_what_is_as_annotated_is_complete():
    tree, gold, hypothesis = read(GOLD)
    for threshold in (None, 0.75):
        score = score_tree(tree, gold, tree, hypothesis, threshold)
        assert (score.phrases, score.right, score.root, score.extra) == (5, 5, True, 0)
        assert score.complete
        assert score.mistakes == ()


def test_a_threshold_that_nothing_reaches_finds_nothing():
    tree, gold, hypothesis = read(GOLD)
    score = score_tree(tree, gold, tree, hypothesis, 0.8)
    assert score.right == 0
    assert not score.root
    assert all(mistake.found == frozenset() for mistake in score.mistakes)


def test_the_threshold_is_on_probabilities_not_on_the_hypothesis():
    likely, unlikely = sorted(parse_symbols("object(b1) object(b2)"), key=str)
    hypothesis = Hypothesis(frozenset({unlikely}), 0.0, (), {likely: 0.76, unlikely: 0.75})
    assert found(hypothesis, 0.75) == {likely}
    assert found(hypothesis, None) == {unlikely}


def test_another_attachment_is_wrong_where_the_trees_differ_and_nowhere_else():
    tree, gold, _ = read(GOLD)
    flat = "(VP {action(pick)} (VB take) (NP {object(b1) object(b2)} (DT the) (NN block)) (PP {object(b2)} (IN on) (NP {object(b2)} (DT the) (NN left))))"  # fmt: skip  # noqa: E501
    other, _, hypothesis = read(flat)
    score = score_tree(tree, gold, other, hypothesis)
    assert score.root
    assert (score.right, score.extra) == (4, 0)
    assert [(mistake.text, mistake.found) for mistake in score.mistakes] == [("the block on the left", None)]
    assert not score.complete


def test_a_phrase_too_many_is_not_complete():
    tree, gold, _ = read(GOLD)
    inner = "(NP {object(b2)} (DT the) (NN left))"
    deeper = GOLD.replace(inner, f"(NP {{object(b2)}} {inner})")
    other, _, hypothesis = read(deeper)
    score = score_tree(tree, gold, other, hypothesis)
    assert (score.right, score.extra) == (score.phrases, 1)
    assert score.root
    assert not score.complete


def test_of_phrases_over_the_same_words_the_outer_ones_are_matched_first():
    tree, gold, _ = read("(NP {object(b1)} (NP {object(b2)} (DT the) (NN block)))")
    same, _, right = read("(NP {object(b1)} (NP {object(b2)} (DT the) (NN block)))")
    swapped, _, wrong = read("(NP {object(b2)} (NP {object(b1)} (DT the) (NN block)))")
    assert score_tree(tree, gold, same, right).complete
    assert score_tree(tree, gold, swapped, wrong).right == 0


@pytest.mark.parametrize("root", ["NP", "FRAG"])
def test_a_root_of_another_tag_is_another_phrase(root):
    tree, gold, _ = read(GOLD)
    other, _, hypothesis = read(GOLD.replace("(VP", f"({root}", 1))
    score = score_tree(tree, gold, other, hypothesis)
    assert not score.root
    assert (score.right, score.extra) == (4, 1)
