"""A backend that writes down what is carried out on another, and the replay of what was written."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from motion.errors import InvalidGoal
from motion.path.trajectory import Trajectory
from motion.plan.plans import Phase, Plan
from motion.poses import Array, Pose
from motion.robot.state import ARMS, RobotState
from motion.scene import Scene
from motion.sim.backend import Backend, OnStep, Watching
from motion.sim.execution import PhaseRecord

SCHEMA = 1
_VALUES = ("positions", "velocities", "accelerations")
_NEAR = 0.02
"""So far may each joint be from where a recording begins, radians."""


class Recorder:
    """A backend that carries everything out on another one and writes each timed trajectory as a line of JSON.

    Args:
        backend: does the work.
        path: of the file, which is begun anew.

    Raises:
        OSError: the file cannot be written.
    """

    def __init__(self, backend: Backend, path: Path | str) -> None:
        self._backend = backend
        self._file = Path(path).open("w", encoding="utf-8")  # noqa: SIM115  # closed by `close`
        self._write({"schema": SCHEMA, "start": backend.state().to_json()})

    # What is written.

    def run_phase(
        self, arm: str, target: str | None, phase: Phase, on_step: OnStep | None = None, until: Watching | None = None
    ) -> PhaseRecord:
        """Carries out one phase and writes it; of one that is left, where the arm was told to be on the way."""
        commanded: list[Array] = []

        def step(backend: Any) -> None:
            commanded.append(np.array(self._backend.state().joints(arm)))
            if on_step is not None:
                on_step(backend)

        before, begun = self._backend.state().joints(arm), self._backend.time
        watched = on_step if until is None else step
        record = self._backend.run_phase(arm, target, phase, watched, until)
        trajectory = phase.trajectory
        if record.left is not None and commanded:
            trajectory = _commanded(np.array([before, *commanded]), (self._backend.time - begun) / len(commanded))
        self._write({
            "arm": arm, "target": target, "phase": phase.name, "held": phase.held, "left": record.left,
            "gripper": phase.gripper if record.left is None else record.gripper_width,
            "period": trajectory.period, "positions": trajectory.positions.tolist(),
            "velocities": trajectory.velocities.tolist(), "accelerations": trajectory.accelerations.tolist(),
        })  # fmt: skip
        return record

    def hold(self, seconds: float, on_step: OnStep | None = None) -> None:
        """Lets time pass while the robot keeps still."""
        self._backend.hold(seconds, on_step)
        self._write({"hold": seconds})

    def settle(self, seconds: float = 2.0) -> bool:
        """Lets time pass until nothing moves any more, `seconds` at most; whether nothing does."""
        begun = self._backend.time
        still = self._backend.settle(seconds)
        self._write({"hold": self._backend.time - begun})
        return still

    def close(self) -> None:
        """Ends both."""
        self._file.close()
        self._backend.close()

    # What is only passed on.

    @property
    def time(self) -> float:
        """Seconds since the beginning."""
        return self._backend.time

    def scene(self) -> Scene:
        """Everything where it is observed now."""
        return self._backend.scene()

    def poses(self) -> dict[str, Pose]:
        """The observed pose of every box, by name."""
        return self._backend.poses()

    def pose(self, name: str) -> Pose:
        """The observed pose of one box."""
        return self._backend.pose(name)

    def state(self) -> RobotState:
        """The robot, for the next plan."""
        return self._backend.state()

    def joints(self, arm: str) -> Array:
        """(7,) measured joints."""
        return self._backend.joints(arm)

    def tool_pose(self, arm: str) -> Pose:
        """The pose of a tool frame by the measured joints."""
        return self._backend.tool_pose(arm)

    def gripper_width(self, arm: str) -> float:
        """The measured opening of a gripper."""
        return self._backend.gripper_width(arm)

    def tracking_error(self, arm: str) -> float:
        """The largest deviation of a joint from where it should be."""
        return self._backend.tracking_error(arm)

    def holding(self, arm: str) -> tuple[str, ...]:
        """Names of the boxes between the fingers of an arm."""
        return self._backend.holding(arm)

    def contacts(self) -> tuple[tuple[str, str], ...]:
        """Pairs of bodies that touch now, sorted."""
        return self._backend.contacts()

    def check_start(self, plan: Plan) -> None:
        """Refuses a plan that does not begin where the robot is."""
        self._backend.check_start(plan)

    def stop(self) -> None:
        """Makes everything stand still at once."""
        self._backend.stop()

    def _write(self, data: dict[str, Any]) -> None:
        self._file.write(json.dumps(data) + "\n")
        self._file.flush()


def replay(path: Path | str, backend: Backend, on_step: OnStep | None = None) -> tuple[PhaseRecord, ...]:
    """Carries out once more what a `Recorder` wrote.

    Args:
        path: of the file.
        backend: with the robot where the recording began.
        on_step: as for `Backend.run_phase`.

    Returns:
        the record of every phase.

    Raises:
        InvalidGoal: the file is no recording, or begins with the robot elsewhere.
        OSError: the file cannot be read.
    """
    records = []
    for number, line in enumerate(_lines(Path(path)), start=1):
        try:
            if number == 1:
                _check_start(line, backend)
            elif "hold" in line:
                backend.hold(float(line["hold"]), on_step)
            else:
                values = (np.asarray(line[name], dtype=float).reshape(-1, 7) for name in _VALUES)
                trajectory = Trajectory(float(line["period"]), *values)
                phase = Phase(str(line["phase"]), trajectory, float(line["gripper"]), line["held"])
                records.append(backend.run_phase(str(line["arm"]), line["target"], phase, on_step))
        except (KeyError, TypeError, ValueError) as error:
            raise InvalidGoal(f"{path}, line {number}: not as a recorder writes it: {error!r}") from error
    return tuple(records)


def _lines(path: Path) -> Iterator[dict[str, Any]]:
    with path.open(encoding="utf-8") as file:
        for number, text in enumerate(file, start=1):
            try:
                line = json.loads(text)
            except ValueError as error:
                raise InvalidGoal(f"{path}, line {number}: expected JSON: {error}") from error
            if not isinstance(line, dict) or (number == 1 and line.get("schema") != SCHEMA):
                raise InvalidGoal(f"{path}, line {number}: expected a recording of schema {SCHEMA}")
            yield line


def _check_start(line: dict[str, Any], backend: Backend) -> None:
    """Compares where the robot is with where the recording begins."""
    state = backend.state()
    for arm in ARMS:
        gap = float(np.max(np.abs(np.asarray(line["start"][arm], dtype=float) - state.joints(arm))))
        if not gap <= _NEAR:
            raise InvalidGoal(f"the recording begins {gap:.3f} rad from where the {arm} arm is")


def _commanded(positions: Array, period: float) -> Trajectory:
    """The trajectory that an arm was told, from where it was told to be at each step."""
    velocities = np.gradient(positions, period, axis=0)
    velocities[0] = velocities[-1] = 0.0
    return Trajectory(period, positions, velocities, np.gradient(velocities, period, axis=0))
