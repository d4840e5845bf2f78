"""Parts that the command lines of `integration` share: bad usage told in a line, exit codes, numbers."""

from __future__ import annotations

import argparse
from typing import NoReturn

BAD_INPUT = 2
"""The exit code for bad usage, and for files that are missing or not as they should be."""
INTERRUPTED = 130
"""The exit code after Ctrl-C, as a shell reports SIGINT."""
_DIGITS = 9


class OneLineParser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        """End the program, as argparse does, without the usage."""
        self.exit(BAD_INPUT, f"error: {message}; --help shows how it is meant\n")


def whole_number(text: str) -> int:
    """A whole number from 0 on, or the parser's own complaint."""
    if not (text.isascii() and text.isdecimal()) or len(text) > _DIGITS:
        raise argparse.ArgumentTypeError(f"{text[:40]!r} is not a whole number from 0 on, of at most nine digits")
    return int(text)


def positive_number(text: str) -> int:
    """A whole number above 0, or the parser's own complaint."""
    value = whole_number(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number above 0")
    return value
