"""The contract of a planner: from goals to plans."""

from __future__ import annotations

from typing import Any, Protocol

from motion import Plan, Scene


class Planner(Protocol):
    """Anything that plans motions; the package `motion` is one."""

    def plan_pick(self, scene: Scene, target: str, **options: Any) -> Plan:
        """A plan that ends with the box in the hand."""

    def plan_transport(self, scene: Scene, target: str, position: Any, **options: Any) -> tuple[Plan, ...]:
        """Plans, one or two, that end with the box at `position` and the arms at home."""
