"""Watching a plan while it is carried out: by the arm's joints, the gripper's width, and where the block is seen."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from motion import Backend, Phase, PhaseRecord, Plan, Pose, Scene, Sensor

MOVED, TURNED = 0.003, 0.06
"""Largest move and turn of a block since its grasp was planned: [m], [rad]."""
WIDTH = 0.0025
"""Largest error of the opening of the fingers, in [m]."""
SLIPPED = 0.012
"""Largest move of a held block in the hand, in [m]."""
TRACKING = 0.04
"""Largest error of a joint, in [rad]."""
_BEFORE = ("home", "pregrasp", "approach")
_CARRIED = ("lift", "hold", "transfer", "lower")
_EVERY = 2

Told = tuple[str, str]


class Monitor:
    """Watches one plan.

    Args:
        plan: what is carried out.
        scene: where everything was seen when the plan was made.
        sensor: how well blocks are seen.
        rng: of the sensor's noise.
        look: where everything is seen now, with the arm at rest.
    """

    def __init__(
        self, plan: Plan, scene: Scene, sensor: Sensor, rng: np.random.Generator, look: Callable[[], Scene]
    ) -> None:
        self._plan, self._sensor, self._rng, self._look = plan, sensor, rng, look
        self._target = plan.target
        self._seen = None if plan.target is None else scene.box(plan.target).pose
        self._grip: Pose | None = None
        held = plan.start.held.get(plan.arm) == plan.target and plan.target is not None
        self._width = plan.grasp.width if plan.grasp is not None else plan.start.widths[plan.arm] if held else None
        self._calls, self._taken = 0, held

    def during(self, phase: Phase) -> Callable[[Backend], str | None]:
        """Watches a phase while it is carried out, for reasons to leave it: each as "kind: what was noticed"."""
        before: float | None = None

        def look(simulator: Backend) -> str | None:
            nonlocal before
            off = simulator.tracking_error(self._plan.arm)
            before = off if before is None else before  # an arm that was held up may free itself
            self._calls += 1
            if self._calls % _EVERY:
                return None
            if off > TRACKING + before:
                return (
                    f"tracking: the {self._plan.arm} arm is {off:.2f} rad from where it should be during {phase.name}"
                )
            if phase.name in _BEFORE and not self._taken and self._target is not None:
                return self._moved(self._glimpse(simulator), 2 * self._sensor.noise, 2 * self._sensor.turn)
            if phase.name in _CARRIED and phase.held is not None:
                return self._lost(simulator)
            return None

        return look

    def after(self, phase: Phase, record: PhaseRecord, simulator: Backend) -> str | None:
        """The fault that a finished phase shows, as "kind: what was noticed", or None."""
        if record.left is not None:
            return record.left
        following = self._following(phase)
        if following == "approach":
            short = phase.gripper - record.gripper_width
            if short > WIDTH:
                return (
                    f"gripper: the {self._plan.arm} gripper opened to {1000 * record.gripper_width:.1f} mm instead of "
                    f"{1000 * phase.gripper:.1f} mm"
                )
            if self._target is not None and not self._sensor.exact:
                return self._moved(self._look().box(self._target).pose, 0.0, 0.0)
        if phase.name == "close" and self._width is not None:
            self._taken = True
            return self._closed(record.gripper_width, simulator)
        if phase.name == "open" and self._width is not None:
            opened = record.gripper_width - self._width
            if opened < WIDTH or self._target in simulator.holding(self._plan.arm):
                return f"gripper: the {self._plan.arm} gripper did not let go of {self._target}"
        return None

    def _following(self, phase: Phase) -> str | None:
        names = [other.name for other in self._plan.phases]
        place = next(k for k, other in enumerate(self._plan.phases) if other is phase)
        return names[place + 1] if place + 1 < len(names) else None

    def _moved(self, pose: Pose, more: float, turn: float) -> str | None:
        assert self._seen is not None
        distance, angle = pose.distance(self._seen)
        if distance > MOVED + more or angle > TURNED + turn:
            return f"moved: {self._target} was moved by {1000 * distance:.0f} mm and {np.degrees(angle):.0f} degrees"
        return None

    def _closed(self, width: float, simulator: Backend) -> str | None:
        assert self._width is not None
        if width > self._width + WIDTH:
            return (
                f"gripper: the {self._plan.arm} gripper closed to {1000 * width:.1f} mm, and {self._target} is "
                f"{1000 * self._width:.1f} mm wide"
            )
        if width < self._width - WIDTH:
            return f"missed: the {self._plan.arm} gripper closed to {1000 * width:.1f} mm beside {self._target}"
        self._grip = simulator.tool_pose(self._plan.arm).inverse() @ self._glimpse(simulator)
        return None

    def _lost(self, simulator: Backend) -> str | None:
        if self._width is not None and abs(simulator.gripper_width(self._plan.arm) - self._width) > WIDTH:
            width = 1000 * simulator.gripper_width(self._plan.arm)
            return f"slipped: {self._target} left the {self._plan.arm} hand, whose fingers are {width:.1f} mm apart"
        tool = simulator.tool_pose(self._plan.arm)
        if self._grip is None:
            self._grip = tool.inverse() @ self._glimpse(simulator)
        off, _ = (tool @ self._grip).distance(self._glimpse(simulator))
        if off > SLIPPED + 2 * self._sensor.noise:
            return f"slipped: {self._target} slipped by {1000 * off:.0f} mm in the {self._plan.arm} hand"
        return None

    def _glimpse(self, simulator: Backend) -> Pose:
        """The place of the target by one frame."""
        assert self._target is not None
        return self._sensor.glimpse(simulator.pose(self._target), self._rng)
