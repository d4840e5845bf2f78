"""A word that has no place in its sentence does not wreck it."""

from grounding.language.parser import Parser
from grounding.language.skipping import SKIPPED, restore
from grounding.language.tree import Phrase, Word, from_brackets


def without(tree, index):
    children = []
    for child in tree.children:
        if isinstance(child, Phrase):
            child = without(child, index)
        elif child.index == index:
            continue
        if not isinstance(child, Phrase) or child.children:
            children.append(child)
    return Phrase(tree.tag, tuple(children))


def test_a_word_comes_back_where_it_stood():
    tree = from_brackets(
        "(VP (VB take) (NP (NP (DT the) (JJ red) (NN cube)) (PP (IN behind) (NP (DT the) (NN row)))))"
    )[0]
    for leaf in tree.leaves:
        again = restore(without(tree, leaf.index), [leaf])
        assert [word.text for word in again.leaves] == [word.text for word in tree.leaves]
        assert [word.index for word in again.leaves] == list(range(len(tree.leaves)))
        assert again.leaves[leaf.index] == Word(leaf.text, SKIPPED, leaf.index)


def test_a_stray_word_is_skipped_and_the_rest_is_understood():
    text = "move the the is block to the left"  # two slips at once
    best = Parser.load().parse(text)[0]
    assert [leaf.tag for leaf in best.tree.leaves].count(SKIPPED) == 1
    assert best.tree.tag != "FRAG"
    assert not best.complete
    assert [leaf.index for leaf in best.tree.leaves] == list(range(len(best.tree.leaves)))
