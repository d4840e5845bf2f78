"""A session: one robot and one world, and many goals, one after the other; what is held stays held."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from grounding.result import GroundedAction, Grounding
from grounding.world import World
from integration.contract.facts import Fact, facts_of
from integration.contract.planning import Planner
from integration.contract.progress import Cancel, Cancelled, OnProgress
from integration.contract.requests import Goal, GrounderLike, Home, checked_arm, grounded, loaded, timed_grounding
from integration.contract.saving import Saved, read_session, write_session
from integration.errors import NoPlan, UsageError
from integration.execute.actions import after_moving, carry_out, refuse_beyond_hands, verdict
from integration.execute.checks import Check, at_home
from integration.execute.incidents import Trouble
from integration.execute.report import CANCELLED, DONE, FAILED, NO_PLAN, Report, Step, ungrounded
from integration.execute.stage import Stage, Watch
from integration.execute.undoing import displaced, move_back
from integration.worlds_and_scenes import scene_of, world_at
from motion import BackendLost, Fault, MakeBackend, MotionError, RobotState, Sensor, SimulationDiverged, Simulator
from motion.robot.state import ARMS

Work = Callable[[Stage], tuple[Check, ...]]


class Session:
    """One simulation of a robot in a world, which lives from goal to goal.

    It belongs to one thread at a time; sessions of their own may run in as many threads as there are.

    Args:
        world: what is around the robot.
        grounder: from words to goals; the one with the shipped weights by default, loaded on first use.
        arm: "left", "right" or "auto" for whichever does it better.
        seed: of all chance; the same seed and the same goals give the same reports, timings aside.
        planner: from goals to plans; motion by default.
        faults: what shall go wrong in the simulation.
        sensor: how well blocks are seen; exactly by default.
        state: where the robot is at the beginning, and what it holds; home with empty hands by default.
        watch: called with the backend after every time step.
        backend: makes what carries plans out, from a scene, a state and faults; a simulator by default.

    Raises:
        UsageError: there is no such arm.
    """

    def __init__(
        self,
        world: World,
        grounder: GrounderLike | None = None,
        *,
        arm: str = "auto",
        seed: int = 0,
        planner: Planner | None = None,
        faults: Sequence[Fault] = (),
        sensor: Sensor | None = None,
        state: RobotState | None = None,
        watch: Watch | None = None,
        backend: MakeBackend = Simulator,
    ) -> None:
        self._arm, self._seed, self._planner = checked_arm(arm), seed, planner
        self._grounder, self._faults, self._sensor = grounder, tuple(faults), sensor
        self._world, self._state, self._watch, self._backend = world, state, watch, backend
        self._stage: Stage | None = None
        self._settled = state is not None
        self._closed = False
        self._history: tuple[str, ...] = ()
        self._before: list[tuple[World, Mapping[str, str]]] = []

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the session and gives its memory back."""
        self._closed = True
        if self._stage is not None:
            self._stage.simulator.close()
            self._stage = None

    # What can be seen.

    @property
    def world(self) -> World:
        """The world as it is observed now."""
        return self._world

    @property
    def state(self) -> RobotState:
        """The robot as it is now."""
        if self._stage is not None:
            return self._stage.simulator.state()
        return RobotState.home() if self._state is None else self._state

    @property
    def held(self) -> Mapping[str, str]:
        """Ids of what hands hold, by arm."""
        return self.state.held

    @property
    def facts(self) -> tuple[Fact, ...]:
        """Facts that hold now, for symbolic planners."""
        return facts_of(scene_of(self._world), self.held)

    @property
    def history(self) -> tuple[str, ...]:
        """Ids of the objects handled so far, the latest last."""
        return self._history

    @property
    def can_undo(self) -> bool:
        """True while a goal has moved something that was not moved back."""
        return bool(self._before)

    # What can be done.

    def do(self, goal: Goal | str, on_progress: OnProgress | None = None, cancel: Cancel | None = None) -> Report:
        """Do what a goal or a text says, and check it.

        Args:
            goal: `Pick`, `Place`, `Clear` or `Home`, or words.
            on_progress: called while it is done.
            cancel: tells when to stop, such as a `threading.Event`, from whatever thread: the arm brakes within its
                limits, and what is asked next follows from there.

        Raises:
            UsageError: the session is closed, or the goal is none.
            LanguageError: the text is empty.
        """
        self._check_open()
        if isinstance(goal, Home):
            return self._done(grounded(goal), lambda stage: _home(stage, goal), (), on_progress, cancel)
        if not isinstance(goal, str):
            return self.perform(grounded(goal), (), on_progress, cancel)
        grounding, step = self.ground(goal)
        return self.perform(grounding, (step,), on_progress, cancel)

    def ground(self, text: str) -> tuple[Grounding, Step]:
        """The meaning of a text here and now, without doing it, and how long that took as a step.

        Raises:
            LanguageError: the text is empty.
        """
        self._grounder = loaded(self._grounder)
        grounding, seconds = timed_grounding(self._grounder, text, self._world, self._history)
        return grounding, Step("ground", seconds)

    def perform(
        self,
        grounding: Grounding,
        steps: tuple[Step, ...] = (),
        on_progress: OnProgress | None = None,
        cancel: Cancel | None = None,
    ) -> Report:
        """Carry out what was understood.

        Args:
            grounding: the goals.
            steps: what was done before, for the report.
            on_progress: as for `do`.
            cancel: as for `do`.

        Raises:
            UsageError: the session is closed.
        """
        self._check_open()
        if grounding.outcome != "grounded" or not grounding.actions:
            return ungrounded(grounding, self._world, self._seed, steps)

        def work(stage: Stage) -> tuple[Check, ...]:
            if len(grounding.actions) > 1:
                refuse_beyond_hands(grounding.actions)
            if not self._settled:
                stage.settle(tuple(name for action in grounding.actions for name in action.objects))
                self._settled = True
            done: tuple[Check, ...] = ()
            for action in grounding.actions:
                done += carry_out(stage, action, action.arm or self._arm)
            return done

        return self._done(grounding, work, steps, on_progress, cancel)

    def _done(
        self,
        grounding: Grounding,
        work: Work,
        steps: tuple[Step, ...],
        on_progress: OnProgress | None,
        cancel: Cancel | None,
    ) -> Report:
        """Does some work, and remembers what was handled and what was before."""
        before = self._world, dict(self.held)
        report = self._tried(grounding, work, steps, on_progress, cancel)
        if displaced(scene_of(self._world), scene_of(before[0]), self.held, before[1]):
            self._before.append(before)
        self._history += tuple(dict.fromkeys(item.object for item in report.handled))
        return report

    def undo(self, on_progress: OnProgress | None = None, cancel: Cancel | None = None) -> Report:
        """Move everything back to where it was before the last goal that moved anything.

        Args:
            on_progress: as for `do`.
            cancel: as for `do`.

        Raises:
            UsageError: the session is closed, or nothing was done that could be undone.
        """
        self._check_open()
        if not self._before:
            raise UsageError("there is nothing to undo: no goal of this session has moved anything")
        world, held = self._before[-1]
        names = displaced(scene_of(self._world), scene_of(world), self.held, held)
        grounding = Grounding("undo", "grounded", (GroundedAction("place", names, 1.0),))
        report = self._tried(
            grounding, lambda stage: move_back(stage, scene_of(world), held, self._arm), (), on_progress, cancel
        )
        if report.outcome == DONE:
            self._before.pop()
        return report

    def save(self, path: str | Path) -> None:
        """Write the session to a file, from which `load` goes on.

        Raises:
            UsageError: the session is closed.
            OSError: the file cannot be written.
        """
        self._check_open()
        write_session(Path(path), Saved(self._world, self.state, self._history, self._seed, tuple(self._before)))

    @classmethod
    def load(
        cls,
        path: str | Path,
        grounder: GrounderLike | None = None,
        *,
        arm: str = "auto",
        planner: Planner | None = None,
        sensor: Sensor | None = None,
        watch: Watch | None = None,
    ) -> Session:
        """A session that goes on from where one was saved.

        Raises:
            UsageError: the file is no session; says what is wrong with it.
            OSError: the file cannot be read.
        """
        saved = read_session(Path(path))
        session = cls(
            saved.world, grounder, arm=arm, seed=saved.seed, planner=planner, sensor=sensor, state=saved.state,
            watch=watch,
        )  # fmt: skip
        session._history, session._before = saved.history, list(saved.before)
        return session

    def _check_open(self) -> None:
        if self._closed:
            raise UsageError("this session was closed; begin another one, or load what it saved")

    def _tried(
        self,
        grounding: Grounding,
        work: Work,
        steps: tuple[Step, ...],
        on_progress: OnProgress | None,
        cancel: Cancel | None,
    ) -> Report:
        """Does some work on the stage and reports it, whatever comes of it."""
        world = self._world
        try:
            stage = self._staged(on_progress, cancel)
        except MotionError as error:
            return self._report(grounding, world, None, NO_PLAN, str(error), type(error).__name__, (), steps)
        done: tuple[Check, ...] = ()
        outcome, message, reason = FAILED, "", None
        try:
            done = work(stage)
            outcome, message, reason = verdict(done, grounding.actions, stage)
        except Cancelled as stop:
            outcome, message, reason = CANCELLED, str(stop), stop.step
        except NoPlan as error:
            outcome, message, reason = NO_PLAN, after_moving(stage.handled) + str(error), error.reason
        except Trouble as error:
            message, reason = f"it was stopped, because {error}", error.incident.kind
        except SimulationDiverged as error:
            message, reason = str(error), type(error).__name__
        except BackendLost as error:  # nothing more can be asked
            self._stage, self._closed = None, True
            return self._report(grounding, world, None, FAILED, str(error), type(error).__name__, (), steps)
        except MotionError as error:
            message, reason = f"the plan could not be carried out: {error}", type(error).__name__
        report = self._report(grounding, world, stage, outcome, message, reason, done, steps)
        self._world = report.final_world
        return report

    def _staged(self, on_progress: OnProgress | None, cancel: Cancel | None) -> Stage:
        """The stage, ready for another goal."""
        if self._stage is None:
            self._stage = Stage(
                scene_of(self._world), self._seed, self._planner, self._watch, self._faults, self._sensor, self._state,
                self._backend,
            )  # fmt: skip
            self._stage.attend(on_progress, cancel)
        else:
            self._stage.begin(on_progress, cancel)
        return self._stage

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
            final_world=world if stage is None else world_at(world, stage.look_carefully().poses),
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


def _home(stage: Stage, goal: Home) -> tuple[Check, ...]:
    """Brings arms home."""
    arms = ARMS if goal.arm is None else (goal.arm,)
    for arm in arms:
        stage.execute(stage.plan_home(arm), "home", "")
    return tuple(at_home(arm, stage.simulator.joints(arm)) for arm in arms)
