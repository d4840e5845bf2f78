"""Starting fast: words and robot are loaded side by side."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

import numpy  # noqa: F401  # before the thread below, which needs it too

if TYPE_CHECKING:
    from integration.execute.executor import Executor
    from integration.execute.report import Step


def started(arm: str, seed: int) -> tuple[Executor, Step]:
    """An executor with its grounder and its robot loaded, and the step that this was.

    Args:
        arm: "left", "right" or "auto".
        seed: of all chance.
    """
    start = time.perf_counter()
    thread = threading.Thread(target=_load_robot, daemon=True)
    thread.start()
    from grounding import Grounder

    grounder = Grounder.load()
    thread.join()
    from integration.execute.executor import Executor
    from integration.execute.report import Step

    executor = Executor(grounder, arm=arm, seed=seed)
    return executor, Step("load words and robot", time.perf_counter() - start)


def _load_robot() -> None:
    """Loads the robot, ahead of the executor; whatever fails here fails there again, where it is told."""
    try:
        from motion.robot.load import load_robot

        load_robot()
    except Exception:
        return
