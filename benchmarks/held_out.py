"""How well generated instructions whose wordings were kept from training are understood, as JSON.

    python benchmarks/held_out.py [--count 4000] [--seed 100] [--weights FILE] [--grammar FILE] [--wrong N]

Examples are generated in composed worlds with a seed that training does not use; those whose wording (without colours,
numbers, sides) is held out are grounded from their text. Root: the same actions on the same objects. Calibration:
expected calibration error of the answers, ten bins.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
from collections import Counter
from pathlib import Path

import models
from grounding.corpus.format import Example
from grounding.corpus.generator import is_held_out
from grounding.corpus.making import make_corpus
from grounding.grounder import Grounder
from grounding.readings import pick_of
from grounding.result import Grounding
from grounding.symbols import Action
from grounding.world import World


def main() -> None:
    """Generate, ground, compare."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--count", type=int, default=4000, help="generated examples; a tenth is held out")
    parser.add_argument("--seed", type=int, default=100)
    parser.add_argument("--grammar", type=Path, default=models.GRAMMAR)
    parser.add_argument("--weights", type=Path, default=models.WEIGHTS)
    parser.add_argument("--wrong", type=int, default=0, metavar="N", help="show N that are wrong on standard error")
    args = parser.parse_args()
    corpus = make_corpus(args.count, args.seed)
    kept = [example for example in corpus.examples if is_held_out(example.tree)]
    grounder = Grounder.load(args.grammar, args.weights)
    outcomes: Counter[str] = Counter()
    roots, milliseconds, pairs, shown = 0, [], [], 0
    for example in kept:
        world = corpus.worlds[example.world]
        result = grounder.ground(example.instruction, world, getattr(example, "history", ()))
        milliseconds.append(result.milliseconds)
        outcomes[f"{example.outcome} as {result.outcome}"] += 1
        right = _asked(example, world, grounder) == {(a.action, a.objects) for a in result.actions}
        roots += right
        if result.actions:
            pairs.append((result.actions[0].probability, right))
        if (not right or example.outcome != result.outcome) and shown < args.wrong:
            shown += 1
            _show(example, result)
    total = max(len(kept), 1)
    same = sum(count for name, count in outcomes.items() if name.split(" as ")[0] == name.split(" as ")[1])
    summary = {
        "examples": len(kept), "root": round(roots / total, 4), "outcome": round(same / total, 4),
        "calibration error": _calibration(pairs), "outcomes": dict(sorted(outcomes.items())),
        "milliseconds": round(statistics.median(milliseconds), 2) if milliseconds else None,
    }  # fmt: skip
    print(json.dumps(summary))


def _asked(example: Example, world: World, grounder: Grounder) -> set[tuple[str, tuple[str, ...]]]:
    """The actions that the annotation asks for; a noun phrase alone asks to pick up what it means."""
    if example.outcome != "grounded":
        return set()
    root = example.groundings[0]
    asked = {(s.kind, s.objects) for s in root if isinstance(s, Action) and s.objects}
    return asked or {(a.kind, a.objects) for a in pick_of(root, grounder.layout(world))}


def _calibration(pairs: list[tuple[float, bool]]) -> float | None:
    bins: list[list[tuple[float, bool]]] = [[] for _ in range(10)]
    for probability, right in pairs:
        bins[min(int(probability * 10), 9)].append((probability, right))
    gaps = sum(abs(sum(p for p, _ in b) - sum(r for _, r in b)) for b in bins)
    return round(gaps / len(pairs), 4) if pairs else None


def _show(example: Example, result: Grounding) -> None:
    found = [(a.action, a.objects, round(a.probability, 2)) for a in (*result.actions, *result.alternatives)][:3]
    wanted = sorted(str(s) for s in example.groundings[0])
    print(f"{example.instruction!r} {example.outcome} {wanted[:3]} -> {result.outcome} {found}", file=sys.stderr)


if __name__ == "__main__":
    main()
