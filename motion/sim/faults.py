"""Faults that can be injected into a simulation: a grip that is lost, a box that is pushed, a gripper that is stuck.

Each is a frozen value that says when it happens and what; `Injector` carries them out beside the physics. What looks at
the world learns of them only by what can be observed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from motion.errors import InvalidGoal
from motion.robot.recipe import recipe


@dataclass(frozen=True)
class Slip:
    """The fingers lose what they hold, once: they open and close again.

    Attributes:
        phase: the phase in which it happens, such as "lift" or "transfer".
        share: of the phase's duration that has passed then, in [0, 1].
        seconds: for how long the fingers open.
    """

    phase: str = "lift"
    share: float = 0.5
    seconds: float = 0.3


@dataclass(frozen=True)
class Push:
    """A box is moved along what it stands on, once, unless a hand holds it.

    Attributes:
        target: name of the box.
        offset: by how much, x and y in metres.
        turn: by how much it is turned about the vertical, radians.
        phase: the phase in which it happens, such as "pregrasp" or "approach".
        share: of the phase's duration that has passed then, in [0, 1].
        seconds: how long the push takes.
    """

    target: str
    offset: tuple[float, float]
    turn: float = 0.0
    phase: str = "pregrasp"
    share: float = 0.5
    seconds: float = 0.25


@dataclass(frozen=True)
class Jam:
    """A gripper is stuck: its opening stays between two bounds whatever it is told.

    Attributes:
        arm: "left" or "right".
        least: it does not close below this, metres.
        most: it does not open beyond this, metres.
        phase: the phase with which it begins for the first time.
        seconds: how long it lasts; infinite by default.
    """

    arm: str
    least: float = 0.0
    most: float = np.inf
    phase: str = "close"
    seconds: float = np.inf


Fault = Slip | Push | Jam


class Injector:
    """Carries faults out while a simulation runs.

    Args:
        faults: what shall happen.
        boxes: names of the loose boxes there are.

    Raises:
        InvalidGoal: a fault names a box or an arm that there is not.
    """

    def __init__(self, faults: Sequence[Fault], boxes: Sequence[str]) -> None:
        for fault in faults:
            if isinstance(fault, Push) and fault.target not in boxes:
                raise InvalidGoal(
                    f"a push of {fault.target!r}, but the loose boxes are {', '.join(boxes)}", fault.target
                )
            if isinstance(fault, Jam) and fault.arm not in ("left", "right"):
                raise InvalidGoal(f"a jam of the arm {fault.arm!r}; there are 'left' and 'right'")
        self._waiting = list(faults)
        self._begun: list[tuple[Fault, str, float]] = []

    @property
    def waiting(self) -> bool:
        """True if there are faults that have not begun yet."""
        return bool(self._waiting)

    @property
    def happened(self) -> tuple[Fault, ...]:
        """The faults that have begun, in that order."""
        return tuple(fault for fault, _, _ in self._begun)

    def begin(self, arm: str, phase: str, share: float, time: float, held: Sequence[str]) -> None:
        """Begins what is due.

        Args:
            arm: the arm that moves.
            phase: the phase it is in.
            share: of the phase's duration that has passed.
            time: simulated seconds.
            held: names of the boxes in that arm's hand.
        """
        for fault in list(self._waiting):
            due = fault.phase == phase and (isinstance(fault, Jam) or share >= fault.share)
            if isinstance(fault, Slip):
                due = due and bool(held)
            elif isinstance(fault, Push):
                due = due and fault.target not in held
            elif fault.arm != arm:
                due = False
            if due:
                self._waiting.remove(fault)
                self._begun.append((fault, arm, time))

    def width(self, arm: str, commanded: float, time: float) -> float:
        """The opening that a gripper gets, in metres, where it was told to have `commanded`."""
        for fault, side, begun in self._begun:
            if isinstance(fault, Slip) and side == arm and time < begun + fault.seconds:
                return recipe().gripper.opened
            if isinstance(fault, Jam) and fault.arm == arm and time < begun + fault.seconds:
                return float(np.clip(commanded, fault.least, max(fault.most, fault.least)))
        return commanded

    def push(self, indices: Any, data: Any, step: float) -> None:
        """Moves what is being pushed by one time step of `step` seconds."""
        for fault, _, begun in self._begun:
            if isinstance(fault, Push) and data.time < begun + fault.seconds:
                start, dof = indices.box_qpos[fault.target], indices.box_dof[fault.target]
                data.qpos[start : start + 2] += np.array(fault.offset) * step / fault.seconds
                half = fault.turn * step / fault.seconds / 2
                w, x, y, z = data.qpos[start + 3 : start + 7]
                c, s = np.cos(half), np.sin(half)
                data.qpos[start + 3 : start + 7] = c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w
                data.qvel[dof : dof + 6] = 0.0
