import numpy as np
import pytest
from motion_layouts import TABLE, TOP

from motion import Box, InvalidGoal, InvalidScene, Scene, UnreachableTarget, reach_box, reach_map
from motion.grasp.reach_map import STEEPNESS
from motion.grasp.reach_picture import reach_picture


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Across the middle, from where all is well to where nothing is reached."""
    table = Box("table", (0.85, 0.0, TOP - 0.02), size=(0.4, 0.9, 0.04), fixed=True)
    root = tmp_path_factory.mktemp("maps")
    return reach_map(table, spacing=0.15, progress=False, root=root), root


@pytest.fixture(scope="module")
def edge_of_reach(made):
    return made[0]


def test_the_map_is_what_reaching_finds(edge_of_reach):
    seen = set()
    for row, x in enumerate(edge_of_reach.x):
        for column, y in ((1, edge_of_reach.y[1]), (4, edge_of_reach.y[4])):
            scene = Scene((edge_of_reach.table, Box("b", (x, y, TOP + 0.025))))
            try:
                found = {(reach.grasp.arm, abs(reach.grasp.tilt)) for reach in reach_box(scene, "b")}
            except UnreachableTarget:
                found = set()
            mapped = {(way.arm, way.tilt) for way in edge_of_reach.at(x, y)}
            whole = {(way.arm, way.tilt) for way in edge_of_reach.at(x, y) if way.share > 0.99}
            assert whole <= found
            assert bool(mapped) == bool(found) or not whole
            seen.add(bool(found))
            assert np.isnan(edge_of_reach.least_tilt()[row, column]) == (not mapped)
    assert True in seen


def test_the_map_is_symmetric(edge_of_reach):
    mirrored = edge_of_reach.share[::-1, :, :, ::-1]
    assert np.mean(np.abs(edge_of_reach.hands() - mirrored.max(axis=1)) > 0.01) < 0.05


def test_tilting_reaches_farther(edge_of_reach):
    upright, tilted = edge_of_reach.share[:, 0] > 0, (edge_of_reach.share > 0).any(axis=1)
    assert np.all(tilted | ~upright)
    assert tilted.sum() > upright.sum()
    assert edge_of_reach.share.shape == (2, len(STEEPNESS), len(edge_of_reach.x), len(edge_of_reach.y))


def test_places_are_asked_for_on_the_table(edge_of_reach):
    with pytest.raises(InvalidGoal, match=r"not on the table.*0\.650 to 1\.050"):
        edge_of_reach.at(2.0, 0.0)
    with pytest.raises(InvalidGoal, match="finite"):
        edge_of_reach.at(np.nan, 0.0)


def test_a_map_is_read_back_as_it_was_made(made):
    first, root = made
    kept = [path for path in root.rglob("*") if path.is_file()]
    times = [path.stat().st_mtime_ns for path in kept]
    again = reach_map(first.table, spacing=0.15, progress=False, root=root)
    assert np.array_equal(again.share, first.share)
    assert [path.stat().st_mtime_ns for path in kept] == times
    assert not again.share.flags.writeable


def test_the_picture_shows_both_hands_and_what_is_out_of_reach(edge_of_reach):
    colors = {color for _, color in reach_picture(edge_of_reach).getcolors(1 << 24)}
    assert {(232, 232, 230), (38, 70, 120)} <= colors
    assert {(66, 122, 199), (224, 133, 42), (72, 158, 96)} <= colors


def test_maps_that_make_no_sense_are_refused():
    with pytest.raises(InvalidScene, match="fixed and level"):
        reach_map(Box("b", (0.6, 0, 0.7)))
    tilted = Box("table", (0.65, 0, 0.69), (0.99, 0.1411, 0, 0), (0.7, 1.8, 0.04), fixed=True)
    with pytest.raises(InvalidScene, match="level"):
        reach_map(tilted)
    with pytest.raises(InvalidScene, match="spacing"):
        reach_map(TABLE, spacing=0.0)
    with pytest.raises(InvalidGoal, match="60, 60 mm"):
        reach_map(TABLE, (0.06, 0.06, 0.06))
