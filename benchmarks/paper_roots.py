"""How well the shipped weights, which were not trained on it, ground the paper's corpus from its texts, as JSON.

    python benchmarks/paper_roots.py CORPUS [--wrong N]

Of the instructions whose annotated root means a single block: how many are answered with it. Some roots are annotated
wrongly, see docs/corrections.md.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from pathlib import Path

from freeze_paper_roots import single_roots

from grounding.corpus.loading import load_corpus
from grounding.grounder import Grounder


def main() -> None:
    """Ground every text and compare."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("corpus", type=Path, help="folder of example_*.xml")
    parser.add_argument("--wrong", type=int, default=0, metavar="N", help="show N that are wrong on standard error")
    args = parser.parse_args()
    corpus, grounder = load_corpus(args.corpus), Grounder.load()
    right, pairs, milliseconds, outcomes, shown = 0, [], [], dict[str, int](), 0
    for instruction in single_roots(corpus):
        start = time.process_time()
        result = grounder.ground(instruction.text, corpus.worlds[instruction.world])
        milliseconds.append(1000 * (time.process_time() - start))
        hit = instruction.is_answered_by(result)
        right += hit
        outcomes[result.outcome] = outcomes.get(result.outcome, 0) + 1
        if result.actions:
            pairs.append((result.actions[0].probability, hit))
        if not hit and shown < args.wrong:
            shown += 1
            print(f"{instruction.text!r} {sorted(instruction.objects)} -> {result.outcome}", file=sys.stderr)
    bins: list[list[tuple[float, bool]]] = [[] for _ in range(10)]
    for probability, hit in pairs:
        bins[min(int(probability * 10), 9)].append((probability, hit))
    gaps = sum(abs(sum(p for p, _ in b) - sum(h for _, h in b)) for b in bins)
    count = max(len(milliseconds), 1)
    print(json.dumps({
        "instructions": len(milliseconds), "right": right, "root": round(right / count, 4), "outcomes": outcomes,
        "calibration error": round(gaps / max(len(pairs), 1), 4),
        "milliseconds": round(statistics.median(milliseconds), 2) if milliseconds else None,
    }))  # fmt: skip


if __name__ == "__main__":
    main()
