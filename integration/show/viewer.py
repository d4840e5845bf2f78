"""The simulation in MuJoCo's own window, at the pace of the clock."""

from __future__ import annotations

import os
import sys
import time
from typing import Any

from integration.errors import ViewerUnavailable
from motion import Scene, Simulator
from motion.collision.scene_model import scene_model
from motion.physics_engine import mujoco

_EVERY = 1 / 60  # simulated seconds between two pictures


class Window:
    """Shows a run; give it to the executor as `watch`, and `wait` until it is closed.

    Args:
        scene: what stands around the robot.

    Raises:
        ViewerUnavailable: there is no screen, or no window can be opened.
    """

    def __init__(self, scene: Scene) -> None:
        if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
            raise ViewerUnavailable("--view needs a screen, and there is none (DISPLAY is unset); try --video run.gif")
        indices = scene_model(scene, visuals=True)
        self._data: Any = mujoco.MjData(indices.model)
        try:
            import mujoco.viewer as viewer

            self._viewer: Any = viewer.launch_passive(indices.model, self._data)
        except Exception as error:  # whatever a missing or broken window system raises
            raise ViewerUnavailable(f"no window could be opened ({error}); try --video run.gif") from error
        self._begun: float | None = None
        self._shown = -1.0

    def __call__(self, simulator: Simulator) -> None:
        """Called after every step of physics."""
        if simulator.time - self._shown < _EVERY or not self._viewer.is_running():
            return
        self._shown = simulator.time
        if self._begun is None:
            self._begun = time.perf_counter() - simulator.time
        time.sleep(max(0.0, self._begun + simulator.time - time.perf_counter()))
        simulator.copy_positions(self._data)
        mujoco.mj_kinematics(self._data.model, self._data)
        self._viewer.sync()

    def wait(self) -> None:
        """Returns when the window has been closed."""
        while self._viewer.is_running():
            time.sleep(0.05)
        self._viewer.close()
