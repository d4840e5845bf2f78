import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from control_weights import training_texts
from deciders import measured, rows_of
from held_out import FROZEN
from instructions import read_instructions, write_instructions

import models
from grounding.grounder import READERS
from grounding.learning.beliefs import EQUAL, learn_beliefs
from grounding.model.storage import load_learned

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def few():
    instructions, worlds = read_instructions(FROZEN, FROZEN.with_suffix(".worlds.json"))
    return instructions[:4], worlds


def test_every_reader_is_left_out_and_alone_once():
    rows = rows_of(READERS)
    assert len({row.name for row in rows}) == len(rows)
    assert {"all", "equal", "shuffled"} <= {row.name for row in rows}
    for name in READERS:
        without, only = (next(r for r in rows if r.name == f"{kind} {name}") for kind in ("without", "only"))
        assert without.without | only.without == set(READERS)
        assert not without.without & only.without


def test_the_share_of_everything_is_that_of_the_grounder(few, grounder):
    instructions, worlds = few
    rows = [row for row in rows_of(READERS) if row.name in ("all", "without literal", "only literal", "equal")]
    weights = {"learned": lambda: load_learned(models.BELIEFS), "equal": lambda: EQUAL}
    told = []
    found = measured(rows, instructions, worlds, weights, grounder.parser, lambda *row: told.append(row))
    right = [i.is_answered_by(grounder.ground(i.text, worlds[i.world], i.history)) for i in instructions]
    assert found["all"] == sum(right) / 4
    assert told == list(found.items())
    assert all(0 <= share <= 1 for share in found.values())


def test_weights_learned_from_shuffled_answers_do_not_know_what_is_meant(grounder):
    texts = training_texts(grounder, 0)[::40]
    learned, shuffled = learn_beliefs(texts, grounder), learn_beliefs(texts, grounder, shuffled=0)
    assert learned.deciding.misheard < 0.5 * shuffled.deciding.misheard  # what is drawn is mostly not what was read
    assert learn_beliefs(texts, grounder, shuffled=0) == shuffled


def test_the_command_prints_its_rows(few, tmp_path):
    instructions, worlds = few
    write_instructions(instructions[:2], worlds, tmp_path / "set.jsonl")
    command = [sys.executable, ROOT / "benchmarks" / "deciders.py", tmp_path / "set.jsonl",
               tmp_path / "set.worlds.json", "--json", "--rows", "all", "only literal"]  # fmt: skip
    result = subprocess.run(command, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert set(json.loads(result.stdout)) == {"instructions", "all", "only literal"}
