"""The executor: words are grounded, goals are planned for, plans are carried out, and what happened is checked."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Protocol

from grounding.result import GroundedAction, Grounding
from grounding.world import World
from integration.errors import NoPlan, UsageError
from integration.execute.actions import carry_out, refuse_beyond_hands
from integration.execute.checks import Check
from integration.execute.incidents import Trouble
from integration.execute.report import ANSWERED, DONE, FAILED, NO_PLAN, NOT_GROUNDED, Handled, Report, Step
from integration.execute.stage import Planner, Stage, Watch
from integration.worlds_and_scenes import scene_of, world_at
from motion import Fault, MotionError, Pose, Sensor, SimulationDiverged
from motion.robot.state import ARMS

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

_UNGROUNDED = {
    "ambiguous": "more than one thing could be meant; say which one",
    "no_referent": "nothing in this world is meant by these words",
    "not_understood": "the words were not understood as something to pick up, put somewhere or clear away",
}


class GrounderLike(Protocol):
    """Anything that turns words into goals, such as `grounding.Grounder`."""

    def ground(self, text: str, world: World, history: Sequence[str] = ()) -> Grounding:
        """The goals that the words mean in this world."""


class Executor:
    """Carries out instructions and reports success only of what it has seen.

    Args:
        grounder: from words to goals; the one with the shipped weights by default, loaded on first use.
        arm: "left", "right" or "auto" for whichever does it better.
        seed: of all chance; the same seed gives the same report, timings aside.
        planner: from goals to plans; motion by default.
        faults: what shall go wrong in the simulation.
        sensor: how well blocks are seen; exactly by default.

    Raises:
        UsageError: there is no such arm.
    """

    def __init__(
        self,
        grounder: GrounderLike | None = None,
        *,
        arm: str = "auto",
        seed: int = 0,
        planner: Planner | None = None,
        faults: Sequence[Fault] = (),
        sensor: Sensor | None = None,
    ) -> None:
        if arm not in ("auto", *ARMS):
            raise UsageError(f"there is no arm {arm!r}; there are {', '.join(ARMS)} and auto")
        self._grounder = grounder
        self._arm, self._seed, self._planner = arm, seed, planner
        self._faults, self._sensor = tuple(faults), sensor

    def run(
        self,
        text: str,
        world: World,
        history: Sequence[str] = (),
        watch: Watch | None = None,
        steps: tuple[Step, ...] = (),
    ) -> Report:
        """Ground an instruction and carry it out.

        Args:
            text: the instruction.
            world: what is around the robot.
            history: ids of the objects handled before, the latest last.
            watch: called with the simulator after every step of physics.
            steps: what was done before, for the report.

        Raises:
            LanguageError: the instruction is empty.
        """
        grounding, step = self.ground(text, world, history)
        return self.execute(grounding, world, watch, (*steps, step))

    def ground(self, text: str, world: World, history: Sequence[str] = ()) -> tuple[Grounding, Step]:
        """Grounds an instruction, and tells how long that took as a step.

        Raises:
            LanguageError: the instruction is empty.
        """
        if self._grounder is None:
            from grounding import Grounder

            self._grounder = Grounder.load()
        start = time.perf_counter()
        grounding = self._grounder.ground(text, world, history)
        return grounding, Step("ground", time.perf_counter() - start)

    def execute(
        self, grounding: Grounding, world: World, watch: Watch | None = None, steps: tuple[Step, ...] = ()
    ) -> Report:
        """Carry out what was understood.

        Args:
            grounding: the goals.
            world: what is around the robot.
            watch: called with the simulator after every step of physics.
            steps: what was done before, for the report.
        """
        if grounding.outcome != "grounded" or not grounding.actions:
            return self._ungrounded(grounding, world, steps)
        outcome, message = FAILED, ""
        reason: str | None = None
        try:
            stage = Stage(scene_of(world), self._seed, self._planner, watch, self._faults, self._sensor)
        except MotionError as error:
            return self._report(grounding, world, None, NO_PLAN, str(error), type(error).__name__, (), steps)
        with stage:
            done: list[Check] = []
            try:
                if len(grounding.actions) > 1:
                    refuse_beyond_hands(grounding.actions)
                stage.settle(tuple(name for action in grounding.actions for name in action.objects))
                for action in grounding.actions:
                    done += carry_out(stage, action, action.arm or self._arm)
                outcome, message, reason = _verdict(done, grounding.actions, stage)
            except NoPlan as error:
                outcome, message, reason = NO_PLAN, _after(stage.handled) + str(error), error.reason
            except Trouble as error:
                message, reason = f"it was stopped, because {error}", error.incident.kind
            except SimulationDiverged as error:
                message, reason = str(error), type(error).__name__
            except MotionError as error:
                message, reason = f"the plan could not be carried out: {error}", type(error).__name__
            return self._report(grounding, world, stage, outcome, message, reason, tuple(done), steps)

    def _ungrounded(self, grounding: Grounding, world: World, steps: tuple[Step, ...]) -> Report:
        """The report where there is nothing to do."""
        if grounding.answer is not None:
            return Report(grounding.instruction, ANSWERED, grounding.answer, grounding, world, world, self._seed,
                          steps=steps)  # fmt: skip
        why = grounding.outcome if grounding.outcome in _UNGROUNDED else "no_referent"
        message = grounding.question or grounding.explanation or _UNGROUNDED[why]
        return Report(
            grounding.instruction, NOT_GROUNDED, message, grounding, world, world, self._seed, why, steps=steps
        )

    def _report(
        self,
        grounding: Grounding,
        world: World,
        stage: Stage | None,
        outcome: str,
        message: str,
        reason: str | None,
        checks: tuple[Check, ...],
        steps: tuple[Step, ...],
    ) -> Report:
        """The report, with the world as it is on the stage."""
        return Report(
            instruction=grounding.instruction,
            outcome=outcome,
            message=message,
            grounding=grounding,
            world=world,
            final_world=world if stage is None else world_at(world, _seen(stage)),
            seed=self._seed,
            reason=reason,
            handled=() if stage is None else tuple(stage.handled),
            steps=steps if stage is None else steps + tuple(stage.steps),
            checks=checks,
            incidents=() if stage is None else tuple(stage.incidents),
            records=() if stage is None else tuple(stage.records),
            truth={} if stage is None else stage.simulator.poses(),
            state=None if stage is None else stage.simulator.state(),
        )


def _verdict(done: Sequence[Check], actions: Sequence[GroundedAction], stage: Stage) -> tuple[str, str, str | None]:
    """Outcome, message and reason; success only where there are checks and all of them passed."""
    broken = [check for check in done if not check.passed]
    told = "; ".join(incident.message for incident in stage.incidents if incident.kind != "check")
    if broken or not done:
        first = broken[0] if broken else None
        said = "nothing was checked" if first is None else f"it is not so that {first.meaning}"
        reason = "unchecked" if first is None else first.name
        return FAILED, f"carried out, but {said}" + (f" ({told})" if told else ""), reason
    parts = []
    for action in actions:
        names = " and ".join([", ".join(action.objects[:-1])] * (len(action.objects) > 1) + [action.objects[-1]])
        arms = list(dict.fromkeys({item.object: item.arm for item in stage.handled}[name] for name in action.objects))
        hands = f"the {arms[0]} hand" if len(arms) == 1 else "the hands, one in each"
        verb = "is" if len(action.objects) == 1 else "are"
        parts.append(
            f"{names} {verb} in {hands}" if action.action == "pick"
            else f"{names} {verb} where {'it' if verb == 'is' else 'they'} should be" if action.action == "place"
            else f"{names} {verb} out of the way"
        )  # fmt: skip
    return DONE, "; ".join(parts) + (f", although {told}" if told else ""), None


def _seen(stage: Stage) -> Mapping[str, Pose]:
    """The poses of everything as it is seen at the end."""
    return {box.name: box.pose for box in stage.look_carefully().boxes}


def _after(handled: Sequence[Handled]) -> str:
    """The things done before there was no plan, as the beginning of a sentence."""
    names = ", ".join(item.object for item in handled)
    return f"after {names} had been moved: " if names else ""
