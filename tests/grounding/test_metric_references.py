"""Things that are told by a length from others: "the block 10 cm behind the blue one"."""

import functools

import pytest

import models
from grounding.grounder import Grounder
from grounding.meaning.discourse.following import read_text
from grounding.meaning.notation import write
from grounding.meaning.notation_parser import parse_meaning
from grounding.meaning.reader import Reader
from grounding.meaning.reading import Context
from grounding.world import World, load_world, make_object

TABLE = load_world(models.SCENES / "four.json")["table"]
PLACES = {"blue": ("blue", 0.45, 0.0), "near": ("red", 0.55, 0.0), "mid": ("red", 0.65, 0.0), "far": ("red", 0.85, 0.0),
          "left": ("red", 0.45, 0.3), "lefter": ("red", 0.45, 0.55)}  # fmt: skip
WORLD = World(
    (TABLE, *(make_object(name, color=color, position=(x, y, 0.736)) for name, (color, x, y) in PLACES.items()))
)


@functools.cache
def grounder():
    return Grounder.load()


@pytest.mark.parametrize(
    ("text", "name"),
    [("pick up the red block 10 cm behind the blue one", "near"),
     ("pick up the red block 20 centimeters behind the blue one", "mid"),
     ("pick up the red block 0.4 m behind the blue one", "far"),
     ("take the red block that is 30 cm to the left of the blue block", "left"),
     ("take the red block half a metre to the left of the blue block", "lefter")],
)  # fmt: skip
def test_a_thing_is_told_by_a_length_from_another(text, name):
    best = grounder().understand(text, WORLD).belief.listed()[0]
    assert best.objects == (name,)


def test_a_length_is_read_back_from_its_notation():
    tree = grounder().parser.parse("pick up the block 10 cm behind the blue one", 1)[0].tree
    text = write(read_text(tree, Reader(Context())))
    assert "measured back of x2 amount 0.1 metres" in text
    assert write(parse_meaning(text)) == text
