"""Who decides: how many answers stay right with readers left out, alone, or with weights that were not learned.

    python benchmarks/deciders.py SET.jsonl WORLDS.json [--json] [--rows NAME ...] [--cache DIR] [--generated N]

SET has a line for each instruction, see `benchmarks/instructions.py`. Right: the only action handles exactly what is
meant; where the right answer is another outcome, that outcome. Rows: everything; each of `READERS` left out and alone;
the factors' weights equal or trained on shuffled answers (`benchmarks/control_weights.py`), with all readers and alone.

Weights trained on shuffled answers are kept in the user's cache, or in DIR, and trained again when the treebank or the
code that learns has changed. They are learned from the treebank and N generated examples, none by default (four
minutes); those that ship were learned from 3,000 more and from variants of the treebank's sentences.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from control_weights import equal_weights, shuffled_weights
from instructions import Instruction, read_instructions

import models
from grounding.factors import FactorModel, load_model
from grounding.grounder import READERS, Grounder
from grounding.inference import Adcg
from grounding.language.parser import Parser
from grounding.world import World

LEARNED = "factors"  # the reader that has the weights
Weights = Callable[[], FactorModel]


@dataclass(frozen=True)
class Row:
    """One way to ground: which readers are left out, and with which weights the others read.

    Attributes:
        name: key in the report.
        without: readers that are left out.
        weights: learned, equal or shuffled.
    """

    name: str
    without: frozenset[str] = frozenset()
    weights: str = "learned"


def rows_of(readers: Sequence[str], learned: str) -> tuple[Row, ...]:
    """The rows of the report.

    Args:
        readers: all that can be left out.
        learned: the one whose weights are learned.
    """
    others = {name: frozenset(readers) - {name} for name in readers}
    return (
        Row("all"),
        *(Row(f"without {name}", frozenset({name})) for name in readers),
        *(Row(f"only {name}", others[name]) for name in readers),
        *(Row(kind, weights=kind) for kind in ("equal", "shuffled")),
        *(Row(f"only {learned}, {kind}", others[learned], kind) for kind in ("equal", "shuffled")),
    )


class _Remembering(Parser):
    """A parser that parses every text once for all rows."""

    def __init__(self, parser: Parser) -> None:
        self.parse = cache(parser.parse)  # type: ignore[method-assign]


def measured(
    rows: Iterable[Row],
    instructions: Sequence[Instruction],
    worlds: Mapping[str, World],
    weights: Mapping[str, Weights],
    parser: Parser,
    tell: Callable[[str, float], None] | None = None,
) -> dict[str, float]:
    """The share of right answers of every row.

    Args:
        rows: ways to ground.
        instructions: with the answers that are right.
        worlds: by name.
        weights: the model of every kind of weights, loaded when the first row needs it.
        parser: from texts to trees.
        tell: told every row as it is done.
    """
    remembering = _Remembering(parser)
    shares = {}
    for row in rows:
        grounder = Grounder(remembering, Adcg(weights[row.weights](), beam=1), without=row.without)
        right = sum(i.is_answered_by(grounder.ground(i.text, worlds[i.world], i.history)) for i in instructions)
        shares[row.name] = round(right / max(len(instructions), 1), 4)
        if tell is not None:
            tell(row.name, shares[row.name])
    return shares


def main() -> None:
    """Read a set, ground it every way, print."""
    rows = rows_of(READERS, LEARNED)
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("set", type=Path)
    parser.add_argument("worlds", type=Path)
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    parser.add_argument("--rows", nargs="+", metavar="NAME", choices=[row.name for row in rows],
                        help="only these: " + "; ".join(row.name for row in rows))  # fmt: skip
    parser.add_argument("--cache", type=Path, metavar="DIR", help="where weights trained on shuffled answers are kept")
    parser.add_argument("--generated", type=int, default=0, metavar="N", help="examples that those learn from as well")
    args = parser.parse_args()
    instructions, worlds = read_instructions(args.set, args.worlds)
    learned = cache(lambda: load_model(models.WEIGHTS))
    shuffled = cache(lambda: shuffled_weights(args.generated, args.cache))
    weights: dict[str, Weights] = {"learned": learned, "equal": cache(lambda: equal_weights(learned())),
                                   "shuffled": shuffled}  # fmt: skip
    chosen = [row for row in rows if args.rows is None or row.name in args.rows]
    shares = measured(chosen, instructions, worlds, weights, Parser.load(models.GRAMMAR), None if args.json else _show)
    if not args.json:
        return
    report: dict[str, object] = {"instructions": len(instructions), **shares}
    if any(row.weights == "shuffled" for row in chosen):
        report["learned from"] = {"learned": learned().notes["examples"], "shuffled": shuffled().notes["examples"]}
    print(json.dumps(report))


def _show(name: str, share: float) -> None:
    print(f"{name:<24}{share:.3f}", flush=True)


if __name__ == "__main__":
    main()
