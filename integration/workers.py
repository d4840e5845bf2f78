"""Processes that share work; Ctrl-C ends them at once, and what is finished is kept."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from types import TracebackType
from typing import Any

from grounding.errors import GroundingError
from integration.errors import IntegrationError
from motion.errors import MotionError

_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


class WorkFailed(IntegrationError):
    """A part of the work was refused where it was done, or its process died; says why."""


class Workers:
    """Runs functions on many arguments, in processes of its own where there is more than one job.

    Args:
        jobs: how many work at the same time; with one, the work is done in this process.
    """

    def __init__(self, jobs: int) -> None:
        self._jobs = jobs
        self._pool: ProcessPoolExecutor | None = None
        self._others = set(multiprocessing.active_children())

    def __enter__(self) -> Workers:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._pool is None:
            return
        if error is not None:
            for process in set(multiprocessing.active_children()) - self._others:
                process.terminate()
        self._pool.shutdown(wait=error is None, cancel_futures=True)
        self._pool = None

    def run(self, function: Callable[..., Any], tasks: Sequence[tuple[Any, ...]]) -> Iterator[tuple[int, Any]]:
        """Call a function once for each tuple of arguments.

        Args:
            function: of a module, so that other processes find it.
            tasks: its arguments.

        Yields:
            the place of a task and its result, as they are ready.

        Raises:
            WorkFailed: a call was refused, or a process died.
        """
        if self._jobs == 1 or len(tasks) < 2:
            for place, task in enumerate(tasks):
                yield place, _checked(_guarded(function, task))
            return
        pool = self._started()
        running: dict[Future[Any], int] = {}
        waiting = iter(enumerate(tasks))
        try:
            while True:
                for place, task in waiting:
                    running[pool.submit(_guarded, function, task)] = place
                    if len(running) >= 2 * self._jobs:
                        break
                if not running:
                    return
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    yield running.pop(future), _checked(future.result())
        except BrokenProcessPool:
            raise WorkFailed(
                "a process ended before its work was done; was there too little memory? The same "
                "command goes on from here, --jobs 1 needs least"
            ) from None

    def _started(self) -> ProcessPoolExecutor:
        if self._pool is None:
            for name in _THREADS:  # before numpy is imported by the processes that work
                os.environ.setdefault(name, "1")
            context = multiprocessing.get_context("spawn")
            self._pool = ProcessPoolExecutor(self._jobs, mp_context=context, initializer=_heed_no_interrupt)
        return self._pool


def _heed_no_interrupt() -> None:
    """Ctrl-C is for the process that hands out the work; it ends the others."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _guarded(function: Callable[..., Any], task: tuple[Any, ...]) -> tuple[str, Any]:
    """The result, or the refusal as plain text: not every error can be sent from process to process."""
    try:
        return "done", function(*task)
    except (GroundingError, IntegrationError, MotionError, OSError) as error:
        return "refused", str(error)


def _checked(answer: tuple[str, Any]) -> Any:
    kind, value = answer
    if kind == "refused":
        raise WorkFailed(value)
    return value
