"""Accuracy over holdouts (Figure 5): splits are learned and tested, kept as they are done, and summed up."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from grounding.corpus.format import Corpus
from grounding.experiments import summary
from grounding.experiments.paper import FIGURE_5, is_papers
from grounding.experiments.processes import Task, in_processes
from grounding.experiments.splits import Split
from grounding.experiments.store import Store, fingerprint
from grounding.experiments.tables import text_table, write_csv, write_json
from grounding.experiments.trial import Settings, run_trial

PRELOADED = ("grounding.experiments.trial", "scipy.optimize", "scipy.sparse")
Told = Callable[[str], None]


def run_splits(
    corpus: Corpus,
    splits: Sequence[Split],
    settings: Settings,
    store: Store,
    jobs: int = 1,
    begun: Callable[[int, int], Told] | None = None,
) -> list[summary.Trial]:
    """Do all splits that are not done yet.

    Args:
        corpus: to learn from and to test on.
        splits: of it.
        settings: of the run.
        store: where finished splits are kept.
        jobs: processes at a time.
        begun: told how many splits are to be done and how many are done already; gives what is told of each.

    Returns:
        one trial a split, in the order of `splits`, with the rows of the asked variants.

    Raises:
        ExperimentError: a split could not be done; those that were done before are kept.
    """
    wanted = [(split, store.missing(split.name, settings.variants)) for split in splits]
    wanted = [(split, variants) for split, variants in wanted if variants]
    tell = None if begun is None else begun(len(wanted), len(splits) - len(wanted))
    tasks = [Task(f"split {s.name}", run_trial, (corpus, s, settings, variants)) for s, variants in wanted]
    for place, trial in in_processes(tasks, jobs, PRELOADED):
        store.add(trial, wanted[place][1])
        if tell is not None:
            tell(trial["split"])
    return [_of_variants(store.read(split.name), settings) for split in splits]


def write_results(
    folder: Path, corpus: Corpus, trials: Sequence[summary.Trial], settings: Settings, about: dict[str, Any]
) -> dict[str, Any]:
    """Sum up and write `accuracy.json`, `accuracy.csv` and `accuracy_splits.csv`.

    Args:
        folder: where the files go.
        corpus: that was split.
        trials: from `run_splits`.
        settings: of the run.
        about: more on the run, kept in the JSON file.

    Returns:
        what the JSON file holds.
    """
    records = summary.summarise(trials)
    results: dict[str, Any] = {
        "corpus": {"examples": len(corpus), "fingerprint": fingerprint(corpus), **about},
        "settings": settings.__dict__,
        "records": records,
        "training": summary.summarise_training(trials),
        "agreement": summary.compare(trials),
        "paper": dict(FIGURE_5) if is_papers(corpus) else None,
    }
    write_csv(folder / "accuracy.csv", records)
    write_csv(folder / "accuracy_splits.csv", _by_split(trials))
    write_json(folder / "accuracy.json", results)
    return results


def report(results: dict[str, Any]) -> str:
    """The main figures as text."""
    rows: list[list[Any]] = []
    large: list[list[Any]] = []
    for record in results["records"]:
        if record.slice not in (summary.ALL, summary.LARGE_WORLDS) or record.measure != "root":
            continue
        same = [r for r in results["records"] if r[:5] == record[:5]]
        line = [record.by, record.parse, record.inference, f"{record.holdout:.2f}"]
        line += [f"{r.mean:.3f} ± {r.standard_error:.3f}" for r in same]
        line += ["-"] * (len(summary.MEASURES) - len(same))
        (rows if record.slice == summary.ALL else large).append([*line, record.splits, round(record.examples, 1)])
    header = ["split", "parse", "inference", "holdout", "root", "complete", "phrases", "kinds", "splits", "tested"]
    parts = [text_table(header, rows)]
    if large:
        parts.append(f"worlds of {summary.LARGE_WORLDS}:\n" + text_table(header, large))
    costs = results["training"]
    if costs:
        peaks = [cost.megabytes for cost in costs if cost.megabytes is not None]
        memory = f", at most {max(peaks):.0f} MB" if peaks else ""
        parts.append(f"training: at most {max(cost.slowest for cost in costs):.1f} s a split{memory}")
    for pair in results["agreement"]:
        parts.append(
            f"{pair.inference} on the same {pair.examples} examples of up to {pair.blocks} blocks "
            f"({pair.by}, {pair.parse} parse): root {pair.root[1]:.3f} against {pair.root[0]:.3f} by {pair.against}, "
            f"complete {pair.complete[1]:.3f} against {pair.complete[0]:.3f}, "
            f"{pair.evaluations[1]:,.0f} evaluations an instruction against {pair.evaluations[0]:,.0f}"
        )
    return "\n\n".join(parts)


def _of_variants(trial: summary.Trial | None, settings: Settings) -> summary.Trial:
    assert trial is not None  # every split is done by now
    return {**trial, "rows": [r for r in trial["rows"] if (r["parse"], r["inference"]) in settings.variants]}


def _by_split(trials: Sequence[summary.Trial]) -> list[dict[str, Any]]:
    """One line a split and variant."""
    lines = []
    for trial in trials:
        for parse, name in dict.fromkeys((row["parse"], row["inference"]) for row in trial["rows"]):
            rows = [row for row in trial["rows"] if (row["parse"], row["inference"]) == (parse, name)]
            known = summary.measures_of(rows)
            shares = {m: summary.share(rows, m) if m in known else None for m in summary.MEASURES}
            lines.append({"by": trial["by"], "holdout": trial["holdout"], "split": trial["number"], "parse": parse,
                          "inference": name, "trained on": trial["training"]["examples"], "tested on": len(rows),
                          **shares, "training seconds": trial["training"]["seconds"],
                          "training megabytes": trial["training"]["megabytes"]})  # fmt: skip
    return lines
