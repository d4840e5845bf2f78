"""Efficiency (Table I): what a phrase costs by number of blocks, in the corpus's worlds and in larger ones."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from grounding.corpus.format import Corpus
from grounding.experiments.engines import ADAPTIVE, PROPOSING, needed_negatives
from grounding.experiments.large_worlds import compose_large
from grounding.experiments.paper import TABLE_I, is_papers
from grounding.experiments.processes import Task, in_processes, peak_memory
from grounding.experiments.store import fingerprint
from grounding.experiments.tables import text_table, write_csv, write_json
from grounding.experiments.timing import Cost, measure_cost
from grounding.factors import FactorModel
from grounding.geometry.layout import Layout
from grounding.learning import Negatives, learn
from grounding.learning.examples import annotated

PENALTY = 0.1
WORLDS = 4  # composed worlds of every size
_PRELOADED = ("grounding.experiments.timing", "scipy.optimize", "scipy.sparse")
Tell = Callable[[str], None]


class Measured(NamedTuple):
    """All that was measured.

    Attributes:
        costs: by engine and size.
        training: seconds and megabytes of learning the factors from the whole corpus.
    """

    costs: tuple[Cost, ...]
    training: Mapping[str, float | None]


def measure_efficiency(
    corpus: Corpus,
    engines: Sequence[str],
    blocks: Sequence[int],
    exhaustive: int,
    instructions: int,
    budget: float,
    seed: int,
    begun: Callable[[int, str], Tell] | None = None,
) -> Measured:
    """Measure every engine at every size, each in a process of its own, one after the other.

    Args:
        corpus: whose instructions are grounded, with factors learned from all of it.
        engines: names.
        blocks: sizes of composed worlds; the corpus's instructions are grounded in these as well.
        exhaustive: engines that judge all of Γ are measured up to so many blocks.
        instructions: for every size of a composed world.
        budget: seconds for an engine at a size, after which no further instruction is begun.
        seed: of the composed worlds and of the choice of instructions.
        begun: told the number of measurements; gives what is told of each.
    """
    negatives = needed_negatives(tuple(engines), exhaustive)
    [(_, (model, training))] = in_processes([Task("training", _learned, (corpus, negatives))], preload=_PRELOADED)
    cases = [*_corpus_cases(corpus, seed), *(_composed_case(corpus, n, instructions, seed) for n in blocks)]
    tasks = [
        Task(f"{name} at {size} blocks", measure_cost, (model, name, composed, worlds, pairs, budget))
        for name in engines
        for size, composed, worlds, pairs in cases
        if name in PROPOSING or size <= exhaustive
    ]
    tell = None if begun is None else begun(len(tasks), "measurements")
    costs: list[Cost | None] = [None] * len(tasks)
    for place, cost in in_processes(tasks, preload=_PRELOADED):
        costs[place] = cost
        if tell is not None:
            tell(tasks[place].name)
    return Measured(tuple(cost for cost in costs if cost is not None), training)


def growth(costs: Sequence[Cost]) -> dict[str, dict[str, float]]:
    """How the cost grows with the number of blocks n, by engine.

    Returns:
        `exponent` b of seconds = a n^b and `evaluations_exponent` of evaluations ditto, by least squares between the
        logarithms of medians; `per_block`: the factor by which the time grows with each block, if it grows
        exponentially; `composed_exponent`: b over the composed worlds, in which the phrases are the same at all sizes.
        Left out are engines whose largest world is not twice the smallest.
    """
    found = {}
    for name in dict.fromkeys(cost.inference for cost in costs):
        lines = [c for c in costs if c.inference == name and c.median]
        if not lines or max(c.blocks for c in lines) < 2 * min(c.blocks for c in lines):
            continue
        known = [(c.blocks, c.median, c.evaluations) for c in lines]
        n, median, evaluations = np.array(known, dtype=float).T
        seconds, count = np.log(median), np.log(evaluations)
        found[name] = {
            "exponent": _slope(np.log(n), seconds),
            "evaluations_exponent": _slope(np.log(n), count),
            "per_block": math.exp(_slope(n, seconds)),
        }
        composed = [(c.blocks, c.median) for c in lines if c.composed]
        if len(composed) > 1:
            found[name]["composed_exponent"] = _slope(*np.log(np.array(composed, dtype=float).T))
    return found


def ratios(costs: Sequence[Cost]) -> list[dict[str, Any]]:
    """How many times the time of ADCG every other engine takes in the same worlds, beside the paper's ratio."""
    ours = {(c.blocks, c.composed): c for c in costs if c.inference == ADAPTIVE}
    found = []
    for cost in costs:
        other = ours.get((cost.blocks, cost.composed))
        if cost.inference == ADAPTIVE or other is None or not (cost.mean and other.mean):
            continue
        line: dict[str, Any] = {"blocks": cost.blocks, "inference": cost.inference, "ratio": cost.mean / other.mean,
                "evaluations_ratio": (cost.evaluations or 0.0) / max(other.evaluations or 0.0, 1e-9)}  # fmt: skip
        if cost.inference == "dcg" and cost.blocks in TABLE_I:
            line["paper"] = TABLE_I[cost.blocks].dcg / TABLE_I[cost.blocks].adcg
        found.append(line)
    return found


def write_results(folder: Path, corpus: Corpus, measured: Measured) -> dict[str, Any]:
    """Write `efficiency.json` and `efficiency.csv`; gives what the JSON file holds."""
    papers = is_papers(corpus)
    results: dict[str, Any] = {
        "corpus": {"examples": len(corpus), "fingerprint": fingerprint(corpus)},
        "training": measured.training,
        "costs": measured.costs,
        "growth": growth(measured.costs),
        "ratios": ratios(measured.costs),
        "paper": dict(TABLE_I) if papers else None,
    }
    lines = []
    for cost in measured.costs:
        line = {key: value for key, value in cost._asdict().items() if key != "spaces"}
        lines.append({**line, "paper": _paper_seconds(cost) if papers else None})
    write_csv(folder / "efficiency.csv", lines)
    write_json(folder / "efficiency.json", results)
    return results


def report(results: Mapping[str, Any]) -> str:
    """The main figures as text."""
    header = ["inference", "blocks", "phrases", "mean ms", "median ms", "p95 ms", "paper ms", "world ms", "evaluations",
              "MB"]  # fmt: skip
    rows = []
    for cost in results["costs"]:
        paper = _paper_seconds(cost) if results["paper"] else None
        size = f"{cost.blocks}{'*' if cost.composed else ''}"
        times = [_milli(v) for v in (cost.mean, cost.median, cost.p95, paper, cost.world)]
        rows.append([cost.inference, size, cost.phrases, *times, _whole(cost.evaluations), _whole(cost.megabytes)])
    parts = [text_table(header, rows)]
    parts[0] += "\n* composed worlds"
    parts += [f"{c.inference} at {c.blocks} blocks: {c.refused}" for c in results["costs"] if c.refused]
    lines = [
        f"{name}: time grows as n^{fit['exponent']:.2f} (by {fit['per_block']:.2f} a block if exponentially), "
        f"evaluations as n^{fit['evaluations_exponent']:.2f}"
        + (f"; in composed worlds time as n^{fit['composed_exponent']:.2f}" if "composed_exponent" in fit else "")
        for name, fit in results["growth"].items()
    ]
    for line in results["ratios"]:
        theirs = f" (paper: {line['paper']:.0f})" if "paper" in line else ""
        lines.append(
            f"{line['inference']} / adcg at {line['blocks']} blocks: {line['ratio']:.1f} times the time{theirs}, "
            f"{line['evaluations_ratio']:.1f} times the evaluations"
        )
    return "\n\n".join([*parts, "\n".join(lines)]) if lines else "\n\n".join(parts)


def _learned(corpus: Corpus, negatives: int) -> tuple[FactorModel, dict[str, float | None]]:
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    start = time.perf_counter()
    examples = [annotated(e.tree, e.groundings, layouts[e.world]) for e in corpus]
    model = learn(examples, PENALTY, negatives=Negatives(negatives))
    return model, {"seconds": time.perf_counter() - start, "megabytes": peak_memory()}


Case = tuple[int, bool, list[Any], list[tuple[Any, int]]]


def _corpus_cases(corpus: Corpus, seed: int) -> list[Case]:
    """The corpus's instructions in their worlds, by number of blocks, in a random order."""
    names: dict[int, list[str]] = {}
    for name, world in corpus.worlds.items():
        names.setdefault(len(world.things), []).append(name)
    cases: list[Case] = []
    for size, group in sorted(names.items()):
        chosen = [e for e in corpus if e.world in group]
        order = np.random.default_rng((seed, size)).permutation(len(chosen))
        pairs = [(chosen[i].tree, group.index(chosen[i].world)) for i in order.tolist()]
        if pairs:
            cases.append((size, False, [corpus.worlds[name] for name in group], pairs))
    return cases


def _composed_case(corpus: Corpus, blocks: int, instructions: int, seed: int) -> Case:
    """Instructions of the corpus in composed worlds of a size: the same phrases, more blocks."""
    rng = np.random.default_rng((seed, 1, blocks))
    worlds = [compose_large(rng, blocks) for _ in range(WORLDS)]
    trees = list({str(e.tree): e.tree for e in corpus}.values())
    order = rng.permutation(len(trees))[:instructions]
    return blocks, True, worlds, [(trees[i], k % WORLDS) for k, i in enumerate(order.tolist())]


def _paper_seconds(cost: Cost) -> float | None:
    line = None if cost.composed else TABLE_I.get(cost.blocks)
    return None if line is None or cost.inference not in ("dcg", "adcg") else float(getattr(line, cost.inference))


def _slope(x: Any, y: Any) -> float:
    return float(np.polyfit(x, y, 1)[0])


def _milli(seconds: float | None) -> float | None:
    return None if seconds is None else 1000 * seconds


def _whole(value: float | None) -> int | None:
    return None if value is None else round(value)
