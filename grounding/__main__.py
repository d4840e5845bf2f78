"""`python -m grounding COMMAND`: finds the command, runs it, and turns errors into one line and an exit code."""

from __future__ import annotations

import argparse
import gc
import importlib
import importlib.util
import os
import sys
from collections.abc import Sequence
from types import ModuleType

from grounding.commands import SUMMARIES
from grounding.errors import CorpusErrors, GroundingError

BAD_INPUT = 2
INTERRUPTED = 130  # as a shell reports SIGINT
BROKEN_PIPE = 141  # as a shell reports SIGPIPE
_OBJECTS = 100_000
"""So many new objects, and not 700, are waited for until unused ones are looked for: what is loaded at the start stays,
and looking through it again and again would take an eighth of the time of a short command."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command.

    Args:
        argv: its name and its arguments; those of the process by default.

    Returns:
        the exit code: the command's own, or 2 for bad usage and bad files, 130 after Ctrl-C, 141 when nobody reads
        the output any more.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    gc.set_threshold(_OBJECTS, *gc.get_threshold()[1:])
    try:
        parser, command = _parser(arguments)
        parsed = parser.parse_args(arguments)
        if command is None:
            parser.print_help(sys.stderr)
            return BAD_INPUT
        code = int(command.run(parsed))
        sys.stdout.flush()
        return code
    except CorpusErrors as error:
        return _refuse(*map(str, error.problems))
    except GroundingError as error:
        return _refuse(str(error))
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the interpreter flushes once more at exit
        return BROKEN_PIPE
    except OSError as error:
        return _refuse(str(error))
    except KeyboardInterrupt:
        return INTERRUPTED


def _parser(arguments: Sequence[str]) -> tuple[argparse.ArgumentParser, ModuleType | None]:
    """The parser, complete for the command that is asked for, and that command's module."""
    parser = argparse.ArgumentParser("python -m grounding", description="Words and a world become symbolic goals.")
    subparsers = parser.add_subparsers(dest="command", metavar="COMMAND")
    asked = next((argument for argument in arguments if not argument.startswith("-")), None)
    module = None
    for name, summary in SUMMARIES.items():
        place = f"grounding.commands.{name}"
        if importlib.util.find_spec(place) is None:
            continue
        if name == asked:
            module = importlib.import_module(place)
            module.add_arguments(subparsers)
        else:
            subparsers.add_parser(name, help=summary)
    return parser, module


def _refuse(*messages: str) -> int:
    for message in messages:
        print(f"error: {' '.join(message.split())}", file=sys.stderr)
    return BAD_INPUT


if __name__ == "__main__":
    code = main()
    gc.freeze()  # what is left goes with the process: nothing need be looked through on the way out
    sys.exit(code)
