"""How long grounding takes: loading, parsing, inference, over the shipped instructions. Prints JSON.

    python benchmarks/grounding_speed.py [--instructions FILE.jsonl] [--repeats N]

"fresh": every instruction by a grounder that was just loaded, as a command that grounds one instruction does.
"kept": by a grounder that has grounded all of them once, as a program that keeps it does; what it remembers of words,
rules and worlds helps. "inference" is everything but parsing: measuring the world, grounding, weighing the readings.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from grounding import Grounder, World
from grounding.language.parser import Parse, Parser
from integration.run import load_scene

INSTRUCTIONS = Path(__file__).resolve().parents[1] / "tests" / "integration" / "instructions.jsonl"


class TimedParser(Parser):
    """A parser that adds up the time it takes.

    Attributes:
        seconds: spent parsing so far.
    """

    def __init__(self, parser: Parser) -> None:
        super().__init__(parser.grammar)
        self.seconds = 0.0

    def parse(self, text: str, k: int = 4) -> tuple[Parse, ...]:
        """As the parser does."""
        start = time.perf_counter()
        found = super().parse(text, k)
        self.seconds += time.perf_counter() - start
        return found


class Spent(NamedTuple):
    """Times of one instruction in [ms]."""

    whole: float
    parsing: float


def loaded() -> tuple[Grounder, TimedParser, float]:
    """A grounder, its parser, and how long loading it took in [ms]."""
    start = time.perf_counter()
    grounder = Grounder.load()
    milliseconds = 1e3 * (time.perf_counter() - start)
    parser = TimedParser(grounder.parser)
    return Grounder(parser, grounder.learned, grounder.parses), parser, milliseconds


def timed(grounder: Grounder, parser: TimedParser, text: str, world: World) -> Spent:
    """Grounds one instruction."""
    before, start = parser.seconds, time.perf_counter()
    grounder.ground(text, world)
    return Spent(1e3 * (time.perf_counter() - start), 1e3 * (parser.seconds - before))


def summarised(spent: Sequence[Spent]) -> dict[str, Any]:
    """Median and 90th percentile of the whole and of its parts."""
    parts = {
        "whole": [one.whole for one in spent],
        "parsing": [one.parsing for one in spent],
        "inference": [one.whole - one.parsing for one in spent],
    }
    return {
        name: {"median": round(float(np.median(values)), 2), "p90": round(float(np.quantile(values, 0.9)), 2)}
        for name, values in parts.items()
    }


def main() -> int:
    """Read the arguments, measure, print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--instructions", type=Path, default=INSTRUCTIONS, metavar="FILE.jsonl")
    parser.add_argument("--repeats", type=int, default=3, help="of everything (default: 3)")
    args = parser.parse_args()
    lines = [json.loads(line) for line in args.instructions.read_text(encoding="utf-8").splitlines() if line.strip()]
    cases = [(str(line["instruction"]), load_scene(line["scene"])) for line in lines]
    loading: list[float] = []
    fresh: list[Spent] = []
    kept: list[Spent] = []
    for _ in range(args.repeats):
        for text, world in cases:
            grounder, timer, milliseconds = loaded()
            loading.append(milliseconds)
            fresh.append(timed(grounder, timer, text, world))
        grounder, timer, _ = loaded()
        for text, world in cases:
            timed(grounder, timer, text, world)
        kept += [timed(grounder, timer, text, world) for text, world in cases]
    report = {
        "instructions": len(cases),
        "repeats": args.repeats,
        "python": platform.python_version(),
        "loading_milliseconds": round(float(np.median(loading)), 1),
        "milliseconds": {"fresh": summarised(fresh), "kept": summarised(kept)},
    }
    json.dump(report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
