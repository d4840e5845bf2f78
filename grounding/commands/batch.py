"""`python -m grounding batch`: many instructions from a file, results to a file, in input order."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from grounding.commands import SUMMARIES
from grounding.errors import CorpusError, CorpusErrors, LanguageError
from grounding.result import Grounding
from grounding.world import World, load_worlds

if TYPE_CHECKING:
    from grounding.grounder import Grounder

_KEYS = ("id", "world", "instruction")
_SAYS = 200  # progress is told after so many lines


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `batch`."""
    parser = subparsers.add_parser("batch", help=SUMMARIES["batch"], description=SUMMARIES["batch"])
    parser.add_argument("--worlds", type=Path, required=True, metavar="FILE", help="JSON: names to worlds")
    parser.add_argument("--input", type=Path, required=True, metavar="FILE.jsonl",
                        help='lines {"id", "world", "instruction", "history"?}')  # fmt: skip
    parser.add_argument("--output", type=Path, required=True, metavar="FILE.jsonl", help="one result a line")


def run(args: argparse.Namespace) -> int:
    """Ground every line. The output appears whole or not at all."""
    from grounding.grounder import Grounder  # loaded late: other commands do not need it

    worlds = load_worlds(args.worlds)
    lines = list(_read(args.input, worlds))
    grounder = Grounder.load()
    args.output.parent.mkdir(parents=True, exist_ok=True)
    if args.output.is_dir():
        raise CorpusError(f"{args.output}: is a folder; --output names a file")
    whole = args.output.with_name(args.output.name + ".part")
    try:
        with whole.open("w", encoding="utf-8") as output:
            for number, line in enumerate(lines, start=1):
                output.write(json.dumps({"id": line["id"], **_ground(grounder, line, worlds).to_json()}) + "\n")
                if number % _SAYS == 0 or number == len(lines):
                    end = "\n" if number == len(lines) else "\r"
                    print(f"{number} of {len(lines)} instructions", end=end, file=sys.stderr, flush=True)
        os.replace(whole, args.output)
    finally:
        whole.unlink(missing_ok=True)
    return 0


def _ground(grounder: Grounder, line: dict[str, Any], worlds: dict[str, World]) -> Grounding:
    history = tuple(str(name) for name in line.get("history") or ())
    try:
        return grounder.ground(line["instruction"], worlds[line["world"]], history)
    except LanguageError as error:
        return Grounding(line["instruction"], "not_understood", explanation=str(error))


def _read(path: Path, worlds: dict[str, World]) -> Iterator[dict[str, Any]]:
    """The input lines, checked; all that is wrong is told at once."""
    problems, lines = [], []
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise CorpusError(f"{path}: not UTF-8 text ({error})") from error
    for number, line in enumerate(text.split("\n"), start=1):  # other line separators may stand in a JSON text
        if not line.strip():
            continue
        try:
            lines.append(_checked(line, worlds))
        except CorpusError as error:
            problems.append(CorpusError(f"{path}, line {number}: {error}"))
    if problems:
        raise CorpusErrors(problems)
    yield from lines


def _checked(line: str, worlds: dict[str, World]) -> dict[str, Any]:
    try:
        data = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise CorpusError(f"no JSON ({error})") from error
    if not isinstance(data, dict):
        raise CorpusError(f"expected an object with {', '.join(_KEYS)} and found {type(data).__name__}")
    for key in _KEYS:
        if key not in data:
            raise CorpusError(f"key {key!r} is missing")
    if not isinstance(data["instruction"], str):
        raise CorpusError(f"'instruction' is a text, not {data['instruction']!r}")
    if not isinstance(data["world"], str) or data["world"] not in worlds:
        known = ", ".join(sorted(worlds)[:8])
        raise CorpusError(f"no world {data['world']!r}; the worlds file has {known}")
    if data.get("history") is not None and not isinstance(data["history"], list):
        raise CorpusError("'history' is a list of ids")
    return data
