import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from agreement import agreement, table, worlds_of
from concepts import CONCEPTS, OPEN, PARTS, Concept, Seen

from grounding.corpus.compositions import compose_world, recognise

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def worlds():
    return [Seen(compose_world(np.random.default_rng([4, number]), f"w{number}")) for number in range(3)]


@pytest.mark.parametrize("name", CONCEPTS)
def test_shares_are_shares_and_symmetric(name, worlds):
    report = agreement(CONCEPTS[name], worlds)
    matrix = report["agreement"]
    for first, row in matrix.items():
        for second, share in row.items():
            assert share is None or 0 <= share <= 1
            assert matrix[second][first] == share
    assert set(matrix) <= set(PARTS)
    assert all(0 <= share <= 1 for share in report["open"].values())


@pytest.mark.parametrize("name", CONCEPTS)
def test_a_definition_agrees_with_itself(name, worlds):
    for definition in CONCEPTS[name].definitions.values():
        twice = Concept(CONCEPTS[name].references, {"gamma": definition, "lexicon": definition})
        assert agreement(twice, worlds)["agreement"]["gamma"]["lexicon"] in (1.0, None)


@pytest.mark.parametrize("part", PARTS)
def test_left_is_right_in_the_mirror(part, worlds):
    for seen in worlds:
        other = Seen(recognise("mirrored", mirrored(seen.layout.world)))
        for thing in range(seen.layout.size):
            left, right = (CONCEPTS[f"{side} of"] for side in ("left", "right"))
            assert left.held(part, seen, thing) == right.held(part, other, thing)


def mirrored(world):
    """The world with the robot's left and right swapped."""
    flip, turn = np.array([1.0, -1.0, 1.0]), np.array([1.0, -1.0, 1.0, -1.0])
    return world.with_objects(
        tuple(replace(item, position=item.position * flip, orientation=item.orientation * turn)
              for item in world.objects)
    )  # fmt: skip


def test_what_is_left_open_is_not_compared(worlds):
    def silent(seen, reference):
        raise OPEN[0]("too close to call")

    one = next(iter(CONCEPTS["alone"].definitions.values()))
    report = agreement(Concept(CONCEPTS["alone"].references, {"gamma": one, "lexicon": silent}), worlds)
    assert report["open"] == {"gamma": 0.0, "lexicon": 1.0}
    assert report["agreement"]["gamma"]["lexicon"] is None


def test_a_table_has_a_line_for_every_concept(worlds):
    lines = table({name: agreement(CONCEPTS[name], worlds) for name in ("alone", "row")})
    assert [line.split()[0] for line in lines[1:]] == ["alone", "row"]
    assert len({len(line) for line in lines}) == 1


def test_worlds_depend_on_the_seed_alone():
    first, again, other = ([s.layout.positions.tolist() for s in worlds_of(2, seed)] for seed in (1, 1, 2))
    assert first == again
    assert first[:2] != other[:2]
    assert first[2:] == other[2:]  # the scenes that ship


def test_the_command_prints_json():
    command = [sys.executable, ROOT / "benchmarks" / "agreement.py", "--json", "--worlds", "0", "--concepts", "middle"]
    result = subprocess.run(command, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    report = json.loads(result.stdout)
    assert report["worlds"] == 9
    assert set(report["concepts"]) == {"middle"}
