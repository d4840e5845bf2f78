"""What the command lines of `integration` share."""

from __future__ import annotations

import argparse
from typing import NoReturn

BAD_INPUT = 2
"""The exit code for bad usage, and for files that are missing or not as they should be."""


class OneLineParser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        """End the program, as argparse does, without the usage."""
        self.exit(BAD_INPUT, f"error: {message}; --help shows how it is meant\n")
