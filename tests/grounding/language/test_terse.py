"""Trees without articles: the same words otherwise, numbered anew."""

from grounding.language.parser import Parser
from grounding.language.terse import terse, with_terse
from grounding.language.tree import from_brackets

TREE = from_brackets("(VP (VB put) (NP (DT the) (JJ red) (NN block)) (PP (IN on) (NP (DT a) (NN tower))))")[0]


def test_articles_are_left_out_and_words_numbered_anew():
    short = terse(TREE)
    assert short.text == "put red block on tower"
    assert [leaf.index for leaf in short.leaves] == list(range(5))
    assert [p.tag for p in short.preorder()] == [p.tag for p in TREE.preorder()]


def test_what_is_named_by_its_article_alone_keeps_it():
    pointing = from_brackets("(VP (VB take) (NP (DT the) (JJ red)))")[0]
    assert terse(pointing).text == pointing.text


def test_trees_come_first_and_some_once_more():
    found = list(with_terse([TREE] * 5))
    assert found[:5] == [TREE] * 5
    assert [tree.text for tree in found[5:]] == ["put red block on tower", "put red on tower"]


def test_a_text_without_articles_is_parsed_as_with_them():
    parser = Parser.load()
    for text in ("place gray pyramid on gray cube", "move red block to top of blue tower"):
        tree = parser.parse(text)[0].tree
        assert tree.tag == "VP"
        assert tree.children[0].tag == "VB"
