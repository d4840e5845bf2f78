"""Numbers on the command line: finite, and where need be positive."""

from __future__ import annotations

import argparse
import math


def finite(text: str) -> float:
    """A finite number, or the parser's own complaint."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def positive(text: str) -> float:
    """A finite number above 0."""
    value = finite(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not above 0")
    return value
