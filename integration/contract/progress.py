"""Progress of the work, and stopping it from outside."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

from integration.errors import IntegrationError
from motion import Backend


class Progress(NamedTuple):
    """Progress of the work.

    Attributes:
        step: such as "plan the pick of b3", "pregrasp", "keep still".
        object: id of what it is about, or "".
        fraction: of the plan that is carried out, 0 to 1; 0 while there is none.
        simulated: seconds since the simulation began.
    """

    step: str
    object: str
    fraction: float
    simulated: float


OnProgress = Callable[[Progress], None]


class Cancel(Protocol):
    """Tells whether to stop; a `threading.Event` is one."""

    def is_set(self) -> bool:
        """True from the moment on at which the work is to be stopped."""


class Cancelled(IntegrationError):
    """The work was stopped from outside; the arms stand still.

    Attributes:
        step: during which.
    """

    def __init__(self, message: str, step: str) -> None:
        self.step = step
        super().__init__(message)


def stopped(backend: Backend, arm: str, phase: str) -> str:
    """A sentence on where an arm was stopped and what it holds."""
    x, y, z = backend.tool_pose(arm).position
    held = backend.holding(arm)
    holding = f" with {', '.join(held)} in its hand" if held else ""
    return f"stopped during {phase}; the {arm} arm stands still at ({x:.3f}, {y:.3f}, {z:.3f}){holding}"
