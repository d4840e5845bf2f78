"""What is forbidden is not done; what only describes with "not" is."""

import pytest

from grounding.forbidding import forbidden, without_forbidden
from grounding.language.parser import Parser

PARSER = Parser.load()


def tree(text):
    return PARSER.parse(text)[0].tree


@pytest.mark.parametrize(
    "text", ["don't pick up the red block", "do not move the tower", "never touch the blue block", "do not take it"]
)
def test_commands_are_denied(text):
    assert "what not to do" in forbidden(tree(text))


@pytest.mark.parametrize(
    "text",
    ["pick up the block that is not blue", "take the block. it is not near the tower",
     "pick up the block which is not next to a red block", "pick up the red block", "the block isn't red. take it"],
)  # fmt: skip
def test_descriptions_are_not(text):
    assert forbidden(tree(text)) is None


def test_only_what_is_forbidden_is_left_out():
    whole = tree("pick up the red block. do not touch the tower")
    assert forbidden(whole) is None
    assert without_forbidden(whole).text == "pick up the red block"
    alone = tree("do not touch the tower")
    assert without_forbidden(alone) == alone


@pytest.mark.parametrize(
    "text", ["what is the leftmost block?", "how many red blocks are there?", "which block is the farthest?"]
)
def test_questions_are_not_acted_upon(text):
    assert "question" in forbidden(tree(text))


@pytest.mark.parametrize("text", ["smash the red block", "ignore the leftmost block", "please count the blocks"])
def test_other_deeds_are_none_of_its_own(text):
    assert text.replace("please ", "").split()[0] in forbidden(tree(text))


@pytest.mark.parametrize(
    "text", ["put the red block on itself", "place the red block next to itself", "put the red block on the floor"]
)
def test_there_are_places_where_nothing_can_be(text):
    assert forbidden(tree(text)) is not None


@pytest.mark.parametrize("text", ["take the block by itself", "put the red block on the table", "take a red block"])
def test_what_is_plain_is_allowed(text):
    assert forbidden(tree(text)) is None
