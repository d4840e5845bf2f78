"""From words to joints: what an instruction means is reached by inverse kinematics, clear of all that stands around."""

import json
from pathlib import Path

import pytest
from by_hand import scene

from grounding import Grounder
from integration.worlds_and_scenes import scene_of
from motion import Avoidance, load_robot, reach_box, solve_ik
from motion.collision.clearance import Rules

LINES = [json.loads(line) for line in (Path(__file__).parent / "instructions.jsonl").read_text().splitlines()]
PICKS = [line for line in LINES if line["action"] == "pick"]


@pytest.fixture(scope="module")
def grounder():
    return Grounder.load()


@pytest.mark.parametrize("line", PICKS[::5], ids=lambda line: line["instruction"])
def test_what_is_meant_is_reached(grounder, line):
    world = scene(line["scene"])
    action = grounder.ground(line["instruction"], world).actions[0]
    stage = scene_of(world)
    for name in action.objects:
        reach = reach_box(stage, name)[0]
        grasp = reach.grasp
        rules = Rules(hand_clearance=0.0015, touching=frozenset({name}), close=stage.below(name))
        avoid = Avoidance(stage, grasp.arm, rules=rules, width=grasp.opening)
        joints = solve_ik(grasp.arm, grasp.tool, seed=reach.joints, avoid=avoid).joints
        tool = load_robot().tool_pose(grasp.arm, joints)
        assert tool.distance(grasp.tool)[0] < 1e-4
        assert abs(tool.rotation[:, 1] @ stage.box(name).axes).max() == pytest.approx(1, abs=1e-3)
        assert avoid.nearest(joints) is None
