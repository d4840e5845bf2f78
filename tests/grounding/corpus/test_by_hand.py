"""Scenes for people to write about: at rest, graspable, seen by their writer, and with places that are free."""

import json
from collections import Counter

import numpy as np
import pytest
from PIL import Image

from grounding.__main__ import main
from grounding.corpus.by_hand import KINDS, lay_scene, make_scenes
from grounding.corpus.by_hand.room import EDGE, apart, gap, graspable, supports
from grounding.corpus.tabletop import TABLE_TOP
from grounding.errors import CorpusError
from grounding.pictures.boxes import visible
from grounding.pictures.seen import SIZE, Marks, draw_seen, scene_camera
from grounding.world import load_worlds, world_to_json


@pytest.fixture(scope="module")
def made():
    return make_scenes(16, 3)


def test_kinds_and_writers_come_in_equal_numbers(made):
    assert set(Counter(scene.kind for scene, _, _ in made).values()) == {2}
    assert {(scene.kind, scene.world.speaker is None) for scene, _, _ in made} == {
        (kind, alone) for kind in KINDS for alone in (True, False)
    }


def test_the_same_seed_gives_the_same_scenes(made):
    for (scene, *tasks), (other, *others) in zip(made[:4], make_scenes(4, 3), strict=True):
        assert world_to_json(scene.world) == world_to_json(other.world)
        assert tasks == others


def test_blocks_rest_apart_within_reach(made):
    for scene, _, _ in made:
        things = scene.world.things
        assert 6 <= len(things) <= 18
        assert 1 <= len({item.color for item in things}) <= 4
        assert apart(things, 0.01)
        for item in things:
            on_table = abs(float(item.position[2]) - TABLE_TOP - EDGE / 2) < 1e-6
            assert on_table or any(supports(other, item) for other in things)
            assert 0.45 <= item.position[0] <= 0.80
            assert abs(item.position[1]) <= 0.65


def test_what_is_to_be_taken_is_seen_and_graspable(made):
    for scene, *tasks in made:
        shown = visible(scene.world.things, scene_camera(scene.world), SIZE)
        assert min(found.share for found in shown.values()) >= 0.3
        for task in tasks:
            assert graspable(scene.world[task.target], scene.world.things)
            assert shown[task.target].share >= 0.6


def test_blocks_with_alike_neighbours_have_them(made):
    for scene, pick, _ in made:
        if scene.kind == "alike":
            target = scene.world[pick.target]
            near = [o for o in scene.world.things if 0 < np.linalg.norm(o.position - target.position) < 0.09]
            assert any(other.color == target.color for other in near)


def test_destinations_are_free_and_supported(made):
    for scene, _, place in made:
        things, (x, y, z) = scene.world.things, place.opening.place
        assert place.target not in place.opening.near
        assert all(gap(np.array((x, y)), 0.0, item) >= 0.02 for item in things if item.position[2] > z - EDGE / 2)
        under = [item for item in things if np.allclose(item.position, (x, y, z - EDGE), atol=1e-6)]
        assert under or z == pytest.approx(TABLE_TOP + EDGE / 2)


def test_an_unknown_kind_is_refused():
    with pytest.raises(CorpusError, match="rows, grid"):
        lay_scene(np.random.default_rng(0), "w", "heap", False)


def test_left_of_the_robot_is_left_from_behind_it_and_right_from_across(made):
    for scene, _, _ in made:
        left, right = scene_camera(scene.world)([(0.6, 0.3, TABLE_TOP), (0.6, -0.3, TABLE_TOP)])
        assert (left[0] < right[0]) == (scene.world.speaker is None)


def test_what_is_nearer_covers_what_is_behind(made):
    scene = made[0][0]
    camera = scene_camera(scene.world)
    item = scene.world.things[0]
    away = (item.position - camera.position) * (1, 1, 0)
    behind = item.moved(item.position + 0.06 * away / np.linalg.norm(away))
    shown = visible([item, type(item)("behind", *list(vars(behind).values())[1:6])], camera, SIZE)
    assert shown[item.id].share > 0.99
    assert shown["behind"].share < 0.95


def test_marks_and_numbers_change_the_picture_where_they_are(made):
    scene, pick, place = made[0]
    plain = np.asarray(draw_seen(scene.world), dtype=int)
    camera, top = scene_camera(scene.world), np.array((0, 0, EDGE / 2))
    for marks in (Marks(pick.target), Marks(place.target, place.opening.place)):
        marked = np.asarray(draw_seen(scene.world, marks), dtype=int)
        rows, columns = np.nonzero(np.abs(marked - plain).sum(axis=2))
        points = [camera(scene.world[marks.target].position + top)]
        points += [] if marks.destination is None else [camera(marks.destination)]
        away = np.min([np.hypot(columns - x, rows - y) for x, y in points], axis=0)
        assert len(rows)
        assert away.max() < 90
    assert (np.asarray(draw_seen(scene.world, numbered=True)) != plain).any()


def test_the_command_writes_worlds_tasks_and_pictures(tmp_path, capsys):
    assert main(["corpus", "scenes", "--count", "2", "--seed", "3", "--output", str(tmp_path)]) == 0
    assert json.loads(capsys.readouterr().out)["scenes"] == 2
    worlds = load_worlds(tmp_path / "scenes.worlds.json")
    tasks = [json.loads(line) for line in (tmp_path / "tasks.jsonl").read_text().splitlines()]
    assert [task["task"] for task in tasks] == ["pick", "place"] * 2
    for task in tasks:
        assert task["gold"]["object"] in worlds[task["world"]].by_id
        assert ("destination" in task["gold"]) == (task["task"] == "place")
        with Image.open(tmp_path / f"{task['id']}.marked.png") as picture:
            assert picture.size == SIZE
        assert (tmp_path / f"{task['world']}.numbered.png").exists()


def test_a_negative_seed_is_refused(tmp_path, capsys):
    assert main(["corpus", "scenes", "--seed", "-1", "--output", str(tmp_path)]) == 2
    assert "seed -1" in capsys.readouterr().err
