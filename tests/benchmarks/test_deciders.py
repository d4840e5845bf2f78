import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from control_weights import equal_weights, shuffled, trained_on_shuffled
from deciders import LEARNED, measured, rows_of
from held_out import FROZEN
from instructions import read_instructions, write_instructions

import models
from grounding.factors import TrainingSet, load_model
from grounding.geometry.layout import Layout
from grounding.grounder import READERS
from grounding.learning.examples import annotated

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def few():
    instructions, worlds = read_instructions(FROZEN, FROZEN.with_suffix(".worlds.json"))
    return instructions[:4], worlds


def test_every_reader_is_left_out_and_alone_once():
    rows = rows_of(READERS, LEARNED)
    assert len({row.name for row in rows}) == len(rows)
    assert {"all", "equal", "shuffled"} <= {row.name for row in rows}
    for name in READERS:
        without, only = (next(r for r in rows if r.name == f"{kind} {name}") for kind in ("without", "only"))
        assert without.without | only.without == set(READERS)
        assert not without.without & only.without


def test_the_share_of_everything_is_that_of_the_grounder(few, grounder):
    instructions, worlds = few
    model = load_model(models.WEIGHTS)
    rows = [row for row in rows_of(READERS, LEARNED) if row.name in ("all", "without factors", "only graded", "equal")]
    weights = {"learned": lambda: model, "equal": lambda: equal_weights(model)}
    told = []
    found = measured(rows, instructions, worlds, weights, grounder.parser, lambda *row: told.append(row))
    right = [i.is_answered_by(grounder.ground(i.text, worlds[i.world], i.history)) for i in instructions]
    assert found["all"] == sum(right) / 4
    assert told == list(found.items())
    assert all(0 <= share <= 1 for share in found.values())


def test_equal_weights_differ_in_sign_only():
    model = load_model(models.WEIGHTS)
    for name, factor in equal_weights(model).factors.items():
        learned = model.factors[name].weights
        assert np.array_equal(np.sign(factor.weights), np.sign(learned))
        assert np.isclose(np.abs(factor.weights).sum(), np.abs(learned).sum())
        assert len(np.unique(np.abs(factor.weights[learned != 0]).round(12))) == 1


def test_shuffling_keeps_all_but_which_are_true():
    data = TrainingSet()
    rng = np.random.default_rng(5)
    for number in range(60):
        data.add([f"fact {number % 7}"], [([f"role {k}"], k == number % 4) for k in range(4)])
    other = shuffled(data, rng)

    def totals(rows, key):
        found = {}
        for row, count in rows.items():
            found[key(row)] = found.get(key(row), 0) + count
        return found

    for key in (lambda row: row[:2], lambda row: row[2]):  # judged as often, and as many true
        assert totals(other.rows, key) == totals(data.rows, key)
    assert other.rows != data.rows
    assert shuffled(data, np.random.default_rng(1)).rows == shuffled(data, np.random.default_rng(1)).rows


def test_shuffled_answers_are_trained_on(few):
    from grounding.corpus.loading import load_corpus

    corpus = load_corpus()
    examples = [annotated(e.tree, e.groundings, Layout(corpus.worlds[e.world])) for e in corpus.examples[:3]]
    model = trained_on_shuffled(examples, {"generated": 0})
    assert model.notes["examples"] == 3
    assert model.feature_count > 0


def test_the_command_prints_its_rows(few, tmp_path):
    instructions, worlds = few
    write_instructions(instructions[:2], worlds, tmp_path / "set.jsonl")
    command = [sys.executable, ROOT / "benchmarks" / "deciders.py", tmp_path / "set.jsonl",
               tmp_path / "set.worlds.json", "--json", "--rows", "all", "only literal"]  # fmt: skip
    result = subprocess.run(command, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert set(json.loads(result.stdout)) == {"instructions", "all", "only literal"}
