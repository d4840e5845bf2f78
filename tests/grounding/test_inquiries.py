"""Questions about the world are told from commands, and answered from what the words mean."""

import functools

import pytest

import models
from grounding.grounder import Grounder
from grounding.inquiries import inquiry_of
from grounding.world import World, load_world, make_object


@functools.cache
def grounder():
    return Grounder.load()


def block(name, color, x, y, z=0.025, kind="block"):
    return make_object(name, kind, color, (x, y, z), size=(0.05, 0.05, 0.05))


WORLD = World((
    make_object("table", "table", "white", (0.6, 0.0, -0.01), size=(0.6, 1.2, 0.02)),
    block("low", "red", 0.5, 0.3), block("high", "green", 0.5, 0.3, 0.075), block("left", "blue", 0.7, 0.2),
    block("right", "blue", 0.7, -0.3), block("cup", "yellow", 0.45, -0.1, kind="cup"),
))  # fmt: skip


@pytest.mark.parametrize(("text", "said"), [
    ("How many blue blocks are there?", "there are two"),
    ("how many towers do you see", "there is one"),
    ("is there a cup?", "yes, the yellow cup"),
    ("Is there a black block?", "no, there is no black block"),
    ("are there three blue blocks", "no, there are two"),
    ("what is the green block sitting on?", "the green block is on the red block"),
    ("what is on the red block", "the green block is on the red block"),
    ("what is on top of the cup", "nothing is on the yellow cup"),
    ("What color is the cup?", "yellow"),
    ("is the green block on the red block?", "yes"),
    ("is the cup on the red block?", "no"),
    ("where is the cup", "the yellow cup is on the table at x = 0.45 m, y = -0.10 m"),
])  # fmt: skip
def test_questions_are_answered(text, said):
    result = grounder().ground(text, WORLD)
    assert (result.outcome, result.answer) == ("answered", said)
    assert not result.actions
    assert result.to_json()["answer"] == said


def test_which_one_is_told_by_a_description_that_picks_it():
    world = load_world(models.SCENES / "four.json")
    told = grounder().ground("which block is closest to you?", world).answer
    picked, nearest = (grounder().ground(text, world) for text in (f"pick up {told}", "pick up the nearest block"))
    assert picked.actions[0].objects == nearest.actions[0].objects


@pytest.mark.parametrize("text", ["can you put the yellow block on the green one?", "pick up what is on the left",
                                  "could you take the cup", "the block that is on the red one", "what can you do?"])
def test_what_asks_for_something_to_be_done_is_no_question_about_the_world(text):
    assert inquiry_of(text) is None


def test_a_question_about_what_nobody_knows_is_not_understood():
    result = grounder().ground("how many wugs are there", WORLD)
    assert result.outcome == "not_understood"
    assert "wugs" in result.explanation


@pytest.mark.parametrize(
    "text",
    ["Do you see the two blues that touch? Take the one on my side.",
     "is there a tower on the left? lift its top block", "Can you see a red block? It is the one I want."],
)  # fmt: skip
def test_a_question_that_only_introduces_is_none(text):
    assert inquiry_of(text) is None


ALONE = ["is there a block at 0.5 m?", "Is there a red block? Thanks!", "how many blocks are there?!"]


@pytest.mark.parametrize("text", ALONE)
def test_a_question_by_itself_is_one(text):
    assert inquiry_of(text) is not None
