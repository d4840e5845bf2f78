"""Ctrl-C that is not lost: compiled modules that are being imported may swallow the exception it raises."""

from __future__ import annotations

import signal
import threading
from types import FrameType, TracebackType
from typing import Any


class Interrupts:
    """While entered, remembers every SIGINT besides raising KeyboardInterrupt as Python does."""

    def __init__(self) -> None:
        self.seen = False
        self._before: Any = None

    def __enter__(self) -> Interrupts:
        if threading.current_thread() is threading.main_thread():
            self._before = signal.signal(signal.SIGINT, self._interrupted)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)

    def heed(self) -> None:
        """Stop here if there was a SIGINT that something swallowed.

        Raises:
            KeyboardInterrupt: there was one.
        """
        if self.seen:
            raise KeyboardInterrupt

    def _interrupted(self, number: int, frame: FrameType | None) -> None:
        self.seen = True
        raise KeyboardInterrupt
