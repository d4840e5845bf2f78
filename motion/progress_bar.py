"""A progress bar on standard error: drawn in place on a terminal, a few plain lines elsewhere."""

from __future__ import annotations

import sys
from typing import TextIO


class ProgressBar:
    """Counts steps of known number.

    Args:
        title: what is being done.
        steps: how many steps there are.
        stream: where to write; standard error by default.
    """

    def __init__(self, title: str, steps: int, stream: TextIO | None = None) -> None:
        self._title, self._steps, self._done = title, max(steps, 1), 0
        self._stream = sys.stderr if stream is None else stream
        self._terminal = bool(getattr(self._stream, "isatty", lambda: False)())
        if not self._terminal:
            self._write(f"{title} (once; kept in the cache) ...\n")
        else:
            self._draw("")

    def step(self, label: str = "") -> None:
        """One step is done."""
        self._done += 1
        if self._terminal:
            self._draw(label)

    def close(self) -> None:
        """Ends the bar's line."""
        if self._terminal:
            self._draw("done")
            self._write("\n")
        else:
            self._write(f"{self._title}: done\n")

    def _draw(self, label: str) -> None:
        filled = round(30 * min(self._done / self._steps, 1))
        bar = "#" * filled + "." * (30 - filled)
        self._write(f"\r{self._title} [{bar}] {self._done}/{self._steps} {label[:24]:<24}")

    def _write(self, text: str) -> None:
        try:
            self._stream.write(text)
            self._stream.flush()
        except (OSError, ValueError):
            pass
