import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion import load_robot
from motion.ik.seeds import NEIGHBOURS, SeedTable
from motion.robot.recipe import recipe


@pytest.fixture(scope="module", params=["left", "right"])
def table(request):
    robot = load_robot()
    return request.param, SeedTable(
        robot.kinematics(request.param), robot.arm(request.param).wrist, recipe().home[request.param]
    )


def test_starts_are_within_the_ranges_and_mostly_near_the_target(table):
    arm, seeds = table
    robot = load_robot()
    data, kinematics, rng = robot.arm(arm), robot.kinematics(arm), np.random.default_rng(0)
    distances = []
    for _ in range(50):
        target = kinematics.pose(rng.uniform(data.lower, data.upper))
        starts = list(seeds.starts(target.position, target.rotation, recipe().home[arm]))
        assert len(starts) == NEIGHBOURS
        assert np.all(np.array(starts) >= data.lower)
        assert np.all(np.array(starts) <= data.upper)
        assert len({start.tobytes() for start in starts}) == NEIGHBOURS
        distances.append(kinematics.pose(starts[0]).distance(target))
    assert np.median(distances, axis=0) == pytest.approx([0, 0], abs=0.3)


@given(st.floats(-1.5, 1.5), st.floats(-3, 3), st.integers(0, 1000))
def test_the_first_and_the_last_joint_are_read_off_the_target(first, last, seed):
    # Whatever the first and last joints of a configuration of the table, that configuration is found again.
    robot = load_robot()
    kinematics = robot.kinematics("left")
    table = SeedTable(kinematics, robot.arm("left").wrist, recipe().home["left"], count=300)
    joints = table._joints[seed % 300].copy()
    joints[0], joints[6] = first, last
    target = kinematics.pose(joints)
    starts = np.array(list(table.starts(target.position, target.rotation, joints, count=8)))
    assert np.min(np.max(np.abs(starts - joints), axis=1)) < 1e-6
