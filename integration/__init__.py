"""A task executor joins grounding and motion, and checks what happened.

    from integration import Home, Pick, Place, Session, load_scene

    with Session(load_scene("four")) as session:
        report = session.do("pick up the nearest block")
        session.do(Place("b1", (0.6, -0.3, 0.736)))
        session.facts, session.held, session.world
        session.undo()

The names below are imported when they are first asked for.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from integration.contract.facts import Fact
    from integration.contract.progress import Progress
    from integration.contract.requests import Clear, Home, Pick, Place
    from integration.errors import IntegrationError, NoPlan, UsageError
    from integration.execute.executor import Executor
    from integration.execute.report import Report
    from integration.execute.session import Session
    from integration.run import load_scene

__all__ = [
    "Clear",
    "Executor",
    "Fact",
    "Home",
    "IntegrationError",
    "NoPlan",
    "Pick",
    "Place",
    "Progress",
    "Report",
    "Session",
    "UsageError",
    "load_scene",
]

_MODULES = {
    **dict.fromkeys(("Clear", "Home", "Pick", "Place"), "contract.requests"),
    **dict.fromkeys(("IntegrationError", "NoPlan", "UsageError"), "errors"),
    "Executor": "execute.executor",
    "Fact": "contract.facts",
    "Progress": "contract.progress",
    "Report": "execute.report",
    "Session": "execute.session",
    "load_scene": "run",
}


def __getattr__(name: str) -> Any:
    """The thing that one of the names stands for."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = globals()[name] = getattr(importlib.import_module(f"{__name__}.{_MODULES[name]}"), name)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
