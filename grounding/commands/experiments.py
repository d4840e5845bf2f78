"""`python -m grounding experiments`: the paper's tables and figures, on any corpus."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from grounding.commands import SUMMARIES
from grounding.corpus.format import Corpus
from grounding.experiments.reading import make_folder, read_corpus
from grounding.experiments.splits import BY, Split, make_splits, parse_holdouts, world_numbers
from grounding.experiments.trial import PARSES, Settings

REFUSED = 2  # exit code where files were refused, also if the others were used
_CORPUS = "a folder of example_*.xml or a .jsonl file"


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `experiments` and those of its three verbs."""
    parser = subparsers.add_parser("experiments", help=SUMMARIES["experiments"], description=SUMMARIES["experiments"])
    verbs = parser.add_subparsers(dest="verb", metavar="VERB", required=True)

    accuracy = verbs.add_parser("accuracy", help="root and complete-tree accuracy over holdouts (Figure 5)")
    _add_common(accuracy)
    accuracy.add_argument("--splits", type=_count, default=9, metavar="N", help="splits for every holdout (default: 9)")
    accuracy.add_argument("--holdouts", type=_holdouts, default="0.2:0.8:0.05", metavar="SHARES",
                          help="first:last:step, or shares, as in 0.2,0.5 (default: 0.2:0.8:0.05)")  # fmt: skip
    accuracy.add_argument("--threshold", type=_share, default=0.75, metavar="P",
                          help="a symbol counts as found above this probability (default: 0.75)")  # fmt: skip
    accuracy.add_argument("--parse", choices=(*PARSES, "both"), default="annotated",
                          help="the annotated trees, or those of our parser, whose grammar is learned from the "
                               "training part of each split only (default: annotated)")  # fmt: skip
    accuracy.add_argument("--by", choices=(*BY, "both"), default="random",
                          help="hold out instructions at random, or all of some worlds (default: random)")  # fmt: skip
    accuracy.add_argument("--penalty", type=_positive, default=0.1, help="strength of the L2 regularisation")
    _add_inference(accuracy)
    accuracy.add_argument("--negatives", type=_whole, metavar="N",
                          help="in training, all of the space of symbols is negative in worlds of up to so many "
                               "blocks, and what is proposed in others (default: 0 for adcg and hadcg, else as "
                               "--exhaustive-blocks)")  # fmt: skip
    accuracy.add_argument("--jobs", type=_count, default=1, metavar="N", help="processes at a time (default: 1)")

    efficiency = verbs.add_parser("efficiency", help="time, evaluations and memory by number of blocks (Table I)")
    _add_common(efficiency)
    _add_inference(efficiency)
    efficiency.add_argument("--blocks", type=_counts, default="20,50,100,200", metavar="N,N,...",
                            help="sizes of composed worlds beside the corpus's (default: 20,50,100,200)")  # fmt: skip
    efficiency.add_argument("--instructions", type=_count, default=40, metavar="N",
                            help="instructions for every size of a composed world (default: 40)")  # fmt: skip
    efficiency.add_argument("--budget", type=_positive, default=60.0, metavar="SECONDS",
                            help="measure each method at each size for so long at most, one instruction at least "
                                 "(default: 60)")  # fmt: skip

    figures = verbs.add_parser("figures", help="groundings of phrases drawn over the scene (Figures 6 and 7)")
    _add_common(figures, plots=False)
    figures.add_argument("--id", action="append", metavar="ID", help="an example to draw, may be given several times "
                         "(default: those that show most)")  # fmt: skip
    figures.add_argument("--count", type=_count, default=4, metavar="N",
                         help="so many examples of the corpus, where none is named (default: 4)")  # fmt: skip


def run(args: argparse.Namespace) -> int:
    """Run the verb that was asked for."""
    verbs: dict[str, Callable[[argparse.Namespace, Corpus], None]] = {
        "accuracy": _accuracy, "efficiency": _efficiency, "figures": _figures,
    }  # fmt: skip
    corpus, whole = read_corpus(args.corpus, args.corrections, args.keep_going, _say)
    make_folder(args.output)
    verbs[args.verb](args, corpus)
    return 0 if whole else REFUSED


def _accuracy(args: argparse.Namespace, corpus: Corpus) -> None:
    from grounding.experiments.accuracy import report, run_splits, write_results
    from grounding.experiments.engines import check_engines
    from grounding.experiments.store import Store

    check_engines(args.inference)
    settings = Settings(
        args.inference, PARSES if args.parse == "both" else (args.parse,), args.threshold, args.penalty,
        exhaustive=args.exhaustive_blocks, negatives=_negatives(args),
    )  # fmt: skip
    splits: list[Split] = []
    for by in BY if args.by == "both" else (args.by,):
        splits += make_splits(corpus, by, args.holdouts, args.splits, args.seed)
    worlds = len(set(world_numbers(corpus)))
    _say(f"{len(corpus)} instructions in {worlds} worlds, {len(splits)} splits")
    store = Store(args.output / "splits", corpus, settings, args.seed)
    trials = run_splits(corpus, splits, settings, store, args.jobs, _begun)
    about = {"path": args.corpus.name, "worlds": worlds, "seed": args.seed,
             "corrections": None if args.corrections is None else args.corrections.name}  # fmt: skip
    results = write_results(args.output, corpus, trials, settings, about)
    print(report(results))
    if args.plots:
        from grounding.experiments import plots

        plots.require_matplotlib(args.output)
        for by in dict.fromkeys(split.by for split in splits):
            plots.plot_accuracy(results["records"], results["paper"], by, args.output / f"accuracy_{by}.png")
            blocks = args.output / f"accuracy_{by}_by_blocks.png"
            plots.plot_by_blocks(results["records"], by, settings.parse[0], settings.inference[0], blocks)
    _say(f"written to {args.output}")


def _efficiency(args: argparse.Namespace, corpus: Corpus) -> None:
    from grounding.experiments.efficiency import measure_efficiency, report, write_results
    from grounding.experiments.engines import check_engines

    check_engines(args.inference)
    measured = measure_efficiency(
        corpus, args.inference, args.blocks, args.exhaustive_blocks, args.instructions, args.budget, args.seed, _steps
    )
    results = write_results(args.output, corpus, measured)
    print(report(results))
    if args.plots:
        from grounding.experiments import plots

        plots.require_matplotlib(args.output)
        plots.plot_efficiency(results["costs"], results["growth"], results["paper"] is not None,
                              args.output / "efficiency.png")  # fmt: skip
    _say(f"written to {args.output}")


def _figures(args: argparse.Namespace, corpus: Corpus) -> None:
    from grounding.experiments.figures import CANDIDATES, choose, corpus_figures, own_figures
    from grounding.experiments.progress import Progress
    from grounding.experiments.sheets import draw_figure

    ids = args.id or choose(corpus, CANDIDATES * args.count)
    figures = (*corpus_figures(corpus, ids, None if args.id else args.count), *own_figures())
    progress = Progress(len(figures), "figures")
    for figure in figures:
        path = args.output / f"{figure.name}.png"
        draw_figure(figure).save(path)
        progress.step(figure.name)
        print(path)


def _negatives(args: argparse.Namespace) -> int:
    from grounding.experiments.engines import needed_negatives

    return needed_negatives(args.inference, args.exhaustive_blocks) if args.negatives is None else args.negatives


def _begun(count: int, done: int) -> Callable[[str], None]:
    if done:
        _say(f"{done} splits are done already")
    return _steps(count, "splits")


def _steps(count: int, unit: str) -> Callable[[str], None]:
    from grounding.experiments.progress import Progress

    return Progress(count, unit).step


def _add_common(parser: argparse.ArgumentParser, plots: bool = True) -> None:
    parser.add_argument("--corpus", type=Path, required=True, metavar="PATH", help=_CORPUS)
    parser.add_argument("--output", type=Path, required=True, metavar="DIR", help="where results are written")
    parser.add_argument("--corrections", type=Path, metavar="FILE", help="corrections of annotations, applied first")
    parser.add_argument("--seed", type=_whole, default=0, metavar="N", help="of all chance (default: 0)")
    parser.add_argument("--keep-going", action="store_true",
                        help="list all that is refused and use the rest; the exit code is 2 all the same")  # fmt: skip
    if plots:
        parser.add_argument("--no-plots", dest="plots", action="store_false", help="write the tables only")


def _add_inference(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--inference", type=_names, default="adcg", metavar="NAME,...",
                        help="methods, with commas between them: adcg, hadcg, dcg, hdcg, exact, g3 "
                             "(default: adcg)")  # fmt: skip
    parser.add_argument("--exhaustive-blocks", type=_count, default=12, metavar="N",
                        help="run methods other than adcg and hadcg on worlds of at most so many blocks "
                             "(default: 12)")  # fmt: skip


def _names(text: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys(name.strip() for name in text.split(",") if name.strip()))


def _count(text: str) -> int:
    value = int(text) if text.isdecimal() else 0
    if value < 1:
        raise argparse.ArgumentTypeError(f"a number from 1, not {text!r}")
    return value


def _counts(text: str) -> tuple[int, ...]:
    return tuple(_count(part.strip()) for part in text.split(",") if part.strip())


def _whole(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"a whole number from 0, not {text!r}")
    return int(text)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"a number, not {text!r}") from None


def _share(text: str) -> float:
    value = _number(text)
    if not 0 <= value < 1:
        raise argparse.ArgumentTypeError(f"a probability from 0 and below 1, not {text!r}")
    return value


def _positive(text: str) -> float:
    value = _number(text)
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"a number above 0, not {text!r}")
    return value


def _holdouts(text: str) -> tuple[float, ...]:
    try:
        return parse_holdouts(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
