"""`python -m motion COMMAND`: finds the command, runs it, and turns errors into one line and an exit code."""

from __future__ import annotations

import argparse
import importlib
import os
import sys
from collections.abc import Sequence
from types import ModuleType

from motion.commands import SUMMARIES

BAD_INPUT = 2
UNREACHABLE = 4  # as `integration.run` says that there is no plan
INTERRUPTED = 130  # as a shell reports SIGINT
BROKEN_PIPE = 141  # as a shell reports SIGPIPE


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command.

    Args:
        argv: its name and its arguments; those of the process by default.

    Returns:
        the exit code: the command's own, or 2 for bad usage and bad files, 4 for what is out of reach, 130 after
        Ctrl-C, 141 when nobody reads the output any more.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    try:
        parser, command = _parser(arguments)
        parsed = parser.parse_args(arguments)
        if command is None:
            parser.print_help(sys.stderr)
            return BAD_INPUT
        from motion.errors import GraspUnavailable, MotionError, UnreachableTarget

        try:
            code = int(command.run(parsed))
            sys.stdout.flush()
            return code
        except (UnreachableTarget, GraspUnavailable) as error:
            return _refuse(error, UNREACHABLE)
        except MotionError as error:
            return _refuse(error, BAD_INPUT)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the interpreter flushes once more at exit
        return BROKEN_PIPE
    except OSError as error:
        return _refuse(error, BAD_INPUT)
    except KeyboardInterrupt:
        return INTERRUPTED


def _parser(arguments: Sequence[str]) -> tuple[argparse.ArgumentParser, ModuleType | None]:
    """The parser, complete for the command that is asked for, and that command's module."""
    parser = argparse.ArgumentParser("python -m motion", description="Metric goals become plans, and plans physics.")
    subparsers = parser.add_subparsers(dest="command", metavar="COMMAND")
    asked = next((argument for argument in arguments if not argument.startswith("-")), None)
    module = None
    for name, summary in SUMMARIES.items():
        if name == asked:
            module = importlib.import_module(f"motion.commands.{name}")
            module.add_arguments(subparsers)
        else:
            subparsers.add_parser(name, help=summary)
    return parser, module


def _refuse(error: Exception, code: int) -> int:
    print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
