"""The scenes that ship: at rest, graspable, and with the arrangements that instructions speak of."""

from itertools import combinations

import numpy as np
import pytest

from grounding.corpus import scenes
from grounding.corpus.scenes import lines_of_three
from grounding.corpus.shapes import misfit
from grounding.corpus.tabletop import TABLE_TOP
from grounding.world import load_world, world_to_json
from models import SCENES

FINGER = 0.023  # free width that a paddle finger needs beside a block [m]
NAMES = sorted(scenes.PLANS)


@pytest.fixture(params=NAMES)
def scene(request):
    world = load_world(SCENES / f"{request.param}.json")
    _, table = scenes.lay(request.param)
    return request.param, world, table


def test_every_plan_has_its_file_and_every_file_its_plan():
    assert sorted(path.stem for path in SCENES.glob("*.json")) == NAMES


def test_files_are_what_the_plans_lay(scene):
    _, world, table = scene
    expected, stored = world_to_json(table.world()), world_to_json(world)
    for one, other in zip(expected["objects"], stored["objects"], strict=True):
        assert one["id"] == other["id"]
        assert one["color"] == other["color"]
        for key in ("position", "orientation", "size"):
            assert one[key] == pytest.approx(other[key], abs=1e-9)


def test_blocks_rest_on_the_table_or_exactly_on_each_other(scene):
    _, world, _ = scene
    tops = [TABLE_TOP] + [block.position[2] + block.size[2] / 2 for block in world.things]
    for block in world.things:
        assert min(abs(block.position[2] - block.size[2] / 2 - top) for top in tops) < 1e-6
    table = world["table"]
    assert table.position[2] + table.size[2] / 2 == pytest.approx(TABLE_TOP)


def test_blocks_are_within_reach(scene):
    _, world, _ = scene
    assert (world.positions[:, 0] >= 0.45).all()
    assert (world.positions[:, 0] <= 0.80).all()
    assert (np.abs(world.positions[:, 1]) <= 0.65).all()


def beside(first, second):
    return abs(first.position[2] - second.position[2]) < (first.size[2] + second.size[2]) / 2 - 1e-6


def test_a_gripper_finds_room_on_two_opposite_sides(scene):
    _, world, _ = scene
    free = 0
    for block in world.things:
        w, _, _, z = block.orientation
        yaw = 2 * np.arctan2(z, w)
        others = [o for o in world.things if o is not block and beside(o, block)]
        sides = []
        for turn in (yaw, yaw + np.pi / 2):
            direction = np.array([np.cos(turn), np.sin(turn)])
            across = np.array([-direction[1], direction[0]])
            reach = block.size[0] / 2 + FINGER
            offsets = [o.position[:2] - block.position[:2] for o in others]
            radii = [o.half_extents[:2].max() for o in others]
            sides.append(
                all(
                    abs(offset @ direction) >= reach + radius or abs(offset @ across) >= 0.012 + radius
                    for offset, radius in zip(offsets, radii, strict=True)
                )
            )
        free += any(sides)
    assert free >= 0.9 * len(world.things)


def test_laid_arrangements_are_what_they_are_called(scene):
    _, world, table = scene
    for container in table.containers:
        assert misfit(container.kind, [world[name] for name in container.objects]) is None


def test_the_default_scene_is_that_of_the_paper():
    world = load_world(SCENES / "default.json")
    row, column = scenes.lay("default")[1].containers
    assert (row.kind, len(row.objects)) == ("row", 5)
    assert (column.kind, len(column.objects)) == ("column", 3)
    assert len(world.things) == 20
    assert {block.color for block in world.things} == {"red"}
    assert max(world[name].position[1] for name in row.objects) < -0.1 < 0.1 < min(
        world[name].position[1] for name in column.objects
    )  # fmt: skip


def test_no_other_line_is_evident_in_the_default_scene():
    world, table = scenes.lay("default")
    laid = [set(container.objects) for container in table.containers]
    ids = [block.id for block in world.things]
    for triple in lines_of_three(world.positions[:, :2]):
        assert any({ids[i] for i in triple} <= members for members in laid)


@pytest.mark.parametrize(
    ("name", "count", "colors", "kinds"),
    [
        ("four", 4, 2, []),
        ("seven", 7, 2, ["row4"]),
        ("twelve", 12, 3, ["circle6", "column4"]),
        ("tower", 9, 4, ["tower2", "tower3"]),
        ("groups", 8, 2, ["group5", "row3"]),
        ("two_rows", 10, 1, ["row5", "row5"]),
        ("scattered", 15, 5, []),
        ("twenty_mixed", 20, 5, ["column3", "row5", "tower2", "tower3"]),
    ],
)
def test_the_other_scenes_hold_what_they_promise(name, count, colors, kinds):
    world, table = scenes.lay(name)
    assert len(world.things) == count
    assert len({block.color for block in world.things}) == colors
    assert sorted(f"{c.kind}{len(c.objects)}" for c in table.containers) == kinds


def test_lines_are_found_wherever_they_lie():
    points = np.array([[0.5, 0.1], [0.505, 0.2], [0.5, 0.3], [0.9, 0.9]])
    assert lines_of_three(points).tolist() == [[0, 1, 2]]
    assert lines_of_three(points[:, ::-1]).tolist() == [[0, 1, 2]]
    for order in combinations(range(4), 3):
        assert len(lines_of_three(points[list(order)])) == (order == (0, 1, 2))
