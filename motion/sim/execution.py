"""Records of plans that were carried out, as frozen values."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class PhaseRecord:
    """The record of one phase.

    Attributes:
        name: the phase's.
        duration: simulated seconds.
        tracking_error: largest deviation of a joint from the plan, radians.
        gripper_width: measured opening at its end, metres.
        contacts: pairs of bodies that touched although neither the fingers on the target nor boxes among themselves.
        left: why the phase was left before its end, or None.
    """

    name: str
    duration: float
    tracking_error: float
    gripper_width: float
    contacts: tuple[tuple[str, str], ...]
    left: str | None = None


@dataclass(frozen=True)
class Execution:
    """The record of a plan that was carried out.

    Attributes:
        phases: in order.
        holding: names of the boxes between the fingers of the plan's arm at the end.
    """

    phases: tuple[PhaseRecord, ...]
    holding: tuple[str, ...]

    @property
    def duration(self) -> float:
        """Simulated seconds."""
        return sum(phase.duration for phase in self.phases)

    @property
    def tracking_error(self) -> float:
        """Largest deviation of a joint from the plan, radians."""
        return max((phase.tracking_error for phase in self.phases), default=0.0)

    @property
    def contacts(self) -> tuple[tuple[str, str], ...]:
        """All unintended contacts, sorted."""
        return tuple(sorted({pair for phase in self.phases for pair in phase.contacts}))
