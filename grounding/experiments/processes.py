"""Work in fresh processes, several at a time: the memory that each needs is its own.

Every task gets a process that has done nothing before. Results come back as they are ready.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from multiprocessing.connection import Connection, wait
from typing import Any, NamedTuple

from grounding.errors import GroundingError
from grounding.experiments.errors import ExperimentError

_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")  # one a process, unless the user says more


class Task(NamedTuple):
    """One call in a process of its own.

    Attributes:
        name: told where it fails.
        function: found by its module and name.
        arguments: pickled.
    """

    name: str
    function: Callable[..., Any]
    arguments: tuple[Any, ...]


def in_processes(tasks: Sequence[Task], jobs: int = 1, preload: Sequence[str] = ()) -> Iterator[tuple[int, Any]]:
    """Run tasks, at most `jobs` at a time.

    Args:
        tasks: what to run.
        jobs: processes at a time.
        preload: modules that are imported once, before processes are forked, where the system can.

    Yields:
        the place of a task in `tasks` and its result, as they are ready.

    Raises:
        ExperimentError: a task failed or its process died; the others are ended.
    """
    context = _context(preload)
    waiting = list(enumerate(tasks))[::-1]
    running: dict[Connection, tuple[int, Any]] = {}
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                place, task = waiting.pop()
                receiver, sender = context.Pipe(duplex=False)
                process = context.Process(target=_call, args=(sender, task.function, task.arguments), daemon=True)
                with _interrupts(deferred=True):
                    process.start()
                    sender.close()
                    running[receiver] = (place, process)
            for ready in wait(list(running)):
                assert isinstance(ready, Connection)
                place, process = running[ready]
                result = _receive(ready, process, tasks[place].name)
                del running[ready]
                yield place, result
    finally:
        for _, process in running.values():
            process.terminate()
        for _, process in running.values():
            process.join()


def peak_memory() -> float | None:
    """The most memory that this process has had at any time, in [MB]; None where the system does not tell."""
    try:
        import resource
    except ImportError:
        return None
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1e6 if sys.platform == "darwin" else 1e3)


def _context(preload: Sequence[str]) -> Any:
    for name in _THREADS:
        os.environ.setdefault(name, "1")
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    from multiprocessing import forkserver  # not everywhere

    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(list(preload))
    with _interrupts(deferred=False):  # the server inherits that it is not to heed them
        forkserver.ensure_running()
    return context


@contextmanager
def _interrupts(deferred: bool) -> Iterator[None]:
    """Ctrl-C waits until the end, so that no process is left half begun, or is not heeded at all."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    seen: list[int] = []
    before = signal.signal(signal.SIGINT, (lambda number, _: seen.append(number)) if deferred else signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if seen:
            raise KeyboardInterrupt


def _receive(ready: Connection, process: Any, name: str) -> Any:
    try:
        kind, value = ready.recv()
    except EOFError:
        process.join()
        raise ExperimentError(f"{name}: its process ended with exit code {process.exitcode} before it was done; "
                              "was there too little memory?") from None  # fmt: skip
    process.join()
    if kind == "refused":
        raise ExperimentError(f"{name}: {value}")
    if kind == "failed":
        raise RuntimeError(f"{name} failed in its process:\n{value}")
    return value


def _call(sender: Connection, function: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's to heed
    try:
        answer: tuple[str, Any] = ("done", function(*arguments))
    except GroundingError as error:
        answer = ("refused", str(error))
    except Exception:
        answer = ("failed", traceback.format_exc())
    sender.send(answer)
    sender.close()
