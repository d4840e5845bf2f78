"""Descriptions are understood: what the robot says of a thing leads the parser and the reader back to that thing."""

import functools

import numpy as np
import pytest

import models
from grounding import Viewpoint, World, load_world, make_object
from grounding.corpus.composer import compose
from grounding.distinguishing import Describer, Description, listed_descriptions
from grounding.geometry.layout import Layout
from grounding.language.parser import Parser
from grounding.model.belief import believe, read
from grounding.model.evaluator import EVEN
from grounding.world.scene import Scene

SWAPPED = {"you": "me", "me": "you", "your": "my", "my": "your"}


@functools.cache
def parser():
    return Parser.load()


def meant(text, scene):
    """The thing that a person means who says this to the robot."""
    belief = believe(read(parser().parse(f"pick up {text}", 4), scene), EVEN)
    return next((names for names, _ in belief.options if names), ())


def worlds():
    for seed in range(12):
        yield compose(np.random.default_rng(seed)).world
    for name in ("seven", "tower", "twelve", "scattered"):
        yield load_world(models.SCENES / f"{name}.json")


def test_what_is_said_is_understood():
    right = total = 0
    for world in worlds():
        scene = Scene(Layout(world))
        describer = Describer(scene)
        for name in scene.layout.ids[:6]:
            description = describer.describe(name)
            if 0 < description.cost < 1:
                total += 1
                right += meant(description.text, scene) == (name,)
    assert total > 40
    assert right >= 0.9 * total


def test_directions_say_whose_they_are_where_people_face_each_other():
    scene = load_world(models.SCENES / "seven.json")
    world = World(scene.objects, Viewpoint((1.5, 0.0, 0.0), np.pi))
    facing = Scene(Layout(world))
    texts = [Describer(facing).describe(name).text for name in facing.layout.ids]
    turned = [" ".join(SWAPPED.get(word, word) for word in text.split()) for text in texts]
    assert any("closest to" in text or "on your" in text for text in texts)
    found = [meant(text, facing) == (name,) for text, name in zip(turned, facing.layout.ids, strict=True)]
    assert sum(found) >= 0.7 * len(found)


def blocks(*colors):
    return Scene(
        Layout(World(tuple(make_object(f"b{i}", color=c, position=(0.6, 0.2 * i, 0.7)) for i, c in enumerate(colors))))
    )


def test_a_colour_is_enough_where_it_is_the_only_one():
    assert Describer(blocks("red", "blue", "red")).describe("b1").text == "the blue block"


def test_no_colour_is_said_where_all_have_it():
    assert Describer(blocks("red", "red")).describe("b1").text == "the leftmost block"


@pytest.mark.parametrize(
    ("texts", "rest", "said"),
    [
        (["the red block"], 0, "the red block"),
        (["the leftmost red block", "the rightmost red block"], 0, "the leftmost red block or the rightmost one"),
        (["the red block", "the blue block"], 0, "the red block or the blue block"),
        (["the leftmost red block", "the nearest red block"], 2,
         "the leftmost red block, the nearest one, or one of two others"),
        (["the red block", "the blue block"], 1, "the red block, the blue block, or another one"),
    ],
)  # fmt: skip
def test_what_is_named_again_is_called_one(texts, rest, said):
    described = [Description(text, "red block" if "red" in text else "blue block") for text in texts]
    assert listed_descriptions(described, rest) == said
