"""Hands are taken out of a text, sides stay."""

import pytest

from grounding.language.instruments import without_hands


@pytest.mark.parametrize(("text", "rest", "arms"), [
    ("pick up the red block with your left hand", "pick up the red block", ("left",)),
    ("Use the right arm to take the red block", "take the red block", ("right",)),
    ("left hand: put A on B", "put A on B", ("left",)),
    ("using your right gripper, lift the middle one", "lift the middle one", ("right",)),
    ("take A in the left hand and B in the right hand", "take A and B", ("left", "right")),
])  # fmt: skip
def test_a_hand_is_no_part_of_what_is_asked_for(text, rest, arms):
    found = without_hands(text)
    assert " ".join(found.text.split()) == rest
    assert found.arms == arms


@pytest.mark.parametrize("text", ["take the block on your left hand side", "put it on the right-hand side",
                                  "the left one", "with your left hand", "put it to the left of the right hand corner"])
def test_sides_stay(text):
    assert without_hands(text) == (text, ())
