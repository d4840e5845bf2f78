"""A backend that must answer: where another one keeps silent for too long, it is stopped and that is said."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any, TypeVar

from motion.errors import BackendLost, InvalidGoal
from motion.sim.backend import Backend

_Answer = TypeVar("_Answer")
_LOOK = 0.02


class Guarded:
    """Asks another backend for everything, in a thread of its own, and waits no longer than it may.

    While a phase is carried out, each time step counts as an answer. After the first silence nothing is asked any more.

    Args:
        backend: is asked.
        patience: seconds without an answer after which it counts as lost.

    Raises:
        InvalidGoal: `patience` is not above 0.
    """

    def __init__(self, backend: Backend, patience: float = 2.0) -> None:
        if not patience > 0:
            raise InvalidGoal(f"a backend is given a number of seconds above 0 to answer, not {patience!r}")
        self._backend, self._patience = backend, patience
        self._heard = time.monotonic()
        self._lost: BackendLost | None = None
        self._asking: threading.Thread | None = None

    def __getattr__(self, name: str) -> Any:
        if name == "time":
            return self._asked(name, lambda: self._backend.time)
        value = getattr(self._backend, name)
        if not callable(value):
            return value
        return lambda *args, **kwargs: self._asked(name, lambda: value(*args, **kwargs))

    def run_phase(self, arm: str, target: str | None, phase: Any, on_step: Any = None, until: Any = None) -> Any:
        """Carries out one phase; every step that is heard of counts as an answer."""
        step = self._hearing(on_step)
        return self._asked("run_phase", lambda: self._backend.run_phase(arm, target, phase, step, until))

    def hold(self, seconds: float, on_step: Any = None) -> None:
        """Lets time pass; every step that is heard of counts as an answer."""
        self._asked("hold", lambda: self._backend.hold(seconds, self._hearing(on_step)))

    def _hearing(self, on_step: Any) -> Callable[[Any], None]:
        """Called after every time step, which counts as an answer."""

        def step(backend: Any) -> None:
            self._heard = time.monotonic()
            if on_step is not None:
                on_step(backend)

        return step

    def _asked(self, name: str, ask: Callable[[], _Answer]) -> _Answer:
        """The answer.

        Raises:
            BackendLost: there was none in time, now or earlier.
        """
        if threading.current_thread() is self._asking:
            return ask()  # from within a phase
        if self._lost is not None:
            raise self._lost
        answers: list[_Answer] = []
        errors: list[BaseException] = []

        def work() -> None:
            try:
                answers.append(ask())
            except BaseException as error:  # it is raised where it was asked
                errors.append(error)

        self._heard = time.monotonic()
        self._asking = threading.Thread(target=work, daemon=True)
        self._asking.start()
        self._asking.join(_LOOK)
        while self._asking.is_alive():
            self._asking.join(_LOOK)
            if self._asking.is_alive() and time.monotonic() - self._heard > self._patience:
                self._lost = BackendLost(
                    f"the backend did not answer {name!r} within {self._patience:g} s and was told to stop", name
                )
                threading.Thread(target=self._backend.stop, daemon=True).start()
                raise self._lost
        if errors:
            raise errors[0]
        return answers[0]
