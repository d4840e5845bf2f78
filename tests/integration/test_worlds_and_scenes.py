import numpy as np
import pytest
from by_hand import scene

from grounding import World, make_object
from integration.worlds_and_scenes import scene_of, world_at
from motion import Pose


def test_names_places_and_sizes_are_kept():
    world = scene("twenty_mixed")
    built = scene_of(world)
    assert set(built.names) == {item.id for item in world.objects}
    for box in built.boxes:
        assert np.array_equal(box.position, world[box.name].position)
        assert np.array_equal(box.size, world[box.name].size)


def test_the_table_is_fixed_and_blocks_are_loose_and_of_wood():
    built = scene_of(scene("twenty_mixed"))
    assert [box.name for box in built.boxes if box.fixed] == ["table"]
    assert built.box("b1").mass == pytest.approx(0.1)
    assert built.box("b14").mass == pytest.approx(0.8 * 0.04**3 * 1000)


def test_hands_floor_and_robot_are_left_to_motion():
    world = World((make_object("hand", "robot"), make_object("ground", "floor"), make_object("b1", position=(1, 0, 1))))
    assert scene_of(world).names == ("b1",)


def test_colours_are_told_apart_and_unknown_ones_have_a_look():
    world = World(tuple(make_object(name, color=name) for name in ("red", "green", "blue", "octarine")))
    colors = [box.color for box in scene_of(world).boxes]
    assert len(set(colors)) == 4
    assert int(np.argmax(colors[0][:3])) == 0
    assert int(np.argmax(colors[1][:3])) == 1
    assert int(np.argmax(colors[2][:3])) == 2


def test_observed_poses_become_a_world():
    world = scene("four")
    turned = (np.sqrt(0.5), 0, 0, np.sqrt(0.5))
    after = world_at(world, {"b2": Pose((0.1, 0.2, 0.3), turned)})
    assert after["b2"].position == pytest.approx([0.1, 0.2, 0.3])
    assert after["b2"].orientation == pytest.approx(turned)
    assert after["b2"].color == world["b2"].color
    assert after["b1"] is world["b1"]
    assert world_at(world, {box.name: box.pose for box in scene_of(world).boxes}).by_id.keys() == world.by_id.keys()
