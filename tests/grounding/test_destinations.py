"""Destinations: free, on something, on the side that was said; or there is none."""

import functools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import models
from grounding.corpus.composer import compose
from grounding.destinations import CLEARANCE, FAR, find_destination
from grounding.geometry.regions import in_region
from grounding.symbols import SPATIAL_REFERENCES, Region
from grounding.world import FURNITURE, World, load_world, make_object

Z = 0.736
SWAPPED = {"left": "right", "right": "left"}


@functools.cache
def world_of(seed):
    return compose(np.random.default_rng(seed)).world


def four():
    return load_world(models.SCENES / "four.json")


def others(world, moved):
    return [o for o in world.objects if o.type not in FURNITURE and o.id not in moved]


def supported(placed, world, moved):
    """Whether something is right below the centre of a placed object."""
    bottom = placed.position[2] - placed.half_extents[2]
    below = [*others(world, moved), world["table"]]
    return any(
        abs(o.position[2] + o.half_extents[2] - bottom) < 1e-4
        and (np.abs(o.position - placed.position)[:2] <= o.half_extents[:2]).all()
        for o in below
    )


def overlap(a, b):
    return (np.abs(a.position - b.position) < a.half_extents + b.half_extents - 1e-4).all()


@st.composite
def tasks(draw):
    world = world_of(draw(st.integers(0, 199)))
    names = draw(st.permutations([o.id for o in world.things]))
    relation = draw(st.sampled_from(SPATIAL_REFERENCES))
    count = 2 if relation == "between" else draw(st.integers(1, min(3, len(names) - 1)))
    reference = draw(st.sampled_from([tuple(names[1 : 1 + count]), ("table",)]))
    kind = "object" if relation == "between" or reference == ("table",) else draw(st.sampled_from(("object", "group")))
    return world, names[0], Region(relation, kind, reference)


@given(tasks())
@settings(max_examples=80)
def test_destinations_are_free_supported_and_where_they_were_asked_for(task):
    world, name, region = task
    found = find_destination(region, (name,), world)
    if found is None:
        return
    assert (found.relation, found.reference) == (region.relation, region.objects)
    assert all(isinstance(value, float) for value in found.position)
    placed = world[name].moved(found.position)
    assert supported(placed, world, (name,))
    assert not any(overlap(placed, other) for other in others(world, (name,)))
    if region.relation not in ("far", "center", "bottom") and region.objects != ("table",):
        assert in_region(region.relation, [world[i] for i in region.objects], [placed])[0]


@given(tasks())
@settings(max_examples=30)
def test_the_same_place_every_time(task):
    world, name, region = task
    again = World(tuple(reversed(world.objects)))
    assert find_destination(region, (name,), world) == find_destination(region, [name], again)


@given(tasks())
@settings(max_examples=30)
def test_what_stands_on_the_table_leaves_room_for_fingers(task):
    world, name, region = task
    found = find_destination(region, (name,), world)
    if found is None or (region.relation == "top" and region.objects != ("table",)):
        return
    placed = world[name].moved(found.position)
    for other in others(world, (name,)):
        apart = np.abs(placed.position - other.position)[:2] - placed.half_extents[:2] - other.half_extents[:2]
        assert apart.max() > CLEARANCE - 1e-4


@pytest.mark.parametrize("relation", ["left", "right", "front", "back"])
def test_beside_a_lone_block_it_is_in_line(relation):
    world = World(
        (make_object("a", position=(0.6, 0.4, Z)), make_object("b", position=(0.65, 0.0, Z)), four()["table"])
    )
    found = find_destination(Region(relation, "object", ("b",)), ("a",), world)
    step = np.array(found.position) - world["b"].position
    axis, sign = {"left": (1, 1), "right": (1, -1), "back": (0, 1), "front": (0, -1)}[relation]
    assert sign * step[axis] == pytest.approx(0.05 + CLEARANCE, abs=1e-3)
    assert step[1 - axis] == pytest.approx(0.0, abs=1e-3)


def test_on_top_is_centred_and_high_enough():
    found = find_destination(Region("top", "object", ("b2",)), ("b1",), four())
    below = four()["b2"]
    assert found.position[:2] == pytest.approx(below.position[:2])
    assert found.position[2] == pytest.approx(below.position[2] + 0.05)


def test_nothing_goes_on_what_carries_something_or_under_anything():
    low, high = (make_object(name, position=(0.6, 0.0, z)) for name, z in (("low", Z), ("high", Z + 0.05)))
    world = World((low, high, make_object("a", position=(0.6, 0.4, Z)), four()["table"]))
    assert find_destination(Region("top", "object", ("low",)), ("a",), world) is None
    assert find_destination(Region("top", "object", ("low",)), ("high",), world) is not None
    assert find_destination(Region("top", "tower", ("low", "high")), ("a",), world).position[2] > Z + 0.09
    assert find_destination(Region("bottom", "object", ("low",)), ("a",), world) is None


def test_far_is_far():
    world = four()
    for name in ("b2", "b3", "b4"):
        found = find_destination(Region("far", "object", (name,)), ("b1",), world)
        assert np.linalg.norm(np.array(found.position) - world[name].position) > FAR / 2


@pytest.mark.parametrize(
    ("relation", "axis", "sign"), [("left", 1, 1), ("right", 1, -1), ("back", 0, 1), ("front", 0, -1)]
)
def test_sides_of_the_table(relation, axis, sign):
    world = four()
    found = find_destination(Region(relation, "object", ("table",)), ("b1",), world)
    assert sign * (np.array(found.position) - world["table"].position)[axis] > 0


@pytest.mark.parametrize("relation", SPATIAL_REFERENCES)
def test_of_the_robot_there_is_a_place_on_the_table(relation):
    found = find_destination(Region(relation, "robot", ()), ("b1",), four())
    if found is not None:
        assert supported(four()["b1"].moved(found.position), four(), ("b1",))


def test_beside_where_it_stands_itself():
    world = four()
    found = find_destination(Region("left", "object", ("b1",)), ("b1",), world)
    assert found.position[1] > world["b1"].position[1]


def test_without_a_table_there_is_no_place_beside():
    world = World((make_object("a"), make_object("b", position=(0.5, 0, 0))))
    assert find_destination(Region("left", "object", ("b",)), ("a",), world) is None
    assert find_destination(Region("top", "object", ("b",)), ("a",), world) is not None


def test_a_full_table_has_no_place():
    table = make_object("table", "table", position=(0.6, 0, 0.69), size=(0.2, 0.2, 0.04))
    world = World((make_object("a", position=(0.6, 0, 0.735)), make_object("b", position=(0, 3, 0.735)), table))
    assert find_destination(Region("near", "object", ("a",)), ("b",), world) is None
