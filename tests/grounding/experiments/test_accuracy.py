"""A split learned and tested; finished splits are kept, and done again only where something has changed."""

import json

import pytest
from tiny_corpus import tiny

from grounding.experiments.accuracy import report, run_splits, write_results
from grounding.experiments.splits import Split, make_splits
from grounding.experiments.store import Store, fingerprint
from grounding.experiments.trial import Settings, run_trial

BOTH = Settings(parse=("annotated", "own"))
EVERYTHING = tuple(range(len(tiny())))


@pytest.fixture(scope="module")
def splits():
    return make_splits(tiny(), "random", [0.5], 2, 0)


@pytest.fixture(scope="module")
def finished(splits, tmp_path_factory):
    folder = tmp_path_factory.mktemp("splits")
    told = []

    def begun(count, done):
        told.append((count, done))
        return told.append

    trials = run_splits(tiny(), splits, BOTH, Store(folder, tiny(), BOTH, 0), 2, begun)
    return folder, trials, told


def test_what_was_learned_from_is_found_again():
    trial = run_trial(tiny(), Split("random", 0.5, 0, EVERYTHING, EVERYTHING), BOTH, BOTH.variants)
    annotated = [row for row in trial["rows"] if row["parse"] == "annotated"]
    own = [row for row in trial["rows"] if row["parse"] == "own"]
    assert len(annotated) == len(own) == len(tiny())
    assert all(row["complete"] and row["text seen"] and row["world seen"] for row in annotated)
    assert sum(row["root"] for row in own) >= len(own) - 1
    assert trial["training"]["features"] > 0


def test_other_engines_are_run_up_to_their_size_only():
    settings = Settings(inference=("adcg", "dcg"), exhaustive=4, negatives=4)
    trial = run_trial(tiny(), Split("random", 0.5, 0, EVERYTHING, EVERYTHING), settings, settings.variants)
    sizes = {name: {row["blocks"] for row in trial["rows"] if row["inference"] == name} for name in ("adcg", "dcg")}
    assert sizes["dcg"] == {4}
    assert len(sizes["adcg"]) == 3


def test_kept_kinds_are_counted_where_there_is_a_first_pass(tmp_path):
    settings = Settings(inference=("adcg", "hadcg"))
    trial = run_trial(tiny(), Split("random", 0.5, 0, EVERYTHING, EVERYTHING), settings, settings.variants)
    for row in trial["rows"]:
        if row["inference"] == "hadcg":
            assert 0 <= row["kinds kept"] <= row["kinds needed"] > 0
        else:
            assert "kinds kept" not in row
        assert row["evaluations"] > 0
    told = report(write_results(tmp_path, tiny(), [trial], settings, {}))
    assert "kinds" in told
    assert "by adcg" in told


def test_every_split_is_tested_on_what_was_held_out(splits, finished):
    _, trials, told = finished
    assert told[0] == (2, 0)
    assert sorted(told[1:]) == sorted(split.name for split in splits)
    for split, trial in zip(splits, trials, strict=True):
        assert trial["split"] == split.name
        held = {tiny().examples[i].id for i in split.test}
        for variant in BOTH.variants:
            assert {row["id"] for row in trial["rows"] if (row["parse"], row["inference"]) == variant} == held


def test_finished_splits_are_not_done_again(splits, finished):
    folder, trials, _ = finished
    told = []

    def begun(count, done):
        told.append((count, done))
        return told.append

    again = run_splits(tiny(), splits, BOTH, Store(folder, tiny(), BOTH, 0), 1, begun)
    assert told == [(0, 2)]
    assert again == trials
    only = run_splits(tiny(), splits, Settings(), Store(folder, tiny(), Settings(), 0))
    assert {row["parse"] for trial in only for row in trial["rows"]} == {"annotated"}


def test_a_file_written_by_half_is_done_again(splits, finished):
    folder, trials, _ = finished
    store = Store(folder, tiny(), BOTH, 0)
    path = store.folder / f"{splits[0].name}.json"
    path.write_text(path.read_text(encoding="utf-8")[:100], encoding="utf-8")
    assert store.missing(splits[0].name, BOTH.variants) == BOTH.variants
    again = run_splits(tiny(), splits[:1], BOTH, store)
    timeless = [{k: v for k, v in row.items() if k != "seconds"} for row in again[0]["rows"]]
    assert timeless == [{k: v for k, v in row.items() if k != "seconds"} for row in trials[0]["rows"]]


def test_other_corpora_settings_and_seeds_have_splits_of_their_own(tmp_path):
    fewer = tiny().select(tiny().examples[1:])
    assert fingerprint(fewer) != fingerprint(tiny())
    stores = [Store(tmp_path, tiny(), BOTH, 0), Store(tmp_path, fewer, BOTH, 0), Store(tmp_path, tiny(), BOTH, 1),
              Store(tmp_path, tiny(), Settings(threshold=0.5), 0), Store(tmp_path, tiny(), Settings(), 0)]  # fmt: skip
    assert len({store.folder for store in stores}) == 4  # methods and parses share what was learned


def test_results_are_written_as_csv_and_json(finished, tmp_path):
    _, trials, _ = finished
    results = write_results(tmp_path, tiny(), trials, BOTH, {"worlds": 3})
    read = json.loads((tmp_path / "accuracy.json").read_text(encoding="utf-8"))
    assert read["corpus"]["worlds"] == 3
    assert read["paper"] is None
    assert len(read["records"]) == len(results["records"]) > 0
    for name, count in (("accuracy.csv", len(results["records"])), ("accuracy_splits.csv", 4)):
        assert len((tmp_path / name).read_text(encoding="utf-8").splitlines()) == count + 1
    told = report(results)
    assert "own" in told
    assert "training: at most" in told
