"""Caches that threads share, and caches that each has for itself.

Values, models and descriptions are shared; they are built once and never written to again. Workspaces, in which a
computation writes its results, belong to one thread each.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import lru_cache, wraps
from typing import Any, ParamSpec, TypeVar

_Given = ParamSpec("_Given")
_Made = TypeVar("_Made")


def shared(maxsize: int) -> Callable[[Callable[_Given, _Made]], Callable[_Given, _Made]]:
    """Remembers what a function made, for all threads; while one makes something the others wait for it.

    Args:
        maxsize: so many results are remembered, those that were asked for last.
    """

    def decorated(make: Callable[_Given, _Made]) -> Callable[_Given, _Made]:
        lock = threading.RLock()
        remembered = lru_cache(maxsize=maxsize)(make)

        @wraps(make)
        def found(*args: _Given.args, **kwargs: _Given.kwargs) -> _Made:
            with lock:
                return remembered(*args, **kwargs)  # type: ignore[arg-type]

        return found

    return decorated


def per_thread(maxsize: int) -> Callable[[Callable[_Given, _Made]], Callable[_Given, _Made]]:
    """Remembers what a function made, for each thread by itself, until it ends.

    Args:
        maxsize: so many results are remembered in a thread, those that were asked for last.
    """

    def decorated(make: Callable[_Given, _Made]) -> Callable[_Given, _Made]:
        own = threading.local()

        @wraps(make)
        def found(*args: _Given.args, **kwargs: _Given.kwargs) -> _Made:
            remembered: Any = getattr(own, "remembered", None)
            if remembered is None:
                remembered = own.remembered = lru_cache(maxsize=maxsize)(make)
            return remembered(*args, **kwargs)  # type: ignore[no-any-return]

        return found

    return decorated
