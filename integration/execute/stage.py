"""The stage on which an instruction is carried out: one simulation, its clock, and the list of steps taken."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

import motion
from integration.contract.planning import Planner
from integration.contract.progress import Cancel, Cancelled, OnProgress, Progress, stopped
from integration.errors import NoPlan
from integration.execute.checks import HELD_FOR, drifts
from integration.execute.incidents import Incident, Trouble
from integration.execute.monitor import Monitor
from integration.execute.report import Handled, Step
from motion import (
    Backend,
    Fault,
    MakeBackend,
    MotionError,
    Phase,
    PhaseRecord,
    Plan,
    RobotState,
    Scene,
    Sensor,
    Simulator,
)

Watch = Callable[[Simulator], None]

_SETTLING = 1.0
_STABLE = 0.010
_WATCHED = 0.5
_SAMPLE = 10
_FALLING, _PAUSE = 3.0, 0.3
_FRAMES, _CAREFUL = 10, 30
_CANCELLED, _TOLD = "cancelled", 0.1  # the latter: simulated seconds between reports of progress


class Stage:
    """A simulation in progress.

    Args:
        scene: what stands around the robot.
        seed: of all chance.
        planner: where plans come from.
        watch: called after every step of physics, for videos and viewers.
        faults: what shall go wrong.
        sensor: how well blocks are seen.
        state: where the robot is at the beginning; home by default.
        backend: makes what carries plans out; a simulator by default.

    Attributes:
        simulator: where everything is.
        steps: taken so far.
        handled: what was done so far.
        incidents: what went wrong so far.
        records: of every phase that was carried out so far.
        moved: ids of objects that had to be moved for others.
    """

    def __init__(
        self,
        scene: Scene,
        seed: int,
        planner: Planner | None = None,
        watch: Watch | None = None,
        faults: Sequence[Fault] = (),
        sensor: Sensor | None = None,
        state: RobotState | None = None,
        backend: MakeBackend = Simulator,
    ) -> None:
        self.begin()
        self._watch = watch
        self._rng = np.random.default_rng(seed)
        self._sensor = Sensor() if sensor is None else sensor
        self._seeing = np.random.default_rng([seed, 1])
        self._seen: tuple[float, int, Scene] | None = None
        self._planner: Any = motion if planner is None else planner
        self._given = scene
        with self._timed("build the scene"):
            self.simulator = backend(scene, state, faults)

    def begin(self, on_progress: OnProgress | None = None, cancel: Cancel | None = None) -> None:
        """Begins with another goal: nothing was done for it so far.

        Args:
            on_progress: called while the work is done.
            cancel: tells when to stop.
        """
        self.steps: list[Step] = []
        self.handled: list[Handled] = []
        self.incidents: list[Incident] = []
        self.records: list[PhaseRecord] = []
        self.moved: set[str] = set()
        self.attend(on_progress, cancel)

    def attend(self, on_progress: OnProgress | None, cancel: Cancel | None) -> None:
        """Tells how far the work is, and heeds a wish to stop, from now on."""
        self._on_progress, self._cancel = on_progress, cancel

    def __enter__(self) -> Stage:
        return self

    def __exit__(self, *_: object) -> None:
        self.simulator.close()

    @property
    def scene(self) -> Scene:
        """Everything where it is seen now."""
        return self.look(_FRAMES)

    @property
    def doubt(self) -> float:
        """Largest error of a block's place by a careful look, in [m]."""
        return self._sensor.uncertainty(_CAREFUL)

    def look(self, frames: int) -> Scene:
        """Everything where so many frames of the sensor show it; an exact one needs none and takes no time."""
        if self._sensor.exact:
            return self.simulator.scene()
        if self._seen is None or self._seen[0] != self.simulator.time or self._seen[1] < frames:
            scene = self._sensor.look(self.simulator, self._seeing, frames)
            self._seen = self.simulator.time, frames, scene
        return self._seen[2]

    def look_carefully(self) -> Scene:
        """Everything where many frames show it."""
        return self.look(_CAREFUL)

    def note(self, kind: str, name: str, message: str, phase: str = "") -> Incident:
        """Notes an incident."""
        incident = Incident(kind, name, phase, message, self.simulator.time)
        self.incidents.append(incident)
        return incident

    def settle(self, objects: tuple[str, ...]) -> None:
        """Lets everything come to rest as the world was given.

        Raises:
            NoPlan: one of `objects` does not stay where the world says it is.
        """
        start = self.simulator.time
        with self._timed("settle") as step:
            self.simulator.settle(_SETTLING)
            step["simulated"] = self.simulator.time - start
        moved = drifts(self._given, self.scene)
        for name in objects:
            if moved.get(name, 0.0) > _STABLE:
                raise NoPlan(
                    f"{name} does not rest where the world says it is, it moved by {1000 * moved[name]:.0f} mm on its "
                    "own; a world needs a table under its objects, and none in another",
                    (name,),
                    "unstable",
                )

    def plan_pick(self, name: str, arm: str, **options: Any) -> Plan:
        """A plan to pick an object up from where everything is now.

        Raises:
            NoPlan: with motion's reason.
        """
        options = {"scene": self.scene, "start": self.simulator.state(), **options}
        scene = options.pop("scene")
        with self._planning(f"plan the pick of {name}", name):
            plan: Plan = self._planner.plan_pick(scene, name, arm=arm, rng=self._rng, **options)
        return plan

    def plan_transport(self, name: str, position: np.ndarray, arm: str, **options: Any) -> tuple[Plan, ...]:
        """Plans to set an object down, two where the hands must pass it on.

        Args:
            name: the object.
            position: of its centre, (3,) in [m], or (n, 3) of which one will do, the best first.
            arm: "left", "right" or "auto".
            options: of motion's planner.

        Raises:
            NoPlan: with motion's reason.
        """
        options = {"scene": self.scene, "start": self.simulator.state(), **options}
        scene = options.pop("scene")
        with self._planning(f"plan the place of {name}", name):
            return tuple(self._planner.plan_transport(scene, name, position, arm=arm, rng=self._rng, **options))

    def plan_unstacking(self, name: str, arm: str, keep_free: Sequence[ArrayLike] = ()) -> tuple[Plan, ...]:
        """Plans to set aside what stands on an object, from where everything is now; none where nothing does.

        Raises:
            NoPlan: with motion's reason.
        """
        scene, start = self.scene, self.simulator.state()
        with self._planning(f"plan to uncover {name}", name):
            return motion.plan_unstacking(scene, name, arm=arm, start=start, rng=self._rng, keep_free=keep_free)

    def plan_home(self, arm: str) -> Plan:
        """A plan to bring an arm home from where it is.

        Raises:
            NoPlan: with motion's reason.
        """
        with self._planning(f"plan the way home of the {arm} arm", ""):
            return motion.plan_home(self.scene, arm=arm, start=self.simulator.state(), rng=self._rng)

    def execute(self, plan: Plan, action: str, name: str) -> None:
        """Carries a plan out, watches it, and notes its phases.

        Raises:
            Trouble: something was not as planned; the arm stands still.
        """
        scene = self.scene
        self.simulator.check_start(plan)
        if plan.goal is not None:
            x, y, z = (float(value) for value in plan.goal.position)
            self.handled.append(Handled(action, name, plan.arm, (x, y, z)))
        monitor = Monitor(plan, scene, self._sensor, self._seeing, lambda: self.scene)
        before = 0.0
        for phase in plan.phases:
            self._tell(phase.name, name, before / max(plan.duration, 1e-9))
            begin = time.perf_counter()
            watching = self._stoppable(monitor.during(phase), plan, phase, name, before)
            record = self.simulator.run_phase(plan.arm, plan.target, phase, self._watch, watching)
            before += phase.duration
            self.steps.append(Step(phase.name, time.perf_counter() - begin, record.duration))
            self.records.append(record)
            if record.left == _CANCELLED:
                raise Cancelled(stopped(self.simulator, plan.arm, phase.name), phase.name)
            found = monitor.after(phase, record, self.simulator)
            if found is not None:
                kind, message = found.split(": ", 1)
                raise Trouble(self.note(kind, name, message, phase.name), plan.arm)

    def _stoppable(
        self, look: Callable[[Backend], str | None], plan: Plan, phase: Phase, name: str, before: float
    ) -> Callable[[Backend], str | None]:
        """Watches a phase, tells how far it is, and heeds a wish to stop."""
        start = told = self.simulator.time

        def watching(simulator: Backend) -> str | None:
            nonlocal told
            if self._cancel is not None and self._cancel.is_set():
                return _CANCELLED
            if simulator.time - told >= _TOLD:
                told = simulator.time
                self._tell(phase.name, name, (before + told - start) / max(plan.duration, 1e-9))
            return look(simulator)

        return watching

    def _tell(self, step: str, name: str, fraction: float) -> None:
        if self._on_progress is not None:
            self._on_progress(Progress(step, name, round(min(fraction, 1.0), 6), self.simulator.time))

    def _heed(self, step: str) -> None:
        """Stops here if that is wished.

        Raises:
            Cancelled: it is.
        """
        if self._cancel is not None and self._cancel.is_set():
            raise Cancelled(f"stopped before it could {step}; the arms stand still", step)

    def come_to_rest(self) -> None:
        """Lets what was pushed or dropped come to rest."""
        start = self.simulator.time
        with self._timed("settle") as step:
            self.simulator.hold(_PAUSE, self._watch)
            self.simulator.settle(_FALLING)
            step["simulated"] = self.simulator.time - start

    def keep_still(self, holding: Mapping[str, str]) -> Mapping[str, float]:
        """Lets two seconds pass and watches whether objects stay in hands.

        Args:
            holding: arms by the objects that they should hold.

        Returns:
            for how many seconds, up to the end, each object was in its hand without a break.
        """
        start = self.simulator.time
        since: dict[str, float | None] = dict.fromkeys(holding, start)
        count = 0

        def look(simulator: Simulator) -> None:
            nonlocal count
            count += 1
            if count % _SAMPLE == 0:
                for name, arm in holding.items():
                    kept = name in simulator.holding(arm)
                    since[name] = (since[name] if since[name] is not None else simulator.time) if kept else None
            if self._watch is not None:
                self._watch(simulator)

        with self._timed("keep still") as step:
            self.simulator.hold(HELD_FOR, look)
            step["simulated"] = self.simulator.time - start
        end = self.simulator.time
        return {name: 0.0 if begun is None else round(end - begun, 6) for name, begun in since.items()}

    def watch_rest(self) -> Mapping[str, float]:
        """Lets everything come to rest, then half a second pass; how far each object moved in the latter, in [m]."""
        start = self.simulator.time
        with self._timed("come to rest") as step:
            self.simulator.hold(_WATCHED, self._watch)
            earlier = self.look_carefully()
            self.simulator.hold(_WATCHED, self._watch)
            later = self.look_carefully()
            step["simulated"] = self.simulator.time - start
        return drifts(earlier, later)

    @contextmanager
    def _planning(self, step: str, name: str) -> Iterator[None]:
        """Notes the step of planning, tells it, and turns motion's refusals into `NoPlan`.

        Raises:
            Cancelled: it is to be stopped.
        """
        self._heed(step)
        self._tell(step, name, 0.0)
        with self._timed(step), _refusals(name):
            yield
        self._heed(step)

    @contextmanager
    def _timed(self, name: str) -> Iterator[dict[str, float]]:
        """Notes a step with its time, also where it fails."""
        simulated = {"simulated": 0.0}
        start = time.perf_counter()
        try:
            yield simulated
        finally:
            self.steps.append(Step(name, time.perf_counter() - start, simulated["simulated"]))


@contextmanager
def _refusals(name: str) -> Iterator[None]:
    """Turns motion's refusals to plan into `NoPlan`."""
    try:
        yield
    except MotionError as error:
        notes = getattr(error, "__notes__", [])
        raise NoPlan("; ".join([str(error), *notes]), (name,), type(error).__name__) from error
