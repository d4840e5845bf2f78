"""Two checkouts side by side: do they give the same parses and arrangements, and how long does each take? Prints JSON.

    python benchmarks/against.py OTHER [--repeats N] [--sampled N] [--worlds N] [--only times|parses|arrangements]

OTHER is a second working tree, such as `git worktree add ../base COMMIT` makes. Every measurement runs in a process of
its own, by turns in OTHER and here, and is processor time, so that what else the computer does weighs little.

"cold": the first instruction over 20 objects by a grounder that was just loaded, without loading. "parse": its parsing.
"large": measuring and grounding in worlds of 200 objects that nothing was asked of before, once the texts were parsed;
"asked": the same where the answer is a question; "measure": only measuring one. "kept": the small world again. "ground"
is the command `python -m grounding ground` from start to exit, with its modules' bytecode at hand, for both apart.
Parses are compared on the sentences held out from the treebank, on the treebank, on texts drawn from its sampler, and
on held-out and drawn ones with a letter missing; arrangements on composed, random and regular worlds.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
TEXT = "pick up the middle block in the row of five blocks on the right"
TEXTS = (TEXT, "take the leftmost red block", "put the nearest block beside the tower")
SAME = 1e-12


def probe_times(_: argparse.Namespace) -> dict[str, float]:
    """Processor seconds in [s] of one process; see above."""
    import numpy as np

    from grounding import Grounder
    from grounding.experiments.large_worlds import compose_large
    from grounding.geometry.layout import Layout

    small, asked, other = (compose_large(np.random.default_rng(7), count) for count in (20, 200, 200))
    large = [(text, compose_large(np.random.default_rng(seed), 200)) for seed in (1, 2, 3) for text in TEXTS]
    seconds: dict[str, float] = {}

    def timed(name: str, run: Callable[[], object]) -> Any:
        start = time.process_time()
        value = run()
        seconds[name] = time.process_time() - start
        return value

    grounder = timed("load", Grounder.load)
    timed("parse", lambda: grounder.parser.parse(TEXT))
    fresh = Grounder.load()
    timed("cold", lambda: fresh.ground(TEXT, small))
    for text in TEXTS:
        fresh.ground(text, small)
    timed("large", lambda: [fresh.ground(text, world) for text, world in large])
    timed("asked", lambda: fresh.ground(TEXT, asked))
    timed("kept", lambda: fresh.ground(TEXT, small))
    layout = Layout(other)
    timed("measure", lambda: layout.evident)
    return seconds


def probe_parses(args: argparse.Namespace) -> list[Any]:
    """The four best parses of every text."""
    from grounding.language.parser import Parser

    parser = Parser.load()
    found = []
    for text in texts(args.sampled):
        parses = parser.parse(text)
        found.append([text, [[f"{p.tree} {p.mended} {p.unknown_words} {p.complete}", p.log_probability, p.probability]
                             for p in parses]])  # fmt: skip
    return found


def texts(sampled: int) -> list[str]:
    """What is parsed, without repetitions."""
    import numpy as np

    import models
    from grounding.corpus.treebank import read_trees
    from grounding.corpus.wording import sampled_sentences

    held_out = [tree.text for tree in read_trees(models.TREEBANK / "heldout")]
    drawn = [tree.text for tree in sampled_sentences(sampled, 11)]
    known = [tree.text for tree in read_trees(models.TREEBANK)]
    rng = np.random.default_rng(0)

    def misspelt(text: str) -> str:
        words = text.split()
        place = int(rng.integers(len(words)))
        letter = int(rng.integers(len(words[place])))
        words[place] = words[place][:letter] + words[place][letter + 1 :] or "x"
        return " ".join(words)

    return list(dict.fromkeys([*held_out, *drawn, *known, *map(misspelt, (*held_out, *drawn))]))


def probe_arrangements(args: argparse.Namespace) -> list[Any]:
    """The arrangements of every world."""
    from grounding.geometry.arrangements import find_arrangements

    found = []
    for name, positions, edges in scenes(args.worlds):
        found.append([name, [[f"{a.kind} {a.mask} {a.count} {a.evident} {a.noticed}", *map(float, a.centroid),
                              a.deviation, a.regularity, a.separation, a.angle, a.prominence]
                             for a in find_arrangements(positions, edges)]])  # fmt: skip
    return found


def scenes(count: int) -> Iterator[tuple[str, Any, Any]]:
    """Names, positions and edges of worlds."""
    import numpy as np

    import models
    from grounding.experiments.large_worlds import compose_large
    from grounding.world import load_world

    def of(world: Any) -> tuple[Any, Any]:
        return world.positions, np.array([item.size.mean() for item in world.things])

    for path in sorted(models.SCENES.glob("*.json")):
        yield (path.stem, *of(load_world(path)))
    for seed in range(count):
        rng = np.random.default_rng(seed)
        size = int(rng.integers(3, 200 if seed % 8 == 0 else 25))
        yield (f"composed {seed}", *of(compose_large(rng, size)))
        spread = rng.uniform(0.05, 0.8)
        points = np.column_stack([rng.uniform(0, spread, size), rng.uniform(0, spread, size), np.full(size, 0.02)])
        yield f"random {seed}", points, np.full(size, 0.04) * rng.uniform(0.9, 1.1, size)
        points[:, :2] = np.round(points[:, :2] / 0.06) * 0.06  # regular: many equal distances, some at one place
        yield f"regular {seed}", points, np.full(size, 0.05)


PROBES: dict[str, Callable[[argparse.Namespace], Any]] = {
    "times": probe_times,
    "parses": probe_parses,
    "arrangements": probe_arrangements,
}


def run(root: Path, cache: Path, *arguments: str) -> str:
    """What `python ARGUMENTS` prints in one checkout."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    environment |= {"PYTHONPATH": str(root), "PYTHONPYCACHEPREFIX": str(cache), "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, *arguments]
    done = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{root}: {done.stderr}")
    return done.stdout


def probed(root: Path, cache: Path, task: str, args: argparse.Namespace) -> Any:
    """What a probe finds in one checkout."""
    sizes = ("--sampled", str(args.sampled), "--worlds", str(args.worlds))
    return json.loads(run(root, cache, __file__, str(root), "--probe", task, *sizes))


def command_seconds(root: Path, cache: Path) -> float:
    """Processor seconds in [s] of `python -m grounding ground` from start to exit."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(root, cache, "-m", "grounding", "ground", TEXT)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def compare_times(other: Path, cache: Path, args: argparse.Namespace) -> dict[str, Any]:
    """Medians in [s] of both, and the median of the ratios of pairs."""
    spent: dict[Path, list[dict[str, float]]] = {other: [], ROOT: []}
    for root in spent:
        command_seconds(root, cache)
    for _ in range(args.repeats):
        for root, runs in spent.items():
            runs.append({**probed(root, cache, "times", args), "ground": command_seconds(root, cache)})
    return {
        name: {
            "other": round(statistics.median(run[name] for run in spent[other]), 4),
            "here": round(statistics.median(run[name] for run in spent[ROOT]), 4),
            "ratio": round(
                statistics.median(b[name] / a[name] for a, b in zip(spent[other], spent[ROOT], strict=True)), 3
            ),
        }
        for name in spent[ROOT][0]
    }


def compare_results(task: str, other: Path, cache: Path, args: argparse.Namespace) -> dict[str, Any]:
    """How many results are the same to `SAME`, the largest difference of numbers, and the first that differ."""
    ours, theirs = probed(ROOT, cache, task, args), probed(other, cache, task, args)
    differing: list[str] = []
    largest, parts = 0.0, 0
    for (name, mine), (_, its) in zip(ours, theirs, strict=True):
        parts += len(mine)
        if [one[0] for one in mine] != [one[0] for one in its]:
            differing.append(name)
            continue
        pairs = [pair for one, two in zip(mine, its, strict=True) for pair in zip(one[1:], two[1:], strict=True)]
        off = max((abs(a - b) / max(1.0, abs(b)) for a, b in pairs if a != b), default=0.0)
        largest = max(largest, off)
        if not off <= SAME or math.isnan(off):
            differing.append(name)
    return {"compared": len(ours), "parts": parts, "differing": len(differing), "largest": largest,
            "first": differing[:5]}  # fmt: skip


def main() -> int:
    """Read the arguments, measure or compare, print."""
    parser = argparse.ArgumentParser(description="Two checkouts side by side: results and processor time.")
    parser.add_argument("other", type=Path, metavar="OTHER", help="folder of the other checkout")
    parser.add_argument("--repeats", type=int, default=7, help="pairs of timed processes (default: 7)")
    parser.add_argument("--sampled", type=int, default=300, help="texts drawn to be parsed (default: 300)")
    parser.add_argument("--worlds", type=int, default=150, help="worlds of each sort (default: 150)")
    parser.add_argument("--only", choices=PROBES, help="leave the others out")
    parser.add_argument("--probe", choices=PROBES, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.probe:
        json.dump(PROBES[args.probe](args), sys.stdout)
        return 0
    other = args.other.resolve()
    report: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as folder:
        cache = Path(folder)
        for task in (args.only,) if args.only else PROBES:
            timed = task == "times"
            report[task] = compare_times(other, cache, args) if timed else compare_results(task, other, cache, args)
    json.dump(report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
