"""The report of what became of an instruction: frozen, and the same for the same seed but for its timings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from grounding.result import Grounding
from grounding.world import World
from integration.execute.checks import Check
from integration.execute.incidents import Incident
from motion import PhaseRecord, Pose, RobotState

OUTCOMES = ("done", "answered", "not_grounded", "no_plan", "failed", "cancelled")
DONE, ANSWERED, NOT_GROUNDED, NO_PLAN, FAILED, CANCELLED = OUTCOMES
EXIT_CODES = {DONE: 0, ANSWERED: 0, NOT_GROUNDED: 3, NO_PLAN: 4, FAILED: 5, CANCELLED: 6}

_UNGROUNDED = {
    "ambiguous": "more than one thing could be meant; say which one",
    "no_referent": "nothing in this world is meant by these words",
    "not_understood": "the words were not understood as something to pick up, put somewhere or clear away",
}


@dataclass(frozen=True)
class Step:
    """One step of the work.

    Attributes:
        name: such as "ground", "plan pick of b3", "pregrasp".
        seconds: by the clock on the wall.
        simulated: simulated seconds, 0 for what happens outside of the simulation.
    """

    name: str
    seconds: float
    simulated: float = 0.0


@dataclass(frozen=True)
class Handled:
    """The record of what was done with one object.

    Attributes:
        action: pick, place or clear.
        object: its id.
        arm: "left" or "right".
        goal: where its centre should be at the end, x, y, z in [m].
    """

    action: str
    object: str
    arm: str
    goal: tuple[float, float, float]

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        goal = [round(value, 6) for value in self.goal]
        return {"action": self.action, "object": self.object, "arm": self.arm, "goal": goal}


@dataclass(frozen=True)
class Report:
    """The whole story of one instruction.

    Attributes:
        instruction: as it was given.
        outcome: one of `OUTCOMES`.
        message: one sentence on the outcome, for people.
        grounding: what was understood.
        world: as it was given.
        final_world: as it was observed at the end.
        seed: of all chance.
        reason: a word for programs where the outcome is not "done", else None.
        handled: what was done with which object by which arm, in order.
        steps: in order.
        checks: of the final state.
        incidents: what went wrong on the way, in order.
        state: the robot at the end, or None where it never moved.
        pictures: files that were written.
        records: what the simulator recorded of each phase, not told in JSON.
        truth: where everything really was at the end, whatever the sensor showed: for judging the executor, not told in
            JSON.
    """

    instruction: str
    outcome: str
    message: str
    grounding: Grounding
    world: World
    final_world: World
    seed: int
    reason: str | None = None
    handled: tuple[Handled, ...] = ()
    steps: tuple[Step, ...] = ()
    checks: tuple[Check, ...] = ()
    incidents: tuple[Incident, ...] = ()
    state: RobotState | None = field(default=None, repr=False)
    pictures: tuple[str, ...] = ()
    records: tuple[PhaseRecord, ...] = field(default=(), repr=False)
    truth: Mapping[str, Pose] = field(default_factory=dict, repr=False)

    @property
    def exit_code(self) -> int:
        """0 done and checked, 3 not grounded, 4 no plan, 5 executed but the check failed, 6 cancelled."""
        return EXIT_CODES[self.outcome]

    @property
    def arms(self) -> tuple[str, ...]:
        """The arms that moved, in the order of their first use."""
        return tuple(dict.fromkeys(item.arm for item in self.handled))

    def with_pictures(self, pictures: tuple[str, ...], steps: tuple[Step, ...] = ()) -> Report:
        """The same report with the files of its pictures, and the steps that they took."""
        return replace(self, pictures=pictures, steps=self.steps + steps)

    def to_json(self) -> dict[str, Any]:
        """Plain values. Everything that a clock measured is under "timings"; the rest depends on the seed alone."""
        grounding = self.grounding.to_json()
        milliseconds = grounding.pop("milliseconds")
        names = sorted({item.object for item in self.handled})
        return {
            "instruction": self.instruction,
            "outcome": self.outcome,
            "exit_code": self.exit_code,
            "message": self.message,
            "reason": self.reason,
            "grounding": grounding,
            "handled": [item.to_json() for item in self.handled],
            "arms": list(self.arms),
            "steps": [{"name": step.name, "simulated_seconds": round(step.simulated, 6)} for step in self.steps],
            "incidents": [incident.to_json() for incident in self.incidents],
            "checks": [check.to_json() for check in self.checks],
            "final_poses": {
                name: {
                    "position": [round(float(v), 6) for v in self.final_world[name].position],
                    "orientation": [round(float(v), 6) for v in self.final_world[name].orientation],
                }
                for name in names
            },
            "pictures": list(self.pictures),
            "seed": self.seed,
            "timings": {
                "grounding_milliseconds": milliseconds,
                "seconds": round(sum(step.seconds for step in self.steps), 4),
                "steps": [{"name": step.name, "seconds": round(step.seconds, 4)} for step in self.steps],
            },
        }


def ungrounded(grounding: Grounding, world: World, seed: int, steps: tuple[Step, ...]) -> Report:
    """The report where there is nothing to do."""
    if grounding.answer is not None:
        return Report(grounding.instruction, ANSWERED, grounding.answer, grounding, world, world, seed, steps=steps)
    why = grounding.outcome if grounding.outcome in _UNGROUNDED else "no_referent"
    message = grounding.question or grounding.explanation or _UNGROUNDED[why]
    return Report(grounding.instruction, NOT_GROUNDED, message, grounding, world, world, seed, why, steps=steps)
