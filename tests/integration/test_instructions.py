"""The shipped instructions are what they claim to be, and motion can do every one of them."""

import json
from pathlib import Path

import pytest
from by_hand import SCENES, grounded, scene

from grounding import Destination
from integration.execute.executor import Executor

HERE = Path(__file__).parent
LINES = [json.loads(line) for line in (HERE / "instructions.jsonl").read_text().splitlines()]
SENTENCES = {line["instruction"] for line in LINES}


def test_thirty_instructions_over_five_scenes_with_places_and_clears():
    assert len(SENTENCES) == len(LINES) == 30
    assert len({line["scene"] for line in LINES}) == 5
    assert sum(line["action"] == "place" for line in LINES) >= 5
    assert sum(line["action"] == "clear" for line in LINES) == 2


def test_none_of_them_is_in_the_treebank():
    for path in (SCENES.parent / "treebank").glob("*.trees"):
        for line in path.read_text().splitlines():
            words = [part.strip(") ") for part in line.replace("(", " ").split() if part.endswith(")")]
            assert " ".join(words) not in SENTENCES


def test_objects_and_references_are_in_their_scenes():
    for line in LINES:
        world = scene(line["scene"])
        for name in [*line["objects"], *line.get("reference", [])]:
            assert world[name].type == "block"


PLACES = [line for line in LINES if line["action"] == "place"]


@pytest.mark.parametrize("line", PLACES, ids=lambda line: line["instruction"])
def test_every_place_can_be_done(line):
    world = scene(line["scene"])
    below = max((world[name] for name in line["reference"]), key=lambda item: item.position[2])
    block = world[line["objects"][0]]
    top = below.position[2] + below.half_extents[2] + block.half_extents[2]
    to = Destination((*below.position[:2], top), line["relation"], tuple(line["reference"]))
    assert Executor().execute(grounded("place", *line["objects"], to=to), world).outcome == "done"
