"""The time that planning may take."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator
from numbers import Real
from typing import TypeVar

from motion.errors import InvalidGoal, OutOfTime

BUDGET = 10.0
"""Processor time that a plan may take unless more is allowed, seconds."""
_Item = TypeVar("_Item")


class Budget:
    """Processor time of this thread that is left, from now on.

    Args:
        seconds: in all; infinite for as long as it takes.
        target: name of the box that is planned for.

    Raises:
        InvalidGoal: `seconds` is no number above 0.
    """

    def __init__(self, seconds: float, target: str) -> None:
        if not isinstance(seconds, Real) or math.isnan(seconds) or seconds <= 0:
            raise InvalidGoal(f"a budget is a number of seconds above 0, not {seconds!r}", target)
        self._seconds: float = float(seconds)
        self._target: str = target
        self._end: float = time.thread_time() + self._seconds

    def check(self) -> None:
        """Ends planning when the time is over.

        Raises:
            OutOfTime: it is.
        """
        if time.thread_time() > self._end:
            raise OutOfTime(
                f"no plan for {self._target!r} was found within {self._seconds:g} s of processor time; a larger budget "
                "may help",
                self._seconds,
            )

    def spend(self, items: Iterable[_Item]) -> Iterator[_Item]:
        """The items, for as long as there is time.

        Raises:
            OutOfTime: it is over.
        """
        for item in items:
            self.check()
            yield item
