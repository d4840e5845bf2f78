"""Sessions in files: the world, the robot, and what undoing needs, as JSON."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grounding.errors import WorldError
from grounding.world import World, world_from_json, world_to_json
from integration.errors import UsageError
from motion import MotionError, RobotState
from motion.robot.state import ARMS

SCHEMA = 1
_KEYS = ("schema", "world", "robot", "history", "seed", "before")


@dataclass(frozen=True, eq=False)
class Saved:
    """The things that a session needs to go on.

    Attributes:
        world: as it was observed last.
        state: of the robot.
        history: ids of the objects handled so far, the latest last.
        seed: of all chance.
        before: for each goal that moved something, the world before it and what hands held then, by arm.
    """

    world: World
    state: RobotState
    history: tuple[str, ...]
    seed: int
    before: tuple[tuple[World, Mapping[str, str]], ...]


def write_session(path: Path, saved: Saved) -> None:
    """Write a session whole, or not at all.

    Raises:
        OSError: the file cannot be written.
    """
    data = {
        "schema": SCHEMA,
        "world": world_to_json(saved.world),
        "robot": saved.state.to_json(),
        "history": list(saved.history),
        "seed": saved.seed,
        "before": [{"world": world_to_json(world), "held": dict(held)} for world, held in saved.before],
    }
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, "there is no such folder", str(path.parent))
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        part.write_text(json.dumps(data), encoding="utf-8")
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def read_session(path: Path) -> Saved:
    """Read a session.

    Raises:
        UsageError: the file is no session; says what is wrong with it.
        OSError: the file cannot be read.
    """
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, ValueError) as error:
        raise UsageError(f"{path}: expected a session as JSON: {error}") from error
    if not isinstance(data, dict) or data.get("schema") != SCHEMA or set(data) != set(_KEYS):
        raise UsageError(f"{path}: expected a session, an object with schema {SCHEMA} and {', '.join(_KEYS[1:])}")
    try:
        robot = data["robot"]
        state = RobotState(robot["left"], robot["right"], robot["widths"], robot["held"])
        world = world_from_json(data["world"], f"{path}: world")
        before = tuple(
            (world_from_json(one["world"], f"{path}: before"), _held(one["held"], world)) for one in data["before"]
        )
        history = tuple(str(name) for name in data["history"])
        seed = int(data["seed"])
        _held(state.held, world)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise UsageError(f"{path}: not a session as `Session.save` writes one: {error!r}") from error
    except (WorldError, MotionError) as error:
        raise UsageError(f"{path}: {error}") from error
    return Saved(world, state, history, seed, before)


def _held(data: Any, world: World) -> Mapping[str, str]:
    """The things that hands hold, by arm.

    Raises:
        ValueError: there is no such arm or thing.
    """
    known = {item.id for item in world.things}
    for arm, name in dict(data).items():
        if arm not in ARMS or name not in known:
            raise ValueError(f"the {arm} hand cannot hold {name!r}")
    return dict(data)
