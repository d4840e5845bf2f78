"""How generation of annotated sentences goes: acceptance, times, wordings, what is covered. Prints JSON.

    python benchmarks/corpus_generation.py [--worlds 60] [--trees 100] [--seed 0] [--productions]

Every world gets so many sampled trees, suited to it; a tree is accepted if it can be annotated there. Then examples are
generated as for a corpus, and counted by outcome and kind of tree. Times are those of the processor.
"""

from __future__ import annotations

import argparse
import json
import re
import time
from collections import Counter

import numpy as np

from grounding.corpus.annotate import annotate
from grounding.corpus.check import check_corpus
from grounding.corpus.compositions import compose_world
from grounding.corpus.fitting import fit, vocabulary
from grounding.corpus.format import Corpus
from grounding.corpus.generator import generate, is_held_out, wording_of
from grounding.corpus.meaning import NotAnnotatable
from grounding.corpus.treebank import LaidWorld
from grounding.corpus.wording import FAMILIES, MARKS, PRODUCTIONS, sample

_QUOTED = re.compile(r"'[^']*'|\"[^\"]*\"")
_MARKED = {p.name: p.marks for productions in PRODUCTIONS.values() for p in productions}


def measure_annotation(worlds: list[LaidWorld], trees: int, rng: np.random.Generator) -> dict[str, object]:
    """Acceptance and time of sampled trees."""
    tried: Counter[str] = Counter()
    accepted: Counter[str] = Counter()
    outcomes: Counter[str] = Counter()
    refusals: Counter[str] = Counter()
    sampling, annotating = [], []
    for world in worlds:
        words = vocabulary(world.layout, world.arrangements)
        for _ in range(trees):
            start = time.process_time()
            drawn = sample(rng)
            tree = fit(drawn.tree, words, rng)
            middle = time.process_time()
            marks = {f"mark {mark}" for name in drawn.productions for mark in _MARKED.get(name, ())}
            names = {f"family {drawn.family}", *marks, *(f"production {name}" for name in drawn.productions)}
            tried.update(names)
            try:
                _, outcome = annotate(tree, world.layout, world.arrangements)
                accepted.update(names)
                outcomes[outcome] += 1
            except NotAnnotatable as error:
                refusals[_QUOTED.sub("_", str(error))] += 1
            annotating.append(time.process_time() - middle)
            sampling.append(middle - start)

    def share(kind: str, names: list[str]) -> dict[str, float]:
        return {name: round(accepted[f"{kind} {name}"] / max(tried[f"{kind} {name}"], 1), 3) for name in names}

    return {
        "trees": len(annotating),
        "accepted": round(sum(outcomes.values()) / len(annotating), 3),
        "outcomes of the accepted": dict(outcomes),
        "accepted by family": share("family", list(FAMILIES)),
        "accepted by mark": share("mark", list(MARKS)),
        "productions": {name: [accepted[f"production {name}"], tried[f"production {name}"]] for name in _MARKED},
        "refusals": dict(refusals.most_common(30)),
        "milliseconds a sampled tree, median": round(float(np.median(sampling)) * 1e3, 3),
        "milliseconds an annotation, median": round(float(np.median(annotating)) * 1e3, 3),
        "milliseconds an annotation, 99th percentile": round(float(np.quantile(annotating, 0.99)) * 1e3, 3),
    }


def measure_generation(worlds: list[LaidWorld], rng: np.random.Generator) -> dict[str, object]:
    """Examples as a corpus gets them."""
    taken: Counter[str] = Counter()
    start = time.process_time()
    examples = [example for world in worlds for example in generate(world, rng, 20, taken)]
    seconds = time.process_time() - start
    corpus = Corpus(tuple(examples), {world.name: world.layout.world for world in worlds})
    words = Counter(leaf.text for example in examples for leaf in example.tree.leaves)
    return {
        "examples": len(examples),
        "milliseconds of the processor an example": round(seconds / len(examples) * 1e3, 2),
        "outcomes": dict(Counter(example.outcome for example in examples)),
        "roots": dict(Counter(example.tree.tag for example in examples)),
        "with history": sum(bool(example.history) for example in examples),
        "wordings": len({wording_of(example.tree) for example in examples}),
        "held out": sum(is_held_out(example.tree) for example in examples),
        "different words": len(words),
        "words a sentence, median": float(np.median([len(example.tree.leaves) for example in examples])),
        "findings of the check": len(check_corpus(corpus)),
    }


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--worlds", type=int, default=60)
    parser.add_argument("--trees", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--productions", action="store_true", help="also acceptance of every production")
    args = parser.parse_args()
    rng = np.random.default_rng(args.seed)
    start = time.process_time()
    worlds = [compose_world(rng, f"w{number}") for number in range(args.worlds)]
    composing = (time.process_time() - start) / len(worlds) * 1e3
    annotation = measure_annotation(worlds, args.trees, rng)
    if not args.productions:
        del annotation["productions"]
    print(json.dumps({"milliseconds a world": round(composing, 1), "annotation": annotation,
                      "generation": measure_generation(worlds, rng)}, indent=1))  # fmt: skip


if __name__ == "__main__":
    main()
