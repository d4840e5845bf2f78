"""Means and standard errors over splits, by slices, and methods beside each other."""

import math

import pytest

from grounding.experiments.summary import ALL, LARGE_WORLDS, NEW_TEXTS, compare, summarise, summarise_training


def row(name, root, *, inference="adcg", blocks=4, seen=True, right=3, complete=None):
    return {"id": name, "parse": "annotated", "inference": inference, "blocks": blocks, "text seen": seen,
            "world seen": True, "root": root, "complete": root if complete is None else complete, "right": right,
            "phrases": 4, "extra": 0, "missing": 0, "seconds": 0.1, "evaluations": 10}  # fmt: skip


def trial(number, rows, seconds=1.0):
    training = {"seconds": seconds, "megabytes": 50.0 + number, "megabytes before": 40.0, "examples": 6, "features": 9}
    return {"split": f"s{number}", "by": "random", "holdout": 0.5, "number": number, "training": training, "rows": rows}


TRIALS = [
    trial(0, [row("a", True), row("b", False, blocks=12, seen=False, right=1)], 2.0),
    trial(1, [row("a", True), row("c", True)], 4.0),
]


def records(measure="root"):
    return {record.slice: record for record in summarise(TRIALS) if record.measure == measure}


def test_every_split_counts_alike():
    whole = records()[ALL]
    assert whole.mean == pytest.approx((0.5 + 1.0) / 2)
    assert whole.standard_error == pytest.approx(math.sqrt(0.125) / math.sqrt(2))
    assert (whole.splits, whole.examples) == (2, 2.0)


def test_slices_hold_the_splits_that_have_such_examples():
    found = records()
    assert found["4 blocks"].mean == 1.0
    assert found["12 blocks"].mean == found[LARGE_WORLDS].mean == found[NEW_TEXTS].mean == 0.0
    assert (found["12 blocks"].splits, found["12 blocks"].standard_error) == (1, 0.0)


def test_phrases_are_counted_not_trees():
    assert records("phrases")[ALL].mean == pytest.approx((4 / 8 + 6 / 8) / 2)


def test_training_tells_mean_worst_and_what_was_seen():
    (cost,) = summarise_training(TRIALS)
    assert (cost.seconds, cost.slowest, cost.megabytes) == (3.0, 4.0, 51.0)
    assert (cost.texts_seen, cost.worlds_seen) == (0.75, 1.0)


def test_methods_are_compared_on_what_both_were_run_on():
    other = [row("a", False, inference="dcg")]
    (pair,) = compare([trial(0, [*TRIALS[0]["rows"], *other])])
    assert (pair.inference, pair.examples, pair.blocks) == ("dcg", 1, 4)
    assert pair.root == (1.0, 0.0)
    assert pair.same == 1.0


def hierarchical(name, root, kept, **rest):
    return {**row(name, root, **rest), "evaluations": 4, "kinds kept": kept, "kinds needed": 8}


def test_kept_kinds_are_a_measure_of_methods_with_a_first_pass_only():
    rows = [row("a", True), *(hierarchical(name, True, kept, inference="hadcg") for name, kept in (("a", 8), ("b", 6)))]
    found = {r.inference: r.mean for r in summarise([trial(0, rows)]) if (r.measure, r.slice) == ("kinds", ALL)}
    assert found == {"hadcg": pytest.approx(14 / 16)}


def test_hierarchical_methods_stand_beside_what_they_restrict():
    rows = [row("a", True), hierarchical("a", False, 8, inference="hadcg"), row("a", True, inference="dcg"),
            hierarchical("a", True, 8, inference="hdcg")]  # fmt: skip
    pairs = {(pair.inference, pair.against): pair for pair in compare([trial(0, rows)])}
    assert set(pairs) == {("hadcg", "adcg"), ("dcg", "adcg"), ("hdcg", "adcg"), ("hdcg", "dcg")}
    assert pairs["hadcg", "adcg"].root == (1.0, 0.0)
    assert pairs["hdcg", "dcg"].evaluations == (10.0, 4.0)
