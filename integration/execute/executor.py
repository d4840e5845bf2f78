"""The executor: words are grounded, goals are planned for, plans are carried out, and what happened is checked."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.result import Grounding
from grounding.world import World
from integration.contract.planning import Planner
from integration.contract.requests import GrounderLike, checked_arm, loaded, timed_grounding
from integration.execute.report import Report, Step
from integration.execute.session import Session
from integration.execute.stage import Watch
from motion import Fault, Sensor


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
        self._grounder = grounder
        self._arm, self._seed, self._planner = checked_arm(arm), seed, planner
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
        self._grounder = loaded(self._grounder)
        grounding, seconds = timed_grounding(self._grounder, text, world, history)
        return grounding, Step("ground", seconds)

    def execute(
        self, grounding: Grounding, world: World, watch: Watch | None = None, steps: tuple[Step, ...] = ()
    ) -> Report:
        """Carry out what was understood, in a session of its own.

        Args:
            grounding: the goals.
            world: what is around the robot.
            watch: called with the simulator after every step of physics.
            steps: what was done before, for the report.
        """
        with Session(
            world, self._grounder, arm=self._arm, seed=self._seed, planner=self._planner, faults=self._faults,
            sensor=self._sensor, watch=watch,
        ) as session:  # fmt: skip
            return session.perform(grounding, steps)
