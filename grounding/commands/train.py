"""`python -m grounding train`: learns the grammar and the factors from corpora and writes them."""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import models
from grounding.commands import SUMMARIES
from grounding.corpus.format import Corpus
from grounding.corpus.generator import is_held_out
from grounding.corpus.hands import read_hands
from grounding.corpus.loading import load_corpus
from grounding.corpus.making import make_corpus
from grounding.corpus.treebank import build_variants, read_trees
from grounding.corpus.wording import sampled_sentences, sentences_of
from grounding.factors import FactorModel, load_model, save_model
from grounding.features import FAMILIES
from grounding.geometry.layout import Layout
from grounding.grounder import Grounder
from grounding.language.compiled import write_tables
from grounding.language.grammar import Grammar
from grounding.language.parser import Parser
from grounding.language.terse import with_terse
from grounding.learning import learn, learn_first_pass
from grounding.learning.beliefs import EQUAL, learn_beliefs, texts_by_hand, texts_of
from grounding.learning.examples import Annotated, annotated
from grounding.model.storage import save_learned

VARIANTS = 4
SAMPLED = 4000
_SEED = 7  # of the sampled texts
PENALTY = 0.3  # chosen on held-out sentences


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `train`."""
    parser = subparsers.add_parser("train", help=SUMMARIES["train"], description=SUMMARIES["train"])
    parser.add_argument("--corpus", type=Path, nargs="+", metavar="FILE",
                        help="annotated examples, one corpus or several (default: the treebank that ships with the "
                        "project)")  # fmt: skip
    parser.add_argument("--generated", type=_count, default=0, metavar="N",
                        help="so many generated examples in composed worlds are learned from as well")  # fmt: skip
    parser.add_argument("--seed", type=_count, default=0, help="of what is generated")
    parser.add_argument("--hold-out", action="store_true", help="leave out the wordings that are kept for measuring")
    parser.add_argument("--trees", type=Path, default=models.TREEBANK, metavar="DIR",
                        help="folder of *.trees files that the grammar is learned from, beside the corpus")  # fmt: skip
    parser.add_argument("--output", type=Path, default=models.ROOT, metavar="DIR",
                        help="where grammar.json, grammar.tables, weights.npz and weights.json go (default: "
                        "models)")  # fmt: skip
    parser.add_argument("--variants", type=_count, default=VARIANTS, metavar="N",
                        help="so many variants of every tree are annotated and learned from as well")  # fmt: skip
    parser.add_argument("--sampled", type=_count, default=SAMPLED, metavar="N",
                        help="the grammar is learned from the trees of N sampled texts as well")  # fmt: skip
    parser.add_argument("--grammar-only", action="store_true", help="learn and write the grammar, leave the weights")
    parser.add_argument("--tables-only", action="store_true",
                        help="learn nothing; write grammar.tables for the grammar.json that is there")  # fmt: skip
    parser.add_argument("--first-pass-only", action="store_true",
                        help="learn the first pass of hierarchical inference and add it to the weights that are "
                        "there, which stay as they are")  # fmt: skip
    parser.add_argument("--beliefs-only", action="store_true",
                        help="learn the weights that decide, with the grammar and the factors that are there")
    parser.add_argument("--penalty", type=_strength, default=PENALTY, help="strength of the L2 regularisation")


def run(args: argparse.Namespace) -> int:
    """Train, write, and print a summary as JSON."""
    start = time.perf_counter()
    if args.tables_only:
        write_tables(args.output / models.GRAMMAR.name)
        return _finish({}, start, args.output)
    if args.beliefs_only:
        return _learn_beliefs(args, start)
    corpora = [load_corpus(path) for path in args.corpus or [None]]
    if args.generated:
        _say(f"{args.generated} examples are generated")
        corpora.append(make_corpus(args.generated, args.seed))
    corpora = [_learnable(corpus, args.hold_out) for corpus in corpora]
    if args.first_pass_only:
        model = load_model(args.output / models.WEIGHTS.name)
        return _add_first_pass(model, _all_examples(corpora, args), args, start)
    spoken = (sentence for corpus in corpora for e in corpus.examples for sentence in sentences_of(e.tree))
    trees = {str(tree): tree for tree in (*read_trees(args.trees), *spoken)}
    args.output.mkdir(parents=True, exist_ok=True)
    _say(f"grammar from {len(trees)} trees and {args.sampled} sampled texts")
    sampled = [tree for tree in sampled_sentences(args.sampled, _SEED) if not (args.hold_out and is_held_out(tree))]
    grammar = Grammar.learn(with_terse((*trees.values(), *sampled)))
    if args.grammar_only:
        _write_grammar(grammar, args.output)
        return _finish({"trees": len(trees), "sampled": args.sampled}, start, args.output)
    examples = _all_examples(corpora, args)
    _say(f"factors from {len(examples)} examples")
    model = learn(examples, args.penalty, _progress(), {"examples": len(examples), "corpus": _fingerprint(corpora)})
    _write_grammar(grammar, args.output)
    save_model(model, args.output / models.WEIGHTS.name)
    counts = {"trees": len(trees), "sampled": args.sampled, "examples": len(examples), "features": model.feature_count}
    if args.corpus is None:
        _learn_beliefs(args, start)
    return _finish(counts, start, args.output)


def _learn_beliefs(args: argparse.Namespace, start: float) -> int:
    """Learn the weights that decide, from the treebank, from generated texts and from free ones, and write them."""
    parser = Parser.load(args.output / models.GRAMMAR.name)
    grounder = Grounder(parser, EQUAL)
    corpora = [load_corpus(None)]
    if args.generated:
        _say(f"{args.generated} texts are generated")
        corpora.append(make_corpus(args.generated, args.seed + 1))
    kept = [corpus.select(e for e in corpus if not (args.hold_out and is_held_out(e.tree))) for corpus in corpora]
    texts = [text for corpus in kept for text in texts_of(corpus, grounder)]
    texts += texts_by_hand(read_hands(models.HANDS), grounder)
    _say(f"weights that decide from {len(texts)} texts")
    learned = learn_beliefs(texts, grounder, progress=_say)
    save_learned(learned, args.output / models.BELIEFS.name, {"texts": len(texts)})
    return _finish({"texts": len(texts), "weights": len(learned.deciding)}, start, args.output)


def _all_examples(corpora: Sequence[Corpus], args: argparse.Namespace) -> list[Annotated]:
    """The examples of corpora, and variants of the trees."""
    examples = [example for corpus in corpora for example in _examples(corpus)]
    if args.variants:
        _say(f"{args.variants} variants of each tree, annotated")
        examples += _examples(build_variants(read_trees(args.trees), models.SCENES, args.variants))
    return examples


def _add_first_pass(
    model: FactorModel, examples: Sequence[Annotated], args: argparse.Namespace, start: float
) -> int:
    """Learn a first pass and write it beside the factors that are there."""
    _say(f"first pass from {len(examples)} examples")
    first_pass = learn_first_pass(examples, args.penalty)
    save_model(replace(model, first_pass=first_pass), args.output / models.WEIGHTS.name)
    counts = {"examples": len(examples), "features of the first pass": first_pass.factor.feature_count}
    return _finish(counts, start, args.output)


def _write_grammar(grammar: Grammar, folder: Path) -> None:
    written = folder / (models.GRAMMAR.name + ".part")
    written.write_text(grammar.to_json(), encoding="utf-8")
    os.replace(written, folder / models.GRAMMAR.name)
    write_tables(folder / models.GRAMMAR.name)


def _finish(counts: dict[str, int], start: float, folder: Path) -> int:
    print(json.dumps(counts | {"seconds": round(time.perf_counter() - start, 1), "output": str(folder)}))
    return 0


def _count(text: str) -> int:
    value = int(text)
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text} is below 0")
    return value


def _strength(text: str) -> float:
    value = float(text)
    if not 0 <= value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no strength; it is a number from 0")
    return value


def _examples(corpus: Corpus) -> list[Annotated]:
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    return [annotated(e.tree, e.groundings, layouts[e.world]) for e in corpus.examples]


def _progress() -> Callable[[str], None]:
    names = [family.name for family in FAMILIES]

    def tell(name: str) -> None:
        done = names.index(name) if name in names else len(names)
        _say(f"[{'#' * done}{'.' * (len(names) - done)}] {done}/{len(names)} factors, now {name}")

    return tell


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def _learnable(corpus: Corpus, hold_out: bool) -> Corpus:
    """What factors learn from: not what needs the history of a dialogue, which features do not see."""
    return corpus.select(e for e in corpus if not e.history and not (hold_out and is_held_out(e.tree)))


def _fingerprint(corpora: Sequence[Corpus]) -> str:
    text = "\n".join(f"{e.id} {e.outcome} {e.tree}" for corpus in corpora for e in corpus.examples)
    return hashlib.sha256(text.encode()).hexdigest()[:16]
