"""What is said of things and done with them is understood by the same words, in a few composed worlds."""

import numpy as np
import pytest
from crossing import NONE, ONE, TWO, Crossing, trials

from grounding import Grounder
from grounding.corpus.compositions import compose_world


@pytest.fixture(scope="module")
def crossing():
    found = Crossing(Grounder.load())
    for number in range(24):
        rng = np.random.default_rng([11, number])
        world = compose_world(rng, f"w{number}").layout.world
        scene = found.grounder.scene(world)
        found.describe(world, f"w{number}", str(rng.choice(scene.layout.ids)))
        for relation, names in trials(rng, world, scene):
            found.place(world, f"w{number}", relation, names)
    return found


def test_descriptions_are_understood(crossing):
    assert crossing.described.share() >= 0.9
    assert crossing.described.outcomes[""]["right"] > 15


def test_what_was_put_somewhere_is_found_there(crossing):
    assert crossing.placed.share() >= 0.9
    assert set(crossing.placed.outcomes) <= {*ONE, *TWO, *NONE}


def test_an_object_that_is_asked_for_by_a_wrong_description_counts_as_wrong(crossing):
    world = compose_world(np.random.default_rng([11, 0]), "w").layout.world
    first, second = world.things[:2]
    fresh = Crossing(crossing.grounder)
    fresh._name = lambda *_: crossing._name(world, second.id)
    fresh.describe(world, "w", first.id)
    assert fresh.described.share() == 0.0
    assert len(fresh.described.wrong) == 1
