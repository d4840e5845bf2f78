"""Where phrases may begin and end: never where the treebank shows otherwise often enough, always where it is silent."""

from grounding.corpus.treebank import read_trees
from grounding.language.boundaries import Boundaries
from grounding.language.grammar import Grammar
from grounding.language.tags import TagModel
from grounding.language.tree import from_brackets
from models import TREEBANK

TREES = read_trees(TREEBANK)
GRAMMAR = Grammar.learn(TREES)


def openings(text):
    begins, ends = GRAMMAR.boundaries.openings([[word] for word in text.split()], GRAMMAR.words)
    return [int(one) for one in begins], [int(one) for one in ends]


def test_every_phrase_of_the_treebank_can_begin_and_end_where_it_does():
    for tree in TREES:
        begins, ends = GRAMMAR.boundaries.openings([[leaf.text] for leaf in tree.leaves], GRAMMAR.words)
        for phrase in tree.preorder():
            if len(phrase.leaves) > 1:
                assert begins[phrase.leaves[0].index]
                assert ends[phrase.leaves[-1].index]


def test_articles_and_prepositions_end_nothing_and_a_noun_may():
    _, ends = openings("take the block in the row")
    assert ends == [0, 0, 1, 0, 0, 1]


def test_words_nobody_knows_are_open():
    begins, ends = openings("take the zorb in the row")
    assert ends[2]
    assert begins[2]


def test_neighbours_count():
    trees = [from_brackets("(NP (NP (DT the) (NN left)) (PP (IN of) (NP (DT the) (NN row))))")[0]] * 20
    trees += [from_brackets("(NP (DT the) (JJ left) (NN row))")[0]] * 20
    words = TagModel.learn(trees)
    bounds = Boundaries.learn(trees, words)
    assert bounds.openings([["the"], ["left"], ["of"], ["the"], ["row"]], words)[1][1]
    assert not bounds.openings([["the"], ["left"], ["row"]], words)[1][1]
    assert bounds.openings([["the"], ["left"], ["blorb"]], words)[1][1]
