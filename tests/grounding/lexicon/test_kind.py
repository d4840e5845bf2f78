"""Kinds of things: a type word restricts, "object" does not, and a world's own types are words."""

import numpy as np
import pytest

from grounding.geometry.layout import Layout
from grounding.lexicon import kind
from grounding.world import World, make_object
from grounding.world.scene import Scene


def scene(*types):
    things = (make_object(f"o{i}", name, "red", (0.5, 0.2 * i, 0.0)) for i, name in enumerate(types))
    return Scene(Layout(World(tuple(things))))


@pytest.mark.parametrize("types", [("block", "pyramid", "cup"), ("Box", "prism", "mug"), ("cube", "triangle", "cup")])
def test_a_kind_holds_of_what_a_world_calls_so_by_any_name(types):
    held = [kind.truth(scene(*types), (name,)).tolist() for name in ("block", "pyramid", "cup")]
    assert held == np.eye(3).tolist()


def test_nothing_is_of_a_kind_that_is_not_there():
    assert not kind.truth(scene("block", "cup"), ("pyramid",)).any()


def test_what_a_world_leaves_open_is_of_every_kind():
    assert kind.truth(scene("object", "cup"), ("block",)).tolist() == [1.0, 0.0]
    assert kind.truth(scene("block", "cup"), ()).tolist() == [1.0, 1.0]


def test_a_type_that_nobody_knows_is_called_by_its_name():
    held = kind.called(scene("wug", "block"), "wugs")
    assert held[0] == 1.0 > held[1]
