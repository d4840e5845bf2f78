"""A progress bar on standard error: one line that is rewritten in a terminal, a line now and then elsewhere."""

from __future__ import annotations

import sys
import time

_CELLS = 24
_LINES = 20  # at most about so many lines where the line cannot be rewritten


class Progress:
    """Tells how far a run is and how long it will take.

    Args:
        total: steps of the run.
        unit: what a step is called, in the plural.
    """

    def __init__(self, total: int, unit: str) -> None:
        self.total, self.unit, self.done = total, unit, 0
        self._start = time.monotonic()
        self._told = 0

    def step(self, text: str = "") -> None:
        """One step is done; `text` says which."""
        self.done += 1
        last = self.done == self.total
        rewrites = sys.stderr.isatty()
        if not rewrites and not last and (self.done - self._told) * _LINES < self.total:
            return
        self._told = self.done
        filled = _CELLS * self.done // max(self.total, 1)
        bar = "#" * filled + "." * (_CELLS - filled)
        line = f"[{bar}] {self.done}/{self.total} {self.unit}, {self._time()}{f', {text}' if text else ''}"
        print(f"\r{line[:150]:<100}" if rewrites else line, end="" if rewrites and not last else "\n",
              file=sys.stderr, flush=True)  # fmt: skip

    def _time(self) -> str:
        spent = time.monotonic() - self._start
        if self.done == self.total:
            return f"took {duration(spent)}"
        return f"about {duration(spent / self.done * (self.total - self.done))} left"


def duration(seconds: float) -> str:
    """A time as people say it."""
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"
