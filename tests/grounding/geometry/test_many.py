import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from grounding.geometry.many import ALONE, by_size, masks_of, neighbouring, parts, regularities, separations
from grounding.geometry.masks import indices_of

seeds = st.integers(0, 2**32 - 1)


@given(st.integers(0, 5000), st.integers(0, 100_000))
def test_parts_cover_every_row_once(count: int, cells: int) -> None:
    rows = np.arange(count)
    covered = [rows[part] for part in parts(count, cells)]
    assert np.concatenate([*covered, rows[:0]]).tolist() == rows.tolist()


@given(seeds, st.integers(1, 130), st.integers(1, 6))
def test_masks_have_the_members_as_bits(seed: int, objects: int, sets: int) -> None:
    inside = np.random.default_rng(seed).random((sets, objects)) < 0.3
    for mask, row in zip(masks_of(inside), inside, strict=True):
        assert list(indices_of(mask)) == np.flatnonzero(row).tolist()


def test_no_sets_have_no_masks() -> None:
    assert masks_of(np.zeros((0, 5), dtype=bool)) == []


@given(seeds, st.integers(2, 12), st.data())
def test_sets_side_by_side_are_as_far_from_others_as_each_alone(seed: int, objects: int, data: st.DataObject) -> None:
    rng = np.random.default_rng(seed)
    size = data.draw(st.integers(1, objects))
    points = rng.random((objects, 2))
    distances = np.linalg.norm(points[:, None] - points[None], axis=2)
    members = np.array([rng.permutation(objects)[:size] for _ in range(5)])
    gaps = rng.uniform(0.1, 1.0, 5)
    for row, gap, found in zip(members, gaps, separations(distances, members, gaps), strict=True):
        others = np.setdiff1d(np.arange(objects), row)
        assert found == (distances[np.ix_(row, others)].min() / gap if len(others) else ALONE)


def test_even_gaps_are_regular_and_single_ones_too() -> None:
    assert regularities(np.array([[0.25, 0.25, 0.25], [0.0, 0.0, 0.0]])).tolist() == [1.0, 1.0]
    assert regularities(np.array([[0.3], [0.0]])).tolist() == [1.0, 1.0]
    uneven, worst = regularities(np.array([[0.1, 0.2, 0.1], [0.0, 0.0, 1.0]]))
    assert 0.0 == worst < uneven < 1.0


def test_neighbours_come_nearest_first() -> None:
    places = np.array([0.0, 1.0, 3.0, 3.5])
    apart = np.abs(places[:, None] - places[None])
    assert neighbouring(apart, 2).tolist() == [[1, 2], [0, 2], [3, 1], [2, 1]]
    assert neighbouring(apart, 8).shape == (4, 3)


def test_sets_are_found_by_their_size() -> None:
    sets = [np.array(one) for one in ([1, 2], [3], [4, 5])]
    assert by_size(sets) == {2: [0, 2], 1: [1]}
