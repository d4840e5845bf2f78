"""Physics: the robot and the boxes in MuJoCo, plans that are carried out there, and what can be observed."""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any

import numpy as np

from motion.collision.scene_model import scene_model
from motion.errors import InvalidGoal, SimulationDiverged
from motion.path.resampling import resampled_in_time
from motion.physics_engine import mujoco
from motion.plan.plans import Phase, Plan
from motion.poses import Array, Pose
from motion.robot.load import load_robot
from motion.robot.recipe import recipe
from motion.robot.state import ARMS, RobotState
from motion.scene import Scene
from motion.sim.braking import braked
from motion.sim.contacts import Pair, between_fingers, touching_pairs, unintended_pairs
from motion.sim.controller import Controller
from motion.sim.execution import Execution, PhaseRecord
from motion.sim.faults import Fault, Injector, Push

_START_TOLERANCE = 0.02
_OBSERVE_EVERY = 5
_STILL = 2e-3

StepCallback = Callable[["Simulator"], None]
Until = Callable[["Simulator"], str | None]
"""Looked at every 10 ms of a phase; what it returns, unless None, is why the phase is left."""


class Simulator:
    """A scene that lives. Deterministic: the same scene and the same plans give the same bytes.

    Args:
        scene: what stands around the robot.
        state: where the robot is at the beginning; home by default.
        faults: what shall go wrong.

    Raises:
        InvalidGoal: a fault names a box or an arm that there is not.
    """

    def __init__(self, scene: Scene, state: RobotState | None = None, faults: Sequence[Fault] = ()) -> None:
        self._scene = scene
        self._indices = scene_model(scene)
        self._injector = Injector(faults, tuple(self._indices.box_qpos)) if faults else None
        self._model: Any = self._indices.model
        self._data: Any = mujoco.MjData(self._model)
        self._awake: Any = copy.copy(self._model)
        self._awake.opt.enableflags = 0
        self._scratch: Any = mujoco.MjData(self._awake)
        if any(isinstance(fault, Push) for fault in faults):  # what sleeps would not notice that it is pushed
            self._model = self._awake
        state = RobotState.home() if state is None else state
        self._indices.write_boxes(self._data, scene)
        self._indices.write_robot(self._data, state)
        self._controller = Controller(self._indices, self._model, state, self._injector)
        self._controller.command(self._data)
        self._stopped = False
        mujoco.mj_forward(self._model, self._data)

    def __enter__(self) -> Simulator:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Gives the memory back; the simulator cannot be used afterwards."""
        self._data = self._scratch = None

    # What can be observed.

    @property
    def time(self) -> float:
        """Simulated seconds since the beginning."""
        return float(self._data.time)

    def poses(self) -> dict[str, Pose]:
        """Pose of every box, by name."""
        return {
            box.name: box.pose if box.fixed else self._indices.read_box(self._data, box.name)
            for box in self._scene.boxes
        }

    def pose(self, name: str) -> Pose:
        """Pose of one box.

        Raises:
            UnknownBody: there is none of that name.
        """
        if name in self._indices.box_qpos:
            return self._indices.read_box(self._data, name)
        return self._scene.box(name).pose

    def scene(self) -> Scene:
        """The scene as it is now."""
        return self._scene.moved({name: pose for name, pose in self.poses().items() if name in self._indices.box_qpos})

    def state(self) -> RobotState:
        """The robot as it is now, for the next plan.

        Joints are as commanded, so that the next plan begins without a jump; widths and what is held are as measured.
        """
        widths = {arm: self.gripper_width(arm) for arm in ARMS}
        held = {arm: names[0] for arm in ARMS if (names := self.holding(arm))}
        reference = self._controller.reference
        return RobotState(reference["left"], reference["right"], widths, held)

    @property
    def happened(self) -> tuple[Fault, ...]:
        """The injected faults that have begun so far."""
        return () if self._injector is None else self._injector.happened

    def joints(self, arm: str) -> Array:
        """(7,) measured joints, radians."""
        return np.array(self._data.qpos[self._indices.arm_qpos[arm]])

    def gripper_width(self, arm: str) -> float:
        """Measured opening of a gripper, metres."""
        first, second = self._data.qpos[self._indices.finger_qpos[arm]]
        return recipe().gripper.closed + float(first - second)

    def tool_pose(self, arm: str) -> Pose:
        """Pose of a tool frame by the measured joints."""
        return load_robot().tool_pose(arm, self.joints(arm))

    def tracking_error(self, arm: str) -> float:
        """Largest deviation of a joint from where it should be, radians."""
        return float(np.abs(self._data.qpos[self._indices.arm_qpos[arm]] - self._controller.reference[arm]).max())

    def contacts(self) -> tuple[tuple[str, str], ...]:
        """Pairs of bodies that touch now, sorted; a body is a box, a link of the robot, or "floor"."""
        # What sleeps has no contacts in the simulation itself, so they are found anew, without sleep.
        self._scratch.qpos[:] = self._data.qpos
        mujoco.mj_kinematics(self._awake, self._scratch)
        mujoco.mj_collision(self._awake, self._scratch)
        return touching_pairs(self._indices, self._scratch)

    def holding(self, arm: str) -> tuple[str, ...]:
        """Names of the boxes that both fingers of an arm touch."""
        return between_fingers(self._indices, self._data, arm)

    def copy_positions(self, data: Any) -> None:
        """Writes all positions into the MjData of another model of the same scene, such as the one that is rendered."""
        data.qpos[:] = self._data.qpos
        data.time = self._data.time

    # What can be done.

    def execute(self, plan: Plan, on_step: StepCallback | None = None) -> Execution:
        """Carries out a plan.

        Args:
            plan: begins where the robot is now.
            on_step: called with this simulator after every time step, such as for the frames of a video.

        Raises:
            InvalidGoal: the plan begins elsewhere.
            SimulationDiverged: the physics broke down.
        """
        self.check_start(plan)
        records = tuple(self.run_phase(plan.arm, plan.target, phase, on_step) for phase in plan.phases)
        return Execution(records, self.holding(plan.arm))

    def check_start(self, plan: Plan) -> None:
        """Checks that a plan begins where the robot is.

        Raises:
            InvalidGoal: it does not.
        """
        for arm in ARMS:
            gap = float(np.max(np.abs(plan.start.joints(arm) - self._controller.reference[arm])))
            if gap > _START_TOLERANCE:
                raise InvalidGoal(
                    f"the plan begins {gap:.3f} rad from where the {arm} arm is; plan with start=simulator.state()",
                    plan.target,
                )

    def hold(self, seconds: float, on_step: StepCallback | None = None) -> None:
        """Lets time pass while the robot keeps still."""
        for _ in range(round(seconds / self._model.opt.timestep)):
            self._controller.command(self._data)
            self._step(on_step)
        self._check()

    def settle(self, seconds: float = 2.0) -> bool:
        """Lets time pass until nothing moves any more, `seconds` at most; whether nothing does."""
        dofs = [dof for start in self._indices.box_dof.values() for dof in range(start, start + 6)]
        for count in range(round(seconds / self._model.opt.timestep)):
            self._controller.command(self._data)
            self._step(None)
            if count >= 25 and (not dofs or np.max(np.abs(self._data.qvel[dofs])) < _STILL):
                return True
        self._check()
        return not dofs or bool(np.max(np.abs(self._data.qvel[dofs])) < _STILL)

    def stop(self) -> None:
        """Makes everything stand still at once: the arms are told to stay where they are, the phase that runs ends."""
        self._stopped = True

    def run_phase(
        self,
        arm: str,
        target: str | None,
        phase: Phase,
        on_step: StepCallback | None = None,
        until: Until | None = None,
    ) -> PhaseRecord:
        """Carries out one phase of a plan, which begins where the robot is now, in the time that its trajectory takes.

        Args:
            arm: the plan's arm.
            target: the plan's target.
            phase: the phase.
            on_step: as for `execute`.
            until: gives a reason to stop on the way, if there is one; the arm then brakes on the path of the phase.

        Raises:
            SimulationDiverged: the physics broke down.
        """
        trajectory = resampled_in_time(phase.trajectory, float(self._model.opt.timestep))
        controller = self._controller
        steps = whole = len(trajectory.positions) - 1
        before, error, k, offset = controller.width[arm], 0.0, 0, 0
        contacts: set[Pair] = set()
        reason: str | None = None
        self._stopped = False
        while k < steps and not self._stopped:
            k += 1
            controller.reference[arm] = trajectory.positions[k]
            if reason is None:
                controller.width[arm] = before + (phase.gripper - before) * k / whole
            if self._injector is not None and self._injector.waiting:
                self._injector.begin(arm, phase.name, (offset + k) / whole, self.time, self.holding(arm))
            controller.command(self._data, arm, trajectory.velocities[k], trajectory.accelerations[k])
            self._step(on_step)
            error = max(error, self.tracking_error(arm))
            if k % _OBSERVE_EVERY == 0:
                contacts |= self._unintended(arm, target)
                reason = until(self) if until is not None and reason is None else reason
                if reason is not None and offset == 0:
                    trajectory = braked(trajectory, k, recipe().limits)
                    steps, offset, k = len(trajectory.positions) - 1, k, 0
        if reason is None:
            controller.width[arm] = phase.gripper
        self._check()
        seconds = (offset + k) * trajectory.period
        return PhaseRecord(phase.name, seconds, error, self.gripper_width(arm), tuple(sorted(contacts)), reason)

    # How.

    def _step(self, on_step: StepCallback | None) -> None:
        if self._injector is not None:
            self._injector.push(self._indices, self._data, self._model.opt.timestep)
        mujoco.mj_step(self._model, self._data)
        if on_step is not None:
            on_step(self)

    def _check(self) -> None:
        if not (np.all(np.isfinite(self._data.qpos)) and np.all(np.isfinite(self._data.qvel))):
            raise SimulationDiverged(f"the physics broke down at {self.time:.3f} s: positions are not finite")

    def _unintended(self, arm: str, target: str | None) -> set[Pair]:
        found = unintended_pairs(self._indices, self._data, arm, target)
        if not found:
            return found
        carried = {name for other in ARMS if other != arm for name in self.holding(other)}
        return {pair for pair in found if carried.isdisjoint(pair)}
