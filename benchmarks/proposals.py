"""What adaptive proposals lose: of the answers that exhaustive search finds, the share that is proposed. Prints JSON.

    python benchmarks/proposals.py [--corpus FOLDER or FILE.jsonl] [--blocks 12] [--parts 5] [--most N] [--seed 0]

The corpus is parted by its texts; the examples of each part are grounded by exhaustive search with factors learned from
the others, with all incorrect combinations as negatives. An answer is a symbol of the likeliest hypothesis, or one with
a probability above the threshold. It is proposed if adaptive inference judges it in the same context: the same phrase,
with the children grounded as exhaustive search grounded them.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from grounding.corpus.format import Corpus
from grounding.corpus.loading import load_corpus
from grounding.errors import GroundingError
from grounding.features import STAGES, Scope, family_of
from grounding.geometry.layout import Layout
from grounding.inference import Adcg, Dcg, Hypothesis, aligned
from grounding.language.tree import Phrase
from grounding.learning import Negatives, learn
from grounding.learning.examples import annotated
from grounding.symbols import Symbol

THRESHOLD = 0.5
PENALTY = 0.3


def proposed_symbols(scope: Scope) -> set[Symbol]:
    """What adaptive inference judges at the stage of a scope."""
    return {symbol for family in STAGES[scope.stage] for symbol, _ in family.propose(scope)}


def proposed_for(phrase: Phrase, found: Hypothesis, layout: Layout) -> set[Symbol]:
    """What adaptive inference judges where everything before it is as exhaustive search has it."""
    scope = Scope(phrase, [child.symbols for child in found.children], layout)
    stage_of = {family.name: family.stage for stage in STAGES for family in stage}
    by_stage = [frozenset(s for s in found.symbols if stage_of[family_of(s)] == stage) for stage in range(len(STAGES))]
    settled = scope.with_concrete(by_stage[0])
    scopes = (scope, settled, settled.with_abstract(by_stage[1]))
    return set().union(*(proposed_symbols(one) for one in scopes))


def parts_of(corpus: Corpus, count: int, rng: np.random.Generator) -> list[set[str]]:
    """The texts of each part."""
    texts = sorted({example.instruction for example in corpus})
    order = rng.permutation(len(texts))
    return [{texts[i] for i in order[start::count]} for start in range(count)]


def measure(corpus: Corpus, blocks: int, parts: int, most: int, seed: int, sample: int) -> dict[str, object]:
    """All figures of one corpus."""
    rng = np.random.default_rng(seed)
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    small = corpus.select(e for e in corpus if layouts[e.world].size <= blocks)
    chosen = sorted(rng.permutation(len(small))[: most or len(small)].tolist())
    small = small.select(small.examples[i] for i in chosen)
    answers: Counter[str] = Counter()
    proposed: Counter[str] = Counter()
    lost: list[dict[str, str]] = []
    agreeing = right = lost_right = wholes = 0
    spent = 0.0
    for number, texts in enumerate(parts_of(small, parts, rng)):
        learned = [e for e in small if e.instruction not in texts]
        model = learn([annotated(e.tree, e.groundings, layouts[e.world]) for e in learned], PENALTY,
                      negatives=Negatives(blocks, sample, seed))  # fmt: skip
        engine, adaptive = Dcg(model), Adcg(model)
        for example in (e for e in small if e.instruction in texts):
            layout = layouts[example.world]
            start = time.perf_counter()
            best = engine.infer(example.tree, layout).hypotheses[0]
            spent += time.perf_counter() - start
            other = adaptive.infer(example.tree, layout).hypotheses[0]
            same = [a.symbols == b.symbols for (_, a), (_, b) in zip(aligned(example.tree, best),
                    aligned(example.tree, other), strict=True)]  # fmt: skip
            agreeing += same[0]
            wholes += all(same)
            gold = dict(zip(map(id, example.tree.preorder()), example.groundings, strict=True))
            for phrase, found in aligned(example.tree, best):
                known = proposed_for(phrase, found, layout)
                likely = {symbol for symbol, p in found.probabilities.items() if p > THRESHOLD}
                for symbol in sorted(found.symbols | likely, key=str):
                    answers[family_of(symbol)] += 1
                    is_right = symbol in gold[id(phrase)]
                    right += is_right
                    if symbol in known:
                        proposed[family_of(symbol)] += 1
                    else:
                        lost_right += is_right
                        lost.append({"id": example.id, "phrase": phrase.text, "symbol": str(symbol)})
        print(f"part {number + 1} of {parts}: {sum(proposed.values())} of {sum(answers.values())}", file=sys.stderr)
    count = len(small)
    return {
        "examples": count,
        "blocks": blocks,
        "answers": sum(answers.values()),
        "proposed": sum(proposed.values()),
        "share": round(sum(proposed.values()) / max(sum(answers.values()), 1), 5),
        "right answers": right,
        "share of right answers": round(1 - lost_right / max(right, 1), 5),
        "by family": {name: f"{proposed[name]} of {n}" for name, n in sorted(answers.items())},
        "same root": round(agreeing / max(count, 1), 4),
        "same tree": round(wholes / max(count, 1), 4),
        "exhaustive seconds a tree": round(spent / max(count, 1), 3),
        "lost": lost[:50],
    }


def main(arguments: Sequence[str] | None = None) -> int:
    """Read the arguments, measure, print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--corpus", type=Path, metavar="PATH",
                        help="a .jsonl file or a folder of example_*.xml (default: the shipped treebank)")  # fmt: skip
    parser.add_argument("--blocks", type=int, default=12, help="worlds of at most so many (default: 12)")
    parser.add_argument("--parts", type=int, default=5, help="so many parts, each grounded once (default: 5)")
    parser.add_argument("--most", type=int, default=0, help="so many examples, drawn evenly (default: all)")
    parser.add_argument("--sample", type=int, default=64, help="negatives drawn, see Negatives (default: 64)")
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args(arguments)
    try:
        report = measure(load_corpus(args.corpus), args.blocks, args.parts, args.most, args.seed, args.sample)
    except GroundingError as error:
        parser.exit(2, f"{error}\n")
    json.dump(report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
