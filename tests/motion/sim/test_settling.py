import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motion import Box, InvalidScene, Scene, Simulator
from motion.polygons import overlap
from motion.sim.settling import PENETRATION, push_about, settle

TABLE = Box("table", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04), fixed=True)
TOP = 0.711


def box(name, x, y, z=TOP + 0.025):
    return Box(name, (x, y, z))


def tower(*offsets):
    return Scene((TABLE, *(box(f"b{k}", 0.6, offset, TOP + 0.025 + 0.05 * k) for k, offset in enumerate(offsets))))


def grid(count):
    places = [(0.42 + 0.11 * (k // 6), -0.5 + 0.2 * (k % 6)) for k in range(count)]
    return Scene((TABLE, *(box(f"b{k}", *place) for k, place in enumerate(places))))


def moved(before, after):
    return max(float(np.linalg.norm(b.position - before.box(b.name).position)) for b in after.boxes)


def test_what_is_stacked_stays_stacked():
    scene = tower(0.0, 0.008, -0.004, 0.002)
    settled = settle(scene)
    assert settled.stable
    assert not settled.fallen
    assert moved(scene, settled.scene) < 1e-3
    assert settled.depth < PENETRATION / 2


def test_what_overhangs_too_far_topples():
    scene = tower(0.0, 0.035)
    assert moved(scene, settle(scene).scene) > 0.02


def test_what_falls_off_the_table_is_named_and_gone():
    settled = settle(Scene((TABLE, box("stays", 0.6, 0.0), box("falls", 1.02, 0.3))))
    assert settled.fallen == ("falls",)
    assert settled.scene.names == ("table", "stays")


def test_what_leans_is_named():
    turn = np.radians(30)
    leaning = Box("leans", (0.66, 0.0, TOP + 0.04), (np.cos(turn / 2), 0.0, -np.sin(turn / 2), 0.0))
    settled = settle(Scene((TABLE, Box("wall", (0.6, 0.0, TOP + 0.05), size=(0.05, 0.05, 0.1)), leaning)), 0.002)
    assert settled.leaning == ("leans",)
    assert not settled.stable


@settings(max_examples=4)
@given(seed=st.integers(0, 1000), count=st.integers(3, 18))
def test_what_was_pushed_about_lies_still_on_the_table(seed, count):
    before = grid(count)
    settled = push_about(before, np.random.default_rng(seed))
    if not settled.stable:
        return
    loose = [b for b in settled.scene.boxes if not b.fixed]
    assert {b.name for b in loose} | set(settled.fallen) == {f"b{k}" for k in range(count)}
    assert settled.seconds >= 2.5
    for b in loose:
        assert b.lean < 0.01
        assert settled.scene.below(b.name)
    for one in loose:
        for other in loose:
            if one.name < other.name and abs(one.position[2] - other.position[2]) < 0.02:
                assert overlap(one.footprint, other.footprint) < PENETRATION


def test_pushes_move_boxes_and_come_from_the_seed():
    scene = grid(12)
    one, same, other = (push_about(scene, np.random.default_rng(seed)).scene for seed in (5, 5, 6))
    assert moved(scene, one) > 0.05
    assert all(np.array_equal(b.position, same.box(b.name).position) for b in one.boxes)
    assert one.names != other.names or moved(one, other) > 0.01


def test_what_rests_here_rests_beside_the_robot():
    settled = push_about(grid(9), np.random.default_rng(3))
    assert settled.stable
    with Simulator(settled.scene) as simulator:
        simulator.settle(1.0)
        assert moved(settled.scene, simulator.scene()) < 1e-3


@pytest.mark.parametrize("boxes", [(TABLE,), (box("b1", 0.6, 0.0),)])
def test_without_a_table_or_a_block_there_is_nothing_to_settle(boxes):
    with pytest.raises(InvalidScene, match="table"):
        settle(Scene(boxes))
