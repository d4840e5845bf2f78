"""Composed worlds: at rest, apart from each other, what they claim, and the same from the same seed."""

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grounding.corpus.composer import COLORS, EDGES, LIMITS, Area, compose
from grounding.corpus.shapes import misfit
from grounding.corpus.tabletop import REACH_X, REACH_Y, TABLE, TABLE_TOP
from grounding.errors import CorpusError
from grounding.world import world_from_json, world_to_json

seeds = st.integers(0, 2**32 - 1)
counts = st.integers(*LIMITS)
areas = st.sampled_from([Area(), Area(REACH_X, REACH_Y), Area(gap=0.035)])


def composed(seed, count=None, area=None):
    return compose(np.random.default_rng(seed), count, area)


def outline(block):
    """The four corners of a block's base, (4, 2) [m]."""
    w, _, _, z = block.orientation
    yaw = 2 * np.arctan2(z, w)
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * block.size[0] / 2
    return block.position[:2] + corners @ turn.T, turn.T


def separation(first, second):
    """A lower bound of the distance between two bases, by their separating axes [m]."""
    (a, axes_a), (b, axes_b) = outline(first), outline(second)
    along = first.position[:2] - second.position[:2]
    apart = np.linalg.norm(along)
    best = -np.inf
    for axis in (*axes_a, *axes_b, *([along / apart] if apart > 1e-9 else [])):
        p, q = a @ axis, b @ axis
        best = max(best, p.min() - q.max(), q.min() - p.max())
    return best


@given(seeds, counts, areas)
def test_as_many_blocks_as_asked_for_within_the_area(seed, count, area):
    world = composed(seed, count, area).world
    assert len(world.things) == count
    assert (world.positions[:, 0] >= area.x[0] - 1e-3).all()
    assert (world.positions[:, 0] <= area.x[1] + 1e-3).all()
    assert (world.positions[:, 1] >= area.y[0] - 1e-3).all()
    assert (world.positions[:, 1] <= area.y[1] + 1e-3).all()


@given(seeds)
def test_everything_rests(seed):
    world = composed(seed).world
    for block in world.things:
        below = [o for o in world.things if o is not block and separation(o, block) < -0.25 * block.size[0]]
        tops = [TABLE_TOP] + [o.position[2] + o.size[2] / 2 for o in below]
        assert min(abs(block.position[2] - block.size[2] / 2 - top) for top in tops) < 1e-6


@given(seeds, counts, areas)
@settings(max_examples=40)
def test_blocks_keep_the_gap(seed, count, area):
    blocks = composed(seed, count, area).world.things
    for i, first in enumerate(blocks):
        for second in blocks[:i]:
            overlap = (first.size[2] + second.size[2]) / 2 - abs(first.position[2] - second.position[2])
            if overlap > 1e-6:  # beside each other, not one on the other
                assert separation(first, second) >= area.gap - 1e-3


@given(seeds)
def test_containers_are_what_they_claim(seed):
    composition = composed(seed)
    for container in composition.containers:
        assert misfit(container.kind, [composition.world[name] for name in container.objects]) is None


@given(seeds)
def test_blocks_are_cubes_of_the_known_edges_and_colours(seed):
    for block in composed(seed).world.things:
        assert len(set(block.size.tolist())) == 1
        assert block.size[0] in EDGES
        assert block.color in COLORS


@given(seeds)
def test_the_same_seed_lays_the_same_world(seed):
    first, second = composed(seed), composed(seed)
    assert world_to_json(first.world) == world_to_json(second.world)
    assert first.containers == second.containers


@given(seeds)
def test_worlds_read_back_exactly(seed):
    world = composed(seed).world
    assert world_to_json(world_from_json(world_to_json(world))) == world_to_json(world)
    assert world["table"] is TABLE


def test_everything_promised_occurs():
    rng = np.random.default_rng(1)
    compositions = [compose(rng) for _ in range(300)]
    kinds = Counter(container.kind for composition in compositions for container in composition.containers)
    assert set(kinds) == {"row", "column", "circle", "group", "tower"}
    assert {len({o.color for o in c.world.things}) for c in compositions} == set(range(1, len(COLORS) + 1))
    counts = {len(c.world.things) for c in compositions}
    assert min(counts) == LIMITS[0]
    assert max(counts) >= LIMITS[1] - 1
    edges = Counter(float(o.size[0]) for c in compositions for o in c.world.things)
    assert set(edges) == set(EDGES)
    assert edges.most_common(1)[0][0] == 0.05


@pytest.mark.parametrize("count", [0, 2, 31])
def test_other_counts_are_refused(count):
    with pytest.raises(CorpusError, match=f"{count} blocks; composed are 3 to 30"):
        composed(0, count)


def test_an_area_that_is_too_small_is_refused():
    with pytest.raises(CorpusError, match="no room for 30 blocks"):
        composed(0, 30, Area((0.5, 0.6), (0.0, 0.1)))
