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
