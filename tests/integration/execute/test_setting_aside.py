import numpy as np
import pytest
from by_hand import scene

from integration.execute.distances import distances_outside
from integration.execute.setting_aside import beside, out_of_the_way, region_of, spots_clear_of
from integration.worlds_and_scenes import scene_of
from motion.plan.free_spots import MARGIN, ROOM


@pytest.mark.parametrize("name", ["default", "tower", "twenty_mixed"])
def test_free_spots_keep_away_from_every_other_block_and_from_the_edge(name):
    built = scene_of(scene(name))
    spots = spots_clear_of(built, "b1")
    table = built.box("table")
    assert len(spots) > 100
    for box in built.boxes:
        if not box.fixed and box.name != "b1":
            assert np.linalg.norm(spots[:, :2] - box.position[:2], axis=1).min() >= 0.05 + ROOM
    inside = table.half_extents[:2] - np.abs(spots[:, :2] - table.position[:2])
    assert inside.min() >= 0.025 + MARGIN
    assert spots[:, 2] == pytest.approx(table.top + 0.025)


def test_spots_out_of_the_way_are_outside_the_region():
    built = scene_of(scene("groups"))
    region = region_of(built, ["b6", "b7", "b8"])
    spots = out_of_the_way(built, "b7", region)
    assert distances_outside(region, spots[:, :2]).min() >= 0.025
    assert np.linalg.norm(spots[0][:2] - built.box("b7").position[:2]) < 0.4


def test_a_region_holds_its_blocks():
    built = scene_of(scene("groups"))
    region = region_of(built, ["b1", "b2", "b3"])
    corners = np.concatenate([built.box(name).footprint for name in ("b1", "b2", "b3")])
    assert distances_outside(region, corners).max() < 0


def test_beside_begins_with_the_nearest():
    built = scene_of(scene("four"))
    spots = beside(built, "b1", (0.6, 0.0, 0.736))
    ways = np.linalg.norm(spots[:, :2] - [0.6, 0.0], axis=1)
    assert (np.diff(ways) > -1e-4).all()


def test_no_table_no_spots():
    world = scene("four")
    built = scene_of(world.with_objects(item for item in world.objects if item.type != "table"))
    assert spots_clear_of(built, "b1").shape == (0, 3)
