"""From finished splits to means with their standard errors, as a whole and by slices of the tested examples."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from grounding.experiments.engines import ADAPTIVE, FLAT

MEASURES = ("root", "complete", "phrases", "kinds")
LARGE = 10  # blocks of what is called a large world
ALL, LARGE_WORLDS, NEW_TEXTS = "all", f"{LARGE} blocks and more", "texts not in training"

Trial = dict[str, Any]
Row = dict[str, Any]


class Record(NamedTuple):
    """A mean over splits.

    Attributes:
        by: how the corpus was split.
        holdout: share that was held out.
        parse: "annotated" or "own".
        inference: the engine.
        slice: which of the tested examples.
        measure: one of `MEASURES`; "kinds" is the share of the needed kinds of symbols that a first pass kept.
        mean: over the splits that have such examples, each split's share counting alike.
        standard_error: of that mean; 0 for a single split.
        splits: how many splits have such examples.
        examples: how many they have on average.
    """

    by: str
    holdout: float
    parse: str
    inference: str
    slice: str
    measure: str
    mean: float
    standard_error: float
    splits: int
    examples: float


class Training(NamedTuple):
    """What training cost, and how much of what is tested it had seen.

    Attributes:
        by: how the corpus was split.
        holdout: share that was held out.
        examples: learned from, on average.
        seconds: on average.
        slowest: in [s].
        megabytes: the most memory of any of these processes; None where the system does not tell.
        texts_seen: share of the tested texts that also occur in training.
        worlds_seen: share of the tested examples whose world also occurs in training.
    """

    by: str
    holdout: float
    examples: float
    seconds: float
    slowest: float
    megabytes: float | None
    texts_seen: float
    worlds_seen: float


class Agreement(NamedTuple):
    """An engine beside another one, on the examples that both were run on.

    Attributes:
        by: how the corpus was split.
        parse: "annotated" or "own".
        inference: the engine.
        against: the other one: ADCG or, for a hierarchical engine, the one that it restricts.
        blocks: of the largest world that it was run on.
        examples: tested by both, over all splits and holdouts.
        root: share of right roots by the other one and by the engine.
        complete: share of complete trees by the other one and by the engine.
        evaluations: of factors by the other one and by the engine, an example.
        same: share of examples on which both have the same number of phrases right.
    """

    by: str
    parse: str
    inference: str
    against: str
    blocks: int
    examples: int
    root: tuple[float, float]
    complete: tuple[float, float]
    evaluations: tuple[float, float]
    same: float


def summarise(trials: Sequence[Trial]) -> tuple[Record, ...]:
    """All means, ordered by split, parse, engine, slice and measure."""
    shares: dict[tuple[Any, ...], list[tuple[float, int]]] = {}
    for trial in trials:
        groups: dict[tuple[Any, ...], list[Row]] = {}
        for row in trial["rows"]:
            for name in _slices(row):
                key = (trial["by"], trial["holdout"], row["parse"], row["inference"], name)
                groups.setdefault(key, []).append(row)
        for key, rows in groups.items():
            for measure in measures_of(rows):
                shares.setdefault((*key, measure), []).append((share(rows, measure), len(rows)))
    return tuple(_record(key, values) for key, values in sorted(shares.items(), key=lambda item: _order(item[0])))


def measures_of(rows: Sequence[Row]) -> tuple[str, ...]:
    """The measures that rows have: kinds are kept by methods with a first pass only."""
    return MEASURES if all("kinds kept" in row for row in rows) else MEASURES[:-1]


def share(rows: Sequence[Row], measure: str) -> float:
    """The share of right roots, complete trees or phrases, or of the needed kinds that were kept."""
    if measure == "kinds":
        return float(sum(row["kinds kept"] for row in rows) / max(sum(row["kinds needed"] for row in rows), 1))
    if measure == "phrases":
        return float(sum(row["right"] for row in rows) / sum(row["phrases"] for row in rows))
    return float(np.mean([row[measure] for row in rows]))


def summarise_training(trials: Iterable[Trial]) -> tuple[Training, ...]:
    """What training cost, by split and holdout."""
    groups: dict[tuple[str, float], list[Trial]] = {}
    for trial in trials:
        groups.setdefault((trial["by"], trial["holdout"]), []).append(trial)
    found = []
    for (by, holdout), group in sorted(groups.items()):
        costs = [trial["training"] for trial in group]
        rows = [row for trial in group for row in trial["rows"]]
        seconds = [cost["seconds"] for cost in costs]
        peaks = [cost["megabytes"] for cost in costs if cost["megabytes"] is not None]
        found.append(
            Training(by, holdout, float(np.mean([cost["examples"] for cost in costs])), float(np.mean(seconds)),
                     max(seconds), max(peaks, default=None), float(np.mean([row["text seen"] for row in rows])),
                     float(np.mean([row["world seen"] for row in rows])))
        )  # fmt: skip
    return tuple(found)


def compare(trials: Iterable[Trial], adaptive: str = ADAPTIVE) -> tuple[Agreement, ...]:
    """Every engine beside ADCG, hierarchical ones beside what they restrict, split by split on the same examples."""
    pairs: dict[tuple[str, str, str, str], list[tuple[Row, Row]]] = {}
    for trial in trials:
        rows_of = {(row["inference"], row["parse"], row["id"]): row for row in trial["rows"]}
        for row in trial["rows"]:
            name = row["inference"]
            for other in dict.fromkeys((adaptive, FLAT.get(name, adaptive))):
                beside = rows_of.get((other, row["parse"], row["id"]))
                if name not in (adaptive, other) and beside is not None:
                    pairs.setdefault((trial["by"], row["parse"], name, other), []).append((beside, row))
    found = []
    for (by, parse, name, other), rows in sorted(pairs.items()):
        first, second = [a for a, _ in rows], [b for _, b in rows]
        found.append(
            Agreement(by, parse, name, other, max(row["blocks"] for row in second), len(rows),
                      (share(first, "root"), share(second, "root")),
                      (share(first, "complete"), share(second, "complete")),
                      (_evaluations(first), _evaluations(second)),
                      float(np.mean([a["right"] == b["right"] for a, b in rows])))
        )  # fmt: skip
    return tuple(found)


def _evaluations(rows: Sequence[Row]) -> float:
    return float(np.mean([row["evaluations"] for row in rows]))


def _slices(row: Row) -> Iterator[str]:
    yield ALL
    yield f"{row['blocks']} blocks"
    if row["blocks"] >= LARGE:
        yield LARGE_WORLDS
    if not row["text seen"]:
        yield NEW_TEXTS


def _record(key: tuple[Any, ...], values: Sequence[tuple[float, int]]) -> Record:
    shares = np.array([value for value, _ in values])
    error = float(shares.std(ddof=1) / math.sqrt(len(shares))) if len(shares) > 1 else 0.0
    by, holdout, parse, inference, name, measure = key
    tested = float(np.mean([count for _, count in values]))
    return Record(by, holdout, parse, inference, name, measure, float(shares.mean()), error, len(shares), tested)


def _order(key: tuple[Any, ...]) -> tuple[Any, ...]:
    by, holdout, parse, inference, name, measure = key
    size = int(name.split()[0]) if name.endswith("blocks") else 0
    return by, parse, inference, holdout, (name != ALL, name == LARGE_WORLDS, size, name), MEASURES.index(measure)
