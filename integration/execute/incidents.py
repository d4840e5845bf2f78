"""Incidents: what went wrong while a plan was carried out, as it was noticed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from integration.errors import IntegrationError

KINDS = ("moved", "gripper", "missed", "slipped", "tracking", "leaning", "covered", "hemmed", "bystander", "check",
         "plan")  # fmt: skip


@dataclass(frozen=True)
class Incident:
    """Something that was not as planned.

    Attributes:
        kind: "moved" (the block was not where it had been), "gripper" (it did not open or close as told), "missed" (the
            fingers closed on nothing), "slipped" (what was held was lost, or turned in the hand), "tracking" (the arm
            was not where it should be), "leaning" (another block leans on the one that is meant), "covered" (another
            block stood on it), "hemmed" (another block kept the hand from it), "bystander" (another block was moved),
            "check" (the end was not as it should be) or "plan" (there was no further plan).
        object: id of the object it is about.
        phase: of the plan, or "" after its end.
        message: what was noticed, for people.
        seconds: simulated, since the beginning.
    """

    kind: str
    object: str
    phase: str
    message: str
    seconds: float

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "kind": self.kind,
            "object": self.object,
            "phase": self.phase,
            "message": self.message,
            "seconds": round(self.seconds, 4),
        }


class Trouble(IntegrationError):
    """A plan was left because something was not as planned.

    Attributes:
        incident: what was noticed.
        arm: the arm that moved.
    """

    def __init__(self, incident: Incident, arm: str) -> None:
        self.incident, self.arm = incident, arm
        super().__init__(incident.message)
