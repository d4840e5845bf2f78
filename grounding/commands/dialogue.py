"""`python -m grounding dialogue`: a conversation; a line is an instruction, or the answer to what was asked back."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

import models
from grounding.commands import SUMMARIES
from grounding.commands.ground import describe
from grounding.errors import LanguageError
from grounding.result import Grounding
from grounding.world import load_world

_PROMPT, _ANSWER = "> ", "? "


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `dialogue`."""
    parser = subparsers.add_parser("dialogue", help=SUMMARIES["dialogue"], description=SUMMARIES["dialogue"])
    parser.add_argument("--world", type=Path, default=models.SCENES / "default.json", metavar="FILE",
                        help="world file (default: the default scene)")  # fmt: skip
    parser.add_argument(
        "--history", nargs="+", default=[], metavar="ID", help="objects handled before, the latest last"
    )
    parser.add_argument("--json", action="store_true", help="print each result as a line of JSON")


def run(args: argparse.Namespace) -> int:
    """Read lines from standard input until its end or Ctrl-C, and tell what each was taken to mean."""
    from grounding.conversation import Conversation  # loaded late: other commands do not need it
    from grounding.grounder import Grounder

    world = load_world(args.world)
    for name in args.history:
        world[name]
    conversation = Conversation(Grounder.load(), world, args.history)
    shown = sys.stdin.isatty()
    try:
        while True:
            if shown:
                print(_ANSWER if conversation.waits else _PROMPT, end="", file=sys.stderr, flush=True)
            line = sys.stdin.readline()
            if not line:
                break
            if line.strip():
                _tell(_said(conversation, line.strip()), args.json)
    except KeyboardInterrupt:
        pass
    if shown:
        print(file=sys.stderr)
    return 0


def _said(conversation: Any, text: str) -> Grounding:
    try:
        result: Grounding = conversation.say(text)
    except LanguageError as error:
        return Grounding(text, "not_understood", explanation=str(error))
    return result


def _tell(result: Grounding, as_json: bool) -> None:
    print(json.dumps(result.to_json()) if as_json else "\n".join(describe(result)), flush=True)
