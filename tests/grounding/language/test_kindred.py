"""Verbs that the treebank has not are read where kindred ones stand."""

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
    assert kindred("block") is None
    assert kindred("moves") is None
