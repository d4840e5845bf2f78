"""How often two definitions of a concept agree, by intersection over union.

    python benchmarks/agreement.py [--json] [--worlds N] [--seed S] [--threshold T] [--concepts ...]

Every definition in `benchmarks/concepts.py` is asked in N composed worlds and in the scenes that ship. Of all that one
of two definitions holds of (ordered pairs of things, things between two others, single things, sets of them), the share
that both hold of is their agreement. What either leaves open is not compared. Concepts of the lexicon hold where they
are truer than T, one half by default. In the JSON, "held" counts what each definition holds of, and "open" is the share
of references that it leaves open.
"""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from typing import Any

import numpy as np
from concepts import CONCEPTS, HOLDS, PARTS, Concept, Seen

import models
from grounding.corpus.compositions import compose_world, recognise
from grounding.world import load_world


def worlds_of(count: int, seed: int, threshold: float = HOLDS) -> Iterator[Seen]:
    """So many composed worlds, then the scenes that ship; the lexicon's concepts hold above the threshold."""
    for number in range(count):
        yield Seen(compose_world(np.random.default_rng([seed, number]), f"w{number}"), threshold)
    for path in sorted(models.SCENES.glob("*.json")):
        yield Seen(recognise(path.stem, load_world(path)), threshold)


def agreement(concept: Concept, worlds: Iterable[Seen]) -> dict[str, Any]:
    """How a concept's definitions agree.

    Args:
        concept: with two definitions at least.
        worlds: in which they are asked.

    Returns:
        "held", "open" by part, and "agreement" by part and part, None where both never hold of anything.
    """
    parts = [part for part in PARTS if part in concept.definitions]
    both, either, held, silent, asked = Counter[Any](), Counter[Any](), Counter[str](), Counter[str](), 0
    for seen in worlds:
        for reference in concept.references(seen):
            asked += 1
            found = {part: concept.held(part, seen, reference) for part in parts}
            held.update({part: len(told) for part, told in found.items() if told is not None})
            silent.update(part for part, told in found.items() if told is None)
            for pair in combinations(parts, 2):
                one, other = (found[part] for part in pair)
                if one is not None and other is not None:
                    both[pair] += len(one & other)
                    either[pair] += len(one | other)
    shares = {pair: round(both[pair] / either[pair], 3) if either[pair] else None for pair in combinations(parts, 2)}
    matrix: dict[str, dict[str, float | None]] = {part: {} for part in parts}
    for (first, second), share in shares.items():
        matrix[first][second] = matrix[second][first] = share
    return {"held": {part: held[part] for part in parts},
            "open": {part: round(silent[part] / max(asked, 1), 3) for part in parts}, "agreement": matrix}  # fmt: skip


def main() -> None:
    """Compose, ask, compare, print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    parser.add_argument("--worlds", type=int, default=100, metavar="N", help="composed worlds, beside the scenes")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threshold", type=float, default=HOLDS, metavar="T",
                        help="the lexicon's concepts hold of what is truer")  # fmt: skip
    parser.add_argument("--concepts", nargs="+", choices=list(CONCEPTS), metavar="NAME", default=list(CONCEPTS),
                        help="only these: " + ", ".join(CONCEPTS))  # fmt: skip
    args = parser.parse_args()
    worlds = list(worlds_of(args.worlds, args.seed, args.threshold))
    found = {name: agreement(CONCEPTS[name], worlds) for name in args.concepts}
    if args.json:
        print(json.dumps({"worlds": len(worlds), "seed": args.seed, "threshold": args.threshold, "concepts": found}))
    else:
        print("\n".join(table(found)))


def table(found: dict[str, dict[str, Any]], parts: Sequence[str] = PARTS) -> list[str]:
    """The lines of a table: a concept a line, a pair of definitions a column."""
    pairs = list(combinations(parts, 2))
    names = [f"{first} {second}" for first, second in pairs]
    lines = [" ".join((f"{'':<12}", *(f"{name:>17}" for name in names)))]
    for concept, report in found.items():
        cells = []
        for first, second in pairs:
            share = report["agreement"].get(first, {}).get(second)
            cells.append("–" if share is None else f"{share:.2f}")
        lines.append(" ".join((f"{concept:<12}", *(f"{cell:>17}" for cell in cells))))
    return lines


if __name__ == "__main__":
    main()
