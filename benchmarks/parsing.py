"""Held-out accuracy of the parser and its time, for one or more treebanks. Prints JSON.

    python benchmarks/parsing.py [--parts 5] [--seed 0] [--k 4] [--sampled 4000] [--texts FILE.jsonl ...] [FOLDER ...]

A folder holds `*.trees` or the paper's `example_*.xml`; by default the project's own treebank. Each part of a treebank
is parsed by a grammar learned from the other parts and from sampled texts, split by wording; "own" is the grammar
learned from all of the treebank on the same trees; "shipped" parses with the grammar that ships. "people" are the
trees held out from training, in the style of what people write, parsed with the shipped grammar. Of texts without gold
trees (lines with "instruction") it tells how many parse whole, how many have unknown or mended words, and the time.
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
from grounding.commands.train import SAMPLED
from grounding.corpus.loading import load_corpus
from grounding.corpus.treebank import read_trees
from grounding.corpus.wording import sampled_sentences
from grounding.language.grammar import Grammar
from grounding.language.measure import Score, held_out, score, written
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


def times(parser: Parser, texts: Sequence[str], k: int) -> dict[str, float]:
    """Milliseconds for a text, tokens and tags included, once the rules it needs are worked out."""
    spent: dict[int, list[float]] = {}
    for text in texts:
        parser.parse(text, k)
        begin = time.perf_counter()
        parser.parse(text, k)
        spent.setdefault(len(text.split()), []).append(1e3 * (time.perf_counter() - begin))
    every = [value for values in spent.values() for value in values]
    summary = {"median": float(np.median(every)), "p95": float(np.quantile(every, 0.95))}
    summary |= {f"median of {n} words": float(np.median(spent[n])) for n in (8, 12, 16, 20) if n in spent}
    return {name: round(value, 2) for name, value in summary.items()}


def wild(parser: Parser, path: Path, k: int) -> dict[str, object]:
    """Figures of texts without gold trees."""
    lines = path.read_text(encoding="utf-8").splitlines()
    texts = sorted({json.loads(line)["instruction"] for line in lines if line.strip()})
    best = [parser.parse(text, k)[0] for text in texts]
    shares = {
        "parsed whole": [parse.complete for parse in best],
        "with unknown words": [bool(parse.unknown_words) for parse in best],
        "with mended words": [bool(parse.mended) for parse in best],
    }
    figures: dict[str, object] = {name: round(float(np.mean(values)), 4) for name, values in shares.items()}
    return {"texts": len(texts), **figures, "milliseconds": times(parser, texts, k)}


def measure(trees: tuple[Phrase, ...], sampled: tuple[Phrase, ...], parts: int, seed: int, k: int) -> dict[str, object]:
    """All figures of one treebank."""
    total: Score | None = None
    for learned, parsed in held_out(trees, parts, np.random.default_rng(seed)):
        result = score(Parser(Grammar.learn((*learned, *sampled))), parsed, k)
        total = result if total is None else total + result
    assert total is not None
    own = Parser(Grammar.learn((*trees, *sampled)))
    first = tuple({tree.text: tree for tree in reversed(trees)}.values())
    figures: dict[str, object] = {
        "trees": len(trees),
        "sentences": len(first),
        "median words": float(np.median([len(tree.leaves) for tree in first])),
        "held out": rates(total),
        "own": rates(score(own, first, k)),
        "milliseconds": times(own, [written(tree) for tree in first], k),
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
    parser.add_argument("--sampled", type=int, default=SAMPLED, help=f"sampled texts (default: {SAMPLED})")
    parser.add_argument("--texts", nargs="+", type=Path, default=[], metavar="FILE", help="texts without gold trees")
    parser.add_argument("--people-only", action="store_true", help="leave the treebanks out")
    arguments = parser.parse_args()
    k, shipped = arguments.k, Parser.load()
    people = read_trees(models.TREEBANK / "heldout")
    report: dict[str, object] = {
        "k": k, "parts": arguments.parts, "seed": arguments.seed, "sampled": arguments.sampled,
        "people": {"trees": len(people), "shipped": rates(score(shipped, people, k)),
                   "milliseconds": times(shipped, [written(tree) for tree in people], k)},
    }  # fmt: skip
    for path in arguments.texts:
        report[path.stem] = wild(shipped, path, k)
    sampled = tuple(sampled_sentences(arguments.sampled, 7))
    for folder in [] if arguments.people_only else arguments.folders or [models.TREEBANK]:
        report[folder.name] = measure(read_folder(folder), sampled, arguments.parts, arguments.seed, k)
    json.dump(report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
