"""`python -m grounding corpus`: show, check, convert and generate corpora, and list their worlds."""

from __future__ import annotations

import argparse
import json
import math
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import models
from grounding.commands import SUMMARIES
from grounding.commands.corpus_hands import check_texts, holds_texts, list_worlds, show_texts
from grounding.commands.corpus_scenes import add_scenes, run_scenes
from grounding.corpus.check import Finding, check_corpus
from grounding.corpus.format import Corpus, worlds_path, write_corpus
from grounding.corpus.generator import is_held_out, wording_of
from grounding.corpus.loading import load_corpus
from grounding.corpus.making import EACH, make_corpus
from grounding.corpus.pretty import Paint, pretty
from grounding.corpus.rss_world import shifted
from grounding.corpus.treebank import build_treebank
from grounding.errors import CorpusError, CorpusErrors
from grounding.experiments.progress import Progress
from grounding.world import save_world

FOUND = 1  # exit code of a check that found something
_PATH = "a .jsonl file or a folder of example_*.xml or hands.jsonl (default: the treebank that ships with the project)"


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `corpus` and those of its verbs."""
    corpus = subparsers.add_parser("corpus", help=SUMMARIES["corpus"], description=SUMMARIES["corpus"])
    verbs = corpus.add_subparsers(dest="verb", metavar="VERB", required=True)

    show = verbs.add_parser("show", help="print examples: every phrase with its groundings")
    show.add_argument("path", nargs="?", type=Path, help=_PATH)
    show.add_argument("--id", help="only the example of this id")
    show.add_argument("--limit", type=_count, metavar="N", help="only the first N examples")

    check = verbs.add_parser("check", help="check a corpus against its worlds and itself; exit code 1 if it disagrees")
    check.add_argument("path", nargs="?", type=Path, help=_PATH)
    check.add_argument("--keep-going", action="store_true", help="list everything that is refused, not the first only")
    check.add_argument("--json", action="store_true", help="print the findings as JSON")

    worlds = verbs.add_parser("worlds", help="list the worlds of a corpus")
    worlds.add_argument("path", nargs="?", type=Path, help=_PATH)

    convert = verbs.add_parser("convert", help="write a corpus in the project's format, or one of its worlds")
    convert.add_argument("path", type=Path, help=_PATH)
    convert.add_argument("--output", type=Path, required=True, metavar="FILE",
                         help=".jsonl for the corpus (worlds beside it), .json for one world")  # fmt: skip
    convert.add_argument("--world", metavar="NAME", help="which world to write")
    convert.add_argument("--id", help="write the world of this example")
    convert.add_argument("--shift", type=_metres, default=0.0, metavar="M",
                         help="move the table and what lies on it along x, in metres, e.g. --shift -0.25")  # fmt: skip

    annotate = verbs.add_parser("annotate", help="annotate gold trees in the shipped scenes and in composed worlds")
    annotate.add_argument("--trees", type=Path, default=models.TREEBANK, metavar="DIR", help="folder of *.trees files")
    annotate.add_argument("--worlds", type=_count, default=200, metavar="N", help="so many composed worlds")
    annotate.add_argument("--seed", type=int, default=1, help="of the worlds and of where each tree is tried")
    annotate.add_argument("--output", type=Path, default=models.TREEBANK / "treebank.jsonl", metavar="FILE.jsonl")

    generate = verbs.add_parser("generate", help="write annotated sentences in composed worlds, without physics")
    generate.add_argument("--count", type=_count, required=True, metavar="N", help="so many examples")
    generate.add_argument("--seed", type=int, default=0, help="the same one gives the same corpus")
    generate.add_argument("--each", type=_count, default=EACH, metavar="N", help="at most so many examples a world")
    generate.add_argument("--output", type=Path, required=True, metavar="FILE.jsonl",
                          help="worlds go beside it; an interrupted run goes on where it ended")  # fmt: skip

    add_scenes(verbs, _count)


def run(args: argparse.Namespace) -> int:
    """Run the verb that was asked for."""
    verbs: dict[str, Callable[[argparse.Namespace], int]] = {
        "show": _show, "check": _check, "worlds": _worlds, "convert": _convert,
        "annotate": _annotate, "generate": _generate, "scenes": run_scenes,
    }  # fmt: skip
    return verbs[args.verb](args)


def _annotate(args: argparse.Namespace) -> int:
    corpus = build_treebank(args.trees, models.SCENES, args.worlds, args.seed)
    write_corpus(corpus, args.output)
    outcomes = Counter(example.outcome for example in corpus.examples)
    summary = {"sentences": len({e.instruction for e in corpus.examples}), "examples": len(corpus),
               "outcomes": dict(sorted(outcomes.items())), "worlds": len(corpus.worlds)}  # fmt: skip
    print(json.dumps(summary))
    return 0


def _generate(args: argparse.Namespace) -> int:
    if args.output.suffix != ".jsonl" or args.seed < 0:
        raise CorpusError(f"{args.output}, seed {args.seed}: a corpus is written to a .jsonl file, from a seed from 0")
    progress = Progress(args.count, "examples")

    def tell(number: int) -> None:
        for _ in range(number):
            progress.step()

    kept = args.output.with_suffix(".part")
    args.output.parent.mkdir(parents=True, exist_ok=True)
    corpus = make_corpus(args.count, args.seed, args.each, kept, tell)
    write_corpus(corpus, args.output)
    kept.unlink(missing_ok=True)
    outcomes = Counter(example.outcome for example in corpus.examples)
    summary = {"examples": len(corpus), "worlds": len(corpus.worlds), "outcomes": dict(sorted(outcomes.items())),
               "wordings": len({wording_of(example.tree) for example in corpus}),
               "held out": sum(is_held_out(example.tree) for example in corpus)}  # fmt: skip
    print(json.dumps(summary))
    return 0


def _count(text: str) -> int:
    value = int(text) if text.isdecimal() else 0
    if value < 1:
        raise argparse.ArgumentTypeError(f"a number from 1, not {text!r}")
    return value


def _metres(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"a distance in metres, not {text!r}")
    return value


def _show(args: argparse.Namespace) -> int:
    if holds_texts(args.path):
        return show_texts(args.path, args.id, args.limit)
    corpus = load_corpus(args.path)
    examples = [corpus[args.id]] if args.id is not None else corpus.examples[: args.limit]
    paint = Paint.for_stream(sys.stdout)
    for number, example in enumerate(examples):
        print(("\n" if number else "") + pretty(example, paint))
    return 0


def _check(args: argparse.Namespace) -> int:
    try:
        summary, findings = (check_texts if holds_texts(args.path) else _examples)(args.path, args.keep_going)
    except CorpusErrors as error:
        if args.json:
            print(json.dumps({"refused": [str(problem) for problem in error.problems], "findings": []}, indent=1))
        raise
    if args.json:
        plain = [finding.to_json() for finding in findings]
        print(json.dumps({**summary, "refused": [], "findings": plain}, indent=1))
    else:
        for finding in findings:
            print(finding)
        counts = ", ".join(f"{count} {name}" for name, count in summary.items())
        print(f"{counts}; {len(findings) or 'no'} finding{'' if len(findings) == 1 else 's'}", file=sys.stderr)
    return FOUND if findings else 0


def _examples(path: Path, keep_going: bool) -> tuple[dict[str, int], tuple[Finding, ...]]:
    corpus = load_corpus(path, keep_going)
    phrases = sum(len(example.groundings) for example in corpus)
    return {"examples": len(corpus), "worlds": len(corpus.worlds), "phrases": phrases}, check_corpus(corpus)


def _worlds(args: argparse.Namespace) -> int:
    if holds_texts(args.path):
        return list_worlds(args.path)
    corpus = load_corpus(args.path)
    used = Counter(example.world for example in corpus)
    for name, world in corpus.worlds.items():
        colors = Counter(item.color for item in world.things)
        listed = ", ".join(f"{count} {color}" for color, count in sorted(colors.items()))
        print(f"{name}\t{len(world.things)} objects ({listed})\t{used[name]} instructions")
    return 0


def _convert(args: argparse.Namespace) -> int:
    corpus = load_corpus(args.path)
    moved = Corpus(corpus.examples, {name: shifted(world, args.shift) for name, world in corpus.worlds.items()})
    if args.output.suffix == ".jsonl" and args.world is None and args.id is None:
        write_corpus(moved, args.output)
        print(f"{len(moved)} examples to {args.output}, {len(moved.worlds)} worlds to {worlds_path(args.output)}",
              file=sys.stderr)  # fmt: skip
        return 0
    if args.output.suffix != ".json":
        raise CorpusError(f"{args.output}: a corpus is written to a .jsonl file, a world to a .json file")
    name = moved[args.id].world if args.id is not None else args.world
    if name is None and len(moved.worlds) == 1:
        name = next(iter(moved.worlds))
    if name not in moved.worlds:
        asked = "name one with --world or --id" if name is None else f"no world {name!r}"
        raise CorpusError(f"{asked}; this corpus has {', '.join(moved.worlds)}")
    save_world(moved.worlds[name], args.output)
    print(f"world {name!r} to {args.output}", file=sys.stderr)
    return 0
