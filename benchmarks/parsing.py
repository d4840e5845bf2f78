"""Held-out accuracy of the parser and its time, for one or more treebanks. Prints JSON.

    python benchmarks/parsing.py [--parts 5] [--seed 0] [--k 4] [FOLDER ...]

A folder holds `*.trees` or the paper's `example_*.xml`; by default the project's own treebank. Each part of a treebank
is parsed by a grammar learned from the other parts, split by wording; "own" is the grammar learned from all of the
treebank on the same trees; "shipped" parses with the grammar that ships.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np

import models
from grounding.corpus.loading import load_corpus
from grounding.corpus.treebank import read_trees
from grounding.language.grammar import Grammar
from grounding.language.measure import Score, held_out, score
from grounding.language.parser import Parser
from grounding.language.tree import Phrase


def read_folder(folder: Path) -> tuple[Phrase, ...]:
    """The trees of a folder."""
    if any(folder.glob("*.trees")):
        return read_trees(folder)
    return tuple(example.tree for example in load_corpus(folder).examples)


def rates(result: Score) -> dict[str, float]:
    """Shares of the sentences."""
    counts = {name: getattr(result, name) for name in ("exact", "among", "structure", "structure_among", "covered")}
    return {name: round(count / result.sentences, 4) for name, count in counts.items()} | {"f1": round(result.f1, 4)}


def times(parser: Parser, trees: Sequence[Phrase], k: int) -> dict[str, float]:
    """Milliseconds for a sentence, tokens and tags included, once the rules it needs are worked out."""
    spent: dict[int, list[float]] = {}
    for tree in trees:
        parser.parse(tree.text, k)
        begin = time.perf_counter()
        parser.parse(tree.text, k)
        spent.setdefault(len(tree.leaves), []).append(1e3 * (time.perf_counter() - begin))
    every = [value for values in spent.values() for value in values]
    summary = {"median": float(np.median(every)), "p95": float(np.quantile(every, 0.95))}
    summary |= {f"median of {n} words": float(np.median(spent[n])) for n in (8, 12, 16, 20) if n in spent}
    return {name: round(value, 2) for name, value in summary.items()}


def measure(trees: tuple[Phrase, ...], parts: int, seed: int, k: int) -> dict[str, object]:
    """All figures of one treebank."""
    total: Score | None = None
    for learned, parsed in held_out(trees, parts, np.random.default_rng(seed)):
        result = score(Parser(Grammar.learn(learned)), parsed, k)
        total = result if total is None else total + result
    assert total is not None
    own = Parser(Grammar.learn(trees))
    first = tuple({tree.text: tree for tree in reversed(trees)}.values())
    figures: dict[str, object] = {
        "trees": len(trees),
        "sentences": len(first),
        "median words": float(np.median([len(tree.leaves) for tree in first])),
        "held out": rates(total),
        "own": rates(score(own, first, k)),
        "milliseconds": times(own, first, k),
    }
    if models.GRAMMAR.exists():
        figures["shipped"] = rates(score(Parser.load(), first, k))
    return figures


def main() -> int:
    """Read the arguments, measure, print."""
    parser = argparse.ArgumentParser(description="Held-out accuracy of the parser and its time.")
    parser.add_argument("folders", nargs="*", type=Path, metavar="FOLDER", help="treebanks (default: the project's)")
    parser.add_argument("--parts", type=int, default=5, help="parts for held-out parsing (default: 5)")
    parser.add_argument("--seed", type=int, default=0, help="of the split (default: 0)")
    parser.add_argument("--k", type=int, default=4, help="readings a sentence (default: 4)")
    arguments = parser.parse_args()
    folders = arguments.folders or [models.ROOT / "treebank"]
    report = {
        folder.name: measure(read_folder(folder), arguments.parts, arguments.seed, arguments.k) for folder in folders
    }
    json.dump({"k": arguments.k, "parts": arguments.parts, "seed": arguments.seed} | report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
