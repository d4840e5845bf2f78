import itertools

import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import Box, GraspUnavailable, InvalidGoal, Scene, UnknownBody
from motion.grasp.candidates import TILTS, grasp_candidates
from motion.poses import about, quaternion
from motion.robot.recipe import recipe

ORIENTATIONS = [
    np.array([np.array(signs[i] * np.eye(3)[axis]) for i, axis in enumerate(order)])
    for order in itertools.permutations(range(3))
    for signs in itertools.product((1, -1), repeat=3)
]
ROTATIONS = [rotation for rotation in ORIENTATIONS if np.linalg.det(rotation) > 0]


def test_a_cube_has_four_yaws_seven_tilts_and_two_hands(one_block):
    grasps = grasp_candidates(one_block, "b")
    assert len(grasps) == 4 * len(TILTS) * 2
    assert max(abs(grasp.tilt) for grasp in grasps) <= np.radians(30)
    assert [grasp.cost for grasp in grasps] == sorted(grasp.cost for grasp in grasps)
    assert grasps[0].arm == "right"


@pytest.mark.parametrize("rotation", ROTATIONS)
def test_any_face_may_be_up(rotation):
    assert len(ROTATIONS) == 24
    box = Box("b", (0.6, -0.3, TOP + 0.025), quaternion(about((0, 0, 1), 0.3) @ rotation))
    upright = grasp_candidates(Scene((TABLE, block("b", 0.6, -0.3, yaw=0.3))), "b")
    turned = grasp_candidates(Scene((TABLE, box)), "b")
    assert len(turned) == len(upright)
    for grasp in turned:
        nearest = min(
            grasp.tool.distance(other.tool)[0] + grasp.tool.distance(other.tool)[1]
            for other in upright
            if other.arm == grasp.arm
        )
        assert nearest < 1e-6


def test_paddles_close_on_faces_and_stay_above_the_table():
    for edge in (0.02, 0.04, 0.055):
        scene = Scene((TABLE, block("b", 0.6, -0.3, edge=edge, yaw=0.4)))
        for grasp in grasp_candidates(scene, "b"):
            closing = grasp.tool.rotation[:, 1]
            assert np.max(np.abs(closing @ scene.box("b").axes)) == pytest.approx(1)
            approach, across = grasp.tool.rotation[:, 2], grasp.tool.rotation[:, 0]
            assert approach[2] < -np.cos(np.radians(31))
            lowest = min((grasp.tool.position + 0.0035 * approach + side * 0.021 * across)[2] for side in (-1, 1))
            assert lowest > TOP + 0.003
            assert edge < grasp.opening <= recipe().gripper.opened


def test_the_mirrored_block_is_taken_by_the_other_hand():
    left = grasp_candidates(Scene((block("b", 0.6, 0.3),)), "b")[0]
    right = grasp_candidates(Scene((block("b", 0.6, -0.3),)), "b")[0]
    assert (left.arm, right.arm) == ("left", "right")
    assert left.tool.position == pytest.approx(right.tool.position * [1, -1, 1])


def test_long_boxes_are_taken_across():
    scene = Scene((TABLE, Box("b", (0.6, -0.3, TOP + 0.02), size=(0.12, 0.04, 0.04))))
    for grasp in grasp_candidates(scene, "b"):
        assert abs(grasp.tool.rotation[1, 1]) == pytest.approx(1)
        assert grasp.width == pytest.approx(0.04)


def test_what_cannot_be_grasped_is_refused(one_block):
    wide = Scene((TABLE, block("b", 0.6, -0.3, edge=0.06)))
    with pytest.raises(InvalidGoal, match=r"60, 60 mm.*18 to 55.7 mm"):
        grasp_candidates(wide, "b")
    with pytest.raises(InvalidGoal, match="fixed"):
        grasp_candidates(one_block, "table")
    with pytest.raises(UnknownBody):
        grasp_candidates(one_block, "c")


def test_neighbours_leave_the_directions_that_are_free():
    # Between two blocks that stand close, only the faces that look elsewhere are taken.
    row = Scene((TABLE, *(block(f"b{i}", 0.6, -0.3 + 0.052 * i) for i in range(3))))
    grasps = grasp_candidates(row, "b1")
    assert grasps
    assert all(abs(grasp.tool.rotation[0, 1]) == pytest.approx(1) for grasp in grasps)
    assert len(grasps) == len(grasp_candidates(Scene((TABLE, block("b1", 0.6, -0.248))), "b1")) / 2
    assert [grasp.cost for grasp in grasps] == sorted(grasp.cost for grasp in grasps)


def test_where_there_is_little_room_the_hand_opens_less():
    def openings(room):
        pair = Scene((TABLE, block("b", 0.6, -0.3, edge=0.04), block("c", 0.6, -0.34 - room, edge=0.04)))
        across = [grasp for grasp in grasp_candidates(pair, "b") if abs(grasp.tool.rotation[1, 1]) > 0.9]
        return {round(grasp.opening, 4) for grasp in across if grasp.tilt == 0}

    assert openings(0.03) == {0.054}
    assert openings(0.0195) == {0.046}
    assert openings(0.01) == set()


def test_a_finger_that_a_corner_blocks_goes_beside_it():
    corner = Box("corner", (0.6, -0.243, TOP + 0.025), (np.cos(np.pi / 8), 0, 0, np.sin(np.pi / 8)), (0.03, 0.03, 0.05))
    scene = Scene((TABLE, block("b", 0.6, -0.3), corner))
    across = [grasp for grasp in grasp_candidates(scene, "b") if abs(grasp.tool.rotation[1, 1]) > 0.9]
    aside = [grasp.tool.position[0] - 0.6 for grasp in across if grasp.tilt == 0]
    assert set(np.round(aside, 3)) == {0.016, -0.016}


def test_a_block_walled_in_cannot_be_grasped():
    grid = [block(f"b{i}{j}", 0.55 + 0.0505 * i, 0.3 + 0.0505 * j) for i in range(3) for j in range(3)]
    with pytest.raises(GraspUnavailable, match=r"'b11'.*finger.*must be moved first") as caught:
        grasp_candidates(Scene((TABLE, *grid)), "b11")
    assert caught.value.bodies[1].startswith("b")


def test_there_are_two_hands(one_block):
    with pytest.raises(InvalidGoal, match="'middle'"):
        grasp_candidates(one_block, "b", ("middle",))
