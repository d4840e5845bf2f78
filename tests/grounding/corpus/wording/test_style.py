"""Manners of speaking leave the words in order, and take no more than articles."""

import numpy as np

from grounding.corpus.wording.style import speak
from grounding.language.tree import from_brackets

TREE = from_brackets("(VP (VB take) (NP (NP (DT the) (JJ red) (NN cube)) (PP (IN behind) (NP (DT the) (NN row)))))")[0]


def test_articles_go_and_fillers_come():
    rng = np.random.default_rng(0)
    told = [speak(TREE, rng) for _ in range(400)]
    assert {name for _, manners in told for name in manners} == {"style.articles_dropped", "style.hesitation"}
    for tree, manners in told:
        words = [leaf.text for leaf in tree.leaves]
        rest = [word for word in words if word not in ("um", "uh", "er", "the")]
        assert rest == ["take", "red", "cube", "behind", "row"]
        assert manners or tree == TREE
