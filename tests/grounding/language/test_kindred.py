"""Words that the treebank has not are read where kindred ones stand."""

import pytest

from grounding.language.kindred import kindred
from grounding.language.parser import Parser

PARSER = Parser.load()


@pytest.mark.parametrize("verb", ["returns", "climbs", "scoots"])
def test_a_new_verb_is_read_as_its_kin_is(verb):
    text = "the red block {} to the left of the tower"
    new, known = (PARSER.parse(text.format(v))[0].tree for v in (verb, kindred(verb)))
    assert new.text == known.text.replace(kindred(verb), verb)
    assert [p.tag for p in new.preorder()] == [p.tag for p in known.preorder()]


def test_other_words_have_no_kin():
    assert kindred("wug") is None
    assert kindred("moves") is None


@pytest.mark.parametrize(("noun", "tag"), [("tetrahedron", "NN"), ("prisms", "NNS"), ("tetrahedra", "NNS")])
def test_a_kind_of_thing_is_read_as_a_block_is(noun, tag):
    tree = PARSER.parse(f"pick up the teal {noun} behind the red one")[0].tree
    assert next(leaf.tag for leaf in tree.leaves if leaf.text == noun) == tag
    known = PARSER.parse("pick up the red block behind the red one")[0].tree
    assert [p.tag for p in tree.preorder()] == [p.tag for p in known.preorder()]
