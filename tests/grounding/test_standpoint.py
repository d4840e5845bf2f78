import functools

import numpy as np
import pytest

import models
from grounding import Grounder, World, load_world
from grounding.standpoint import UNKNOWN
from grounding.world import Viewpoint


@functools.cache
def grounder():
    return Grounder.load()


def world(name="four"):
    return load_world(models.SCENES / f"{name}.json")


@pytest.mark.parametrize(
    ("text", "told"),
    [("lift the red cube on my left", True), ("take the block closest to me", True),
     ("hand the leftmost block to me", False), ("lift the red cube on your left", False)],
)  # fmt: skip
def test_sides_of_a_speaker_nobody_placed_are_told(text, told):
    result = grounder().ground(text, world())
    assert result.outcome == "grounded"
    assert (result.explanation == UNKNOWN) == told


def test_a_speaker_who_stands_somewhere_is_understood():
    placed = World(world().objects, Viewpoint(np.array([1.6, 0.0, 0.0]), np.pi))
    result = grounder().ground("lift the red cube on my left", placed)
    assert result.outcome == "grounded"
    assert not result.explanation


def test_of_several_steps_it_is_told_once():
    result = grounder().ground("take the red block on my left, then take the red block on my right", world())
    assert len(result.actions) == 2
    assert result.explanation == UNKNOWN
