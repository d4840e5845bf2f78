"""Who decides: how many answers stay right with readers left out, alone, or with weights that were not learned.

    python benchmarks/deciders.py SET.jsonl WORLDS.json [--json] [--rows NAME ...] [--cache DIR] [--generated N]

SET has a line for each instruction, see `benchmarks/instructions.py`. Right: the only action handles exactly what is
meant; where the right answer is another outcome, that outcome. Rows: everything; each of `READERS` left out and alone;
with equal weights or with those that were learned from shuffled answers (`benchmarks/control_weights.py`).

Weights learned from shuffled answers are kept in the user's cache, or in DIR, and learned again when texts or code have
changed. They are learned from the treebank, the free texts and N generated ones, none by default.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from control_weights import shuffled_weights
from instructions import Instruction, read_instructions

import models
from grounding.grounder import READERS, Grounder
from grounding.language.parser import Parser
from grounding.learning.beliefs import EQUAL
from grounding.model.cases import Learned
from grounding.model.storage import load_learned
from grounding.world import World

Loading = Callable[[], Learned]


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


def rows_of(readers: Sequence[str]) -> tuple[Row, ...]:
    """The rows of the report.

    Args:
        readers: all that can be left out.
    """
    others = {name: frozenset(readers) - {name} for name in readers}
    return (
        Row("all"),
        *(Row(f"without {name}", frozenset({name})) for name in readers),
        *(Row(f"only {name}", others[name]) for name in readers),
        *(Row(kind, weights=kind) for kind in ("equal", "shuffled")),
    )


class Remembering(Parser):
    """A parser that parses every text once for all rows."""

    def __init__(self, parser: Parser) -> None:
        self.parse = cache(parser.parse)  # type: ignore[method-assign]


def measured(
    rows: Iterable[Row],
    instructions: Sequence[Instruction],
    worlds: Mapping[str, World],
    weights: Mapping[str, Loading],
    parser: Parser,
    tell: Callable[[str, float], None] | None = None,
) -> dict[str, float]:
    """The share of right answers of every row.

    Args:
        rows: ways to ground.
        instructions: with the answers that are right.
        worlds: by name.
        weights: every kind of weights, loaded when the first row needs it.
        parser: from texts to trees.
        tell: told every row as it is done.
    """
    remembering = Remembering(parser)
    shares = {}
    for row in rows:
        grounder = Grounder(remembering, weights[row.weights](), without=row.without)
        right = sum(i.is_answered_by(grounder.ground(i.text, worlds[i.world], i.history)) for i in instructions)
        shares[row.name] = round(right / max(len(instructions), 1), 4)
        if tell is not None:
            tell(row.name, shares[row.name])
    return shares


def main() -> None:
    """Read a set, ground it every way, print."""
    rows = rows_of(READERS)
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
    texts = Parser.load(models.GRAMMAR)
    reading = Grounder(texts, EQUAL)
    weights: dict[str, Loading] = {
        "learned": cache(lambda: load_learned(models.BELIEFS)), "equal": lambda: EQUAL,
        "shuffled": cache(lambda: shuffled_weights(reading, args.generated, args.cache)),
    }  # fmt: skip
    chosen = [row for row in rows if args.rows is None or row.name in args.rows]
    shares = measured(chosen, instructions, worlds, weights, texts, None if args.json else _show)
    if args.json:
        print(json.dumps({"instructions": len(instructions), **shares}))


def _show(name: str, share: float) -> None:
    print(f"{name:<24}{share:.3f}", flush=True)


if __name__ == "__main__":
    main()
