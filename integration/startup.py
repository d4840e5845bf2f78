"""Starting fast: words and robot are loaded side by side."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

import numpy  # noqa: F401  # before the thread below, which needs it too

if TYPE_CHECKING:
    from integration.executor import Executor


def started(arm: str, seed: int) -> Executor:
    """An executor with its grounder loaded.

    Args:
        arm: "left", "right" or "auto".
        seed: of all chance.
    """
    from grounding import Grounder

    thread = threading.Thread(target=_load_robot, daemon=True)
    thread.start()
    grounder = Grounder.load()
    thread.join()
    from integration.executor import Executor

    return Executor(grounder, arm=arm, seed=seed)


def _load_robot() -> None:
    """Loads the robot, ahead of the executor; whatever fails here fails there again, where it is told."""
    try:
        from motion.robot import load_robot

        load_robot()
    except Exception:
        return
