import numpy as np
import pytest
from small_treebank import TREES

from grounding.language.grammar import Grammar
from grounding.language.measure import brackets, held_out, score
from grounding.language.parser import Parser


def test_a_parser_of_the_same_trees_is_right_everywhere() -> None:
    result = score(Parser(Grammar.learn(TREES)), TREES)
    assert result.sentences == result.exact == result.among == result.structure == len(TREES)
    assert result.f1 == 1.0


def test_scores_add_up() -> None:
    parser = Parser(Grammar.learn(TREES[:6]))
    assert score(parser, TREES[:4]) + score(parser, TREES[4:]) == score(parser, TREES)


def test_brackets_are_the_phrases() -> None:
    for tree in TREES:
        spans = brackets(tree)
        assert sum(spans.values()) == sum(1 for _ in tree.preorder())
        assert (tree.tag, 0, len(tree.leaves)) in spans


@pytest.mark.parametrize("parts", [2, 5])
def test_parts_are_by_wording_and_cover_the_treebank(parts: int) -> None:
    trees = (*TREES, TREES[0])
    seen = []
    for learned, parsed in held_out(trees, parts, np.random.default_rng(3)):
        assert not {tree.text for tree in learned} & {tree.text for tree in parsed}
        assert len(learned) + len(parsed) + (TREES[0] in parsed) == len(trees)
        seen.extend(tree.text for tree in parsed)
    assert sorted(seen) == sorted({tree.text for tree in trees})
