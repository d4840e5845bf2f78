"""How well the project's own wordings that were kept from training are understood, as JSON.

    python benchmarks/held_out.py [--set FILE | --count N --seed N] [--freeze FILE] [--wrong N]

The texts are those of `benchmarks/sets/held_out.jsonl`, which stay the same whatever becomes of the generator. With
`--count` and `--seed` others are drawn: examples are generated in composed worlds with a seed that training does not
use, and those whose wording (without colours, numbers, sides) is held out are kept. `--freeze` writes what was drawn
instead of grounding it. Root: the same actions on the same objects. Calibration: expected calibration error of the
answers, ten bins.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
from collections import Counter
from pathlib import Path

from instructions import Instruction, instruction_of, read_instructions, write_instructions

import models
from grounding.corpus.generator import is_held_out
from grounding.corpus.making import make_corpus
from grounding.grounder import Grounder
from grounding.result import Grounding
from grounding.world import World

FROZEN = Path(__file__).parent / "sets" / "held_out.jsonl"
COUNT, SEED = 1500, 101  # that the frozen set was drawn with


def main() -> None:
    """Read or draw, ground, compare."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--set", type=Path, default=FROZEN, metavar="FILE", help="instructions, their worlds beside it")
    parser.add_argument("--count", type=int, help="draw anew from so many generated examples; a tenth is held out")
    parser.add_argument("--seed", type=int, help="draw anew with this seed")
    parser.add_argument("--freeze", type=Path, metavar="FILE", help="write what is drawn to FILE and ground nothing")
    parser.add_argument("--grammar", type=Path, default=models.GRAMMAR)
    parser.add_argument("--beliefs", type=Path, default=models.BELIEFS)
    parser.add_argument("--wrong", type=int, default=0, metavar="N", help="show N that are wrong on standard error")
    args = parser.parse_args()
    if args.count is None and args.seed is None and args.freeze is None:
        kept, worlds = read_instructions(args.set, args.set.with_suffix(".worlds.json"))
    else:
        kept, worlds = drawn(COUNT if args.count is None else args.count, SEED if args.seed is None else args.seed)
    if args.freeze is not None:
        write_instructions(kept, worlds, args.freeze)
        print(json.dumps({"examples": len(kept), "output": str(args.freeze)}))
        return
    print(json.dumps(measured(kept, worlds, Grounder.load(args.grammar, args.beliefs), args.wrong)))


def drawn(count: int, seed: int) -> tuple[tuple[Instruction, ...], dict[str, World]]:
    """The instructions with held-out wordings among so many that are generated."""
    corpus = make_corpus(count, seed)
    kept = [example for example in corpus.examples if is_held_out(example.tree)]
    return tuple(instruction_of(e, corpus.worlds[e.world]) for e in kept), dict(corpus.worlds)


def measured(
    kept: tuple[Instruction, ...], worlds: dict[str, World], grounder: Grounder, wrong: int = 0
) -> dict[str, object]:
    """The shares of right roots and outcomes, and how far the answers' probabilities are from them."""
    outcomes: Counter[str] = Counter()
    roots, milliseconds, pairs, shown = 0, [], [], 0
    for instruction in kept:
        result = grounder.ground(instruction.text, worlds[instruction.world], instruction.history)
        milliseconds.append(result.milliseconds)
        outcomes[f"{instruction.outcome} as {result.outcome}"] += 1
        right = instruction.actions == {(a.action, a.objects) for a in result.actions}
        roots += right
        if result.actions:
            pairs.append((result.actions[0].probability, right))
        if (not right or instruction.outcome != result.outcome) and shown < wrong:
            shown += 1
            _show(instruction, result)
    total = max(len(kept), 1)
    same = sum(count for name, count in outcomes.items() if name.split(" as ")[0] == name.split(" as ")[1])
    return {
        "examples": len(kept), "root": round(roots / total, 4), "outcome": round(same / total, 4),
        "calibration error": _calibration(pairs), "outcomes": dict(sorted(outcomes.items())),
        "milliseconds": round(statistics.median(milliseconds), 2) if milliseconds else None,
    }  # fmt: skip


def _calibration(pairs: list[tuple[float, bool]]) -> float | None:
    bins: list[list[tuple[float, bool]]] = [[] for _ in range(10)]
    for probability, right in pairs:
        bins[min(int(probability * 10), 9)].append((probability, right))
    gaps = sum(abs(sum(p for p, _ in b) - sum(r for _, r in b)) for b in bins)
    return round(gaps / len(pairs), 4) if pairs else None


def _show(instruction: Instruction, result: Grounding) -> None:
    found = [(a.action, a.objects, round(a.probability, 2)) for a in (*result.actions, *result.alternatives)][:3]
    wanted = sorted(instruction.actions)[:3]
    print(f"{instruction.text!r} {instruction.outcome} {wanted} -> {result.outcome} {found}", file=sys.stderr)


if __name__ == "__main__":
    main()
