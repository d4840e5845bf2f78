import models
from grounding.corpus import load_corpus
from grounding.corpus.check import check_corpus
from grounding.corpus.treebank import read_trees


def test_the_shipped_treebank_agrees_with_its_worlds_and_itself():
    assert check_corpus(load_corpus()) == ()


def test_every_example_is_one_of_the_gold_trees():
    trees = {str(tree) for tree in read_trees(models.TREEBANK)}
    examples = load_corpus().examples
    assert {str(example.tree) for example in examples} <= trees
    assert len({example.instruction for example in examples}) >= 300
