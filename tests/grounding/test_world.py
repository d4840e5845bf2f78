"""Worlds and world files: what is written is what is read, and everything else is refused by name."""

import contextlib
import copy
import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.errors import WorldError
from grounding.world import (
    World,
    load_world,
    load_worlds,
    make_object,
    save_world,
    world_from_json,
    world_to_json,
)

BLOCK = {"id": "b1", "type": "block", "color": "red", "position": [0.62, -0.21, 0.736],
         "orientation": [1, 0, 0, 0], "size": [0.05, 0.05, 0.05]}  # fmt: skip
WORLD = {"objects": [BLOCK, {**BLOCK, "id": "b2"}], "speaker": {"position": [1.5, 0, 0], "yaw": 3.14159}}

names = st.text(st.characters(categories=("L", "N"), include_characters="_-."), min_size=1, max_size=8)
metres = st.floats(-3, 3)
edges = st.floats(1e-3, 2)
turns = (
    st.tuples(*[st.floats(-1, 1)] * 4)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: tuple(np.array(q) / np.linalg.norm(q)))
)
objects = st.builds(make_object, names, names, names, st.tuples(metres, metres, metres), turns,
                    st.tuples(edges, edges, edges))  # fmt: skip
worlds = st.lists(objects, max_size=6, unique_by=lambda item: item.id).map(lambda items: World(tuple(items)))


def with_key(key, value):
    data = copy.deepcopy(WORLD)
    data["objects"][1][key] = value
    return data


@given(worlds)
def test_a_world_reads_back_exactly(world):
    assert world_to_json(world_from_json(json.loads(json.dumps(world_to_json(world))))) == world_to_json(world)


def test_a_file_reads_back_with_its_speaker(tmp_path):
    world = world_from_json(WORLD)
    save_world(world, tmp_path / "world.json")
    again = load_world(tmp_path / "world.json")
    assert world_to_json(again) == world_to_json(world)
    assert again.speaker.yaw == pytest.approx(3.14159)


@given(worlds)
def test_arrays_cannot_be_changed(world):
    for item in world.objects:
        for array in (item.position, item.orientation, item.size):
            with pytest.raises(ValueError, match="read-only"):
                array[0] = 0.0


@given(worlds, st.randoms())
def test_order_of_the_file_does_not_matter(world, random):
    shuffled = list(world.objects)
    random.shuffle(shuffled)
    other = world.with_objects(shuffled)
    assert [item.id for item in other.things] == [item.id for item in world.things]
    np.testing.assert_array_equal(other.positions, world.positions)


@given(objects)
def test_the_enclosing_box_holds_the_corners(item):
    half = item.size / 2
    diagonal = float(np.linalg.norm(half))
    assert (item.half_extents <= diagonal + 1e-9).all()
    assert (item.half_extents >= half.min() - 1e-9).all()
    half_turn = item.moved(item.position, np.array([0.0, 1.0, 0.0, 0.0]))
    np.testing.assert_allclose(half_turn.half_extents, half)


@pytest.mark.parametrize("key", ["id", "type", "color", "position", "orientation", "size"])
def test_a_missing_key_is_named(key):
    data = copy.deepcopy(WORLD)
    del data["objects"][1][key]
    who = "object number 1" if key == "id" else "'b2'"
    with pytest.raises(WorldError, match=f"here: object .*{who.removeprefix('object ')}.*{key!r} is missing"):
        world_from_json(data, "here")


@pytest.mark.parametrize(
    ("key", "value", "says"),
    [
        ("weight", 3, "unknown key 'weight'"),
        ("position", [0, 0, math.nan], "'position' holds nan"),
        ("position", [0, 0, math.inf], "'position' holds inf"),
        ("position", [0, 0], "list of 3 numbers"),
        ("position", [0, 0, 0, 0], "list of 3 numbers"),
        ("position", "0 0 0", "list of 3 numbers"),
        ("position", [0, 0, "1"], "no number"),
        ("position", [0, 0, True], "no number"),
        ("position", [0, 0, None], "no number"),
        ("position", [10**400, 0, 0], "finite"),
        ("orientation", [1e300, 1e300, 0, 0], "finite"),
        ("position", None, "list of 3 numbers"),
        ("size", [0.05, 0.05, 0], "longer than 0"),
        ("size", [0.05, -0.05, 0.05], "longer than 0"),
        ("size", [0.05, 0.05, math.nan], "'size' holds nan"),
        ("orientation", [1, 0, 0, 1], "length 1.414"),
        ("orientation", [0, 0, 0, 0], "length 0"),
        ("orientation", [1, 0, 0], "list of 4 numbers"),
        ("color", 3, "'color' is a text"),
        ("color", "", "'color' is a text"),
        ("type", None, "'type' is a text"),
    ],
)
def test_a_bad_value_is_refused_with_object_and_key(key, value, says):
    with pytest.raises(WorldError, match=f"here: object 'b2'.*{says}"):
        world_from_json(with_key(key, value), "here")


@pytest.mark.parametrize("name", ["", " ", 7, None, "two words", "a(b", "a;b", "a,b", "{a}"])
def test_a_bad_id_is_refused(name):
    with pytest.raises(WorldError, match="'id'"):
        world_from_json(with_key("id", name))


def test_a_duplicate_id_is_refused():
    with pytest.raises(WorldError, match="'b1': duplicate id"):
        world_from_json(with_key("id", "b1"))


@pytest.mark.parametrize("data", [None, 3, [], "world", {}, {"objects": {}}, {"objects": [3]}, {"objects": None},
                                  {**WORLD, "robot": 1}, {**WORLD, "speaker": 3}, {**WORLD, "speaker": {"yaw": 0}},
                                  {**WORLD, "speaker": {"position": [0, 0, 0], "yaw": math.nan}},
                                  {**WORLD, "speaker": {"position": [0, 0, 0], "yaw": "north"}},
                                  {**WORLD, "speaker": {"position": [0, 0, 0], "yaw": 0, "name": "Kim"}}])  # fmt: skip
def test_other_shapes_are_refused(data):
    with pytest.raises(WorldError, match=r"^here: "):
        world_from_json(data, "here")


json_values = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=4),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=4),
)


@given(json_values, st.sampled_from(["objects", "entry", *BLOCK]))
def test_any_value_of_json_is_read_or_refused(value, where):
    data = {"objects": value} if where == "objects" else {"objects": [value]} if where == "entry" else None
    with contextlib.suppress(WorldError):
        world_from_json(with_key(where, value) if data is None else data)


@given(st.integers(0, len(json.dumps(WORLD)) - 1))
def test_a_truncated_file_is_refused(tmp_path_factory, length):
    path = tmp_path_factory.getbasetemp() / "cut.json"
    path.write_text(json.dumps(WORLD)[:length])
    with pytest.raises(WorldError, match=r"cut\.json.*truncated"):
        load_world(path)


def test_unreadable_files_are_named(tmp_path):
    with pytest.raises(WorldError, match=r"none\.json: no such world file"):
        load_world(tmp_path / "none.json")
    with pytest.raises(WorldError, match="cannot be read"):
        load_world(tmp_path)
    (tmp_path / "binary.json").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(WorldError, match=r"binary\.json: cannot be read"):
        load_world(tmp_path / "binary.json")
    (tmp_path / "deep.json").write_text("[" * 200_000)
    with pytest.raises(WorldError, match=r"deep\.json"):
        load_world(tmp_path / "deep.json")
    (tmp_path / "digits.json").write_text("9" * 10_000)
    with pytest.raises(WorldError, match=r"digits\.json"):
        load_world(tmp_path / "digits.json")
    (tmp_path / "nan.json").write_text(json.dumps(with_key("position", [0, math.nan, 0])))
    with pytest.raises(WorldError, match=r"nan\.json: object 'b2': 'position' holds nan"):
        load_world(tmp_path / "nan.json")


def test_named_worlds_name_themselves_in_refusals(tmp_path):
    path = tmp_path / "worlds.json"
    path.write_text(json.dumps({"good": WORLD, "bad": with_key("size", [1, 1, 0])}))
    with pytest.raises(WorldError, match=r"world 'bad': object 'b2': 'size'"):
        load_worlds(path)
    path.write_text(json.dumps({"good": WORLD}))
    assert list(load_worlds(path)) == ["good"]
    path.write_text(json.dumps(WORLD))
    assert list(load_worlds(path)) == [""]
    path.write_text("[]")
    with pytest.raises(WorldError, match="maps names to worlds"):
        load_worlds(path)


def test_an_unknown_object_is_named_with_those_there_are():
    with pytest.raises(WorldError, match=r"no object 'b9'.*b1, b2"):
        world_from_json(WORLD)["b9"]
