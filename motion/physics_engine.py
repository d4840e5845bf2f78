"""MuJoCo, imported so that a machine without OpenGL, or a wish for one that it lacks, does not stop the physics."""

from __future__ import annotations

import os

try:
    import mujoco
except (ImportError, AttributeError, RuntimeError, OSError):
    # MUJOCO_GL names a backend whose libraries are missing. Physics needs none: rendering says so when it is asked for.
    wished = os.environ["MUJOCO_GL"]
    os.environ["MUJOCO_GL"] = "disable"
    try:
        import mujoco
    finally:
        os.environ["MUJOCO_GL"] = wished

__all__ = ["mujoco"]
