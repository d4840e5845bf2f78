import json

import numpy as np
import pytest

from grounding.corpus.generator import recognise
from grounding.corpus.shapes import misfit
from grounding.corpus.tabletop import TABLE
from grounding.symbols import Container
from grounding.world import World, load_world, make_object, save_world, world_to_json
from integration.corpus.settled_worlds import COMPOSED, PUSHED, confirmed, draw_settled, settled_from_json, well_named
from integration.worlds_and_scenes import scene_of
from motion import Simulator


@pytest.fixture(scope="module")
def drawn():
    return [draw_settled(3, number) for number in range(9)]


def laid(name, places, kind):
    blocks = [make_object(f"b{k}", "block", "red", place) for k, place in enumerate(places)]
    return recognise(name, World((*blocks, TABLE)), (Container(kind, tuple(block.id for block in blocks)),))


def test_worlds_of_both_kinds_are_drawn(drawn):
    assert {world.how for world in drawn} == {COMPOSED, PUSHED}
    assert len({world.name for world in drawn}) == len(drawn)
    for world in drawn:
        assert 3 <= len(world.world.things) <= 30
        assert 1 <= len({item.color for item in world.world.things}) <= 6


def test_a_world_is_its_seed_and_number(drawn):
    again = draw_settled(3, 4)
    assert again.to_json() == drawn[4].to_json()
    assert again.to_json() != draw_settled(4, 4).to_json()


def test_worlds_are_read_as_they_were_written(drawn, tmp_path):
    for world in drawn:
        assert settled_from_json(json.loads(json.dumps(world.to_json()))).to_json() == world.to_json()
        save_world(world.world, tmp_path / "world.json")
        assert world_to_json(load_world(tmp_path / "world.json")) == world_to_json(world.world)


def test_arrangements_are_still_what_they_are_called(drawn):
    kept = [(world, container) for world in drawn for container in world.containers]
    assert kept
    for world, container in kept:
        assert misfit(container.kind, [world.world[name] for name in container.objects]) is None


def test_what_is_too_crooked_for_its_name_is_not_spoken_of():
    z = 0.711 + 0.025
    places = [(0.5, -0.3, z), (0.7, -0.1, z), (0.5, 0.1, z), (0.7, 0.3, z)]
    crooked = laid("crooked", places, "row")
    straight = laid("straight", [(0.6, y, z) for _, y, _ in places], "row")
    assert ("row", 0b1111) not in well_named(crooked).arrangements
    assert well_named(straight).arrangements == straight.arrangements


@pytest.mark.parametrize("number", [2, 3])
def test_worlds_rest_in_the_simulation_with_the_robot(drawn, number):
    world = drawn[number].world
    scene = scene_of(world)
    with Simulator(scene) as simulator:
        simulator.settle(1.0)
        after = simulator.scene()
    assert max(np.linalg.norm(box.position - scene.box(box.name).position) for box in after.boxes) < 2e-3


def test_a_tower_that_does_not_stand_is_not_a_world():
    z = 0.711 + 0.025
    assert confirmed(laid("good", [(0.6, 0.0, z), (0.6, 0.005, z + 0.05), (0.5, 0.4, z)][:2], "tower")) is not None
    assert confirmed(laid("bad", [(0.6, 0.0, z), (0.6, 0.04, z + 0.05)], "tower")) is None


def test_blocks_inside_one_another_are_not_a_world():
    z = 0.711 + 0.025
    assert confirmed(laid("bad", [(0.6, 0.0, z), (0.61, 0.02, z), (0.5, 0.3, z)], "group")) is None
