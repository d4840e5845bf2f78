"""Checks of a target before any grasp is tried: it is known, loose and uncovered, and a hand is free for it."""

from __future__ import annotations

from motion.errors import InvalidGoal
from motion.robot.state import ARMS, RobotState
from motion.scene import Box, Scene


def checked_target(scene: Scene, name: str, state: RobotState) -> Box:
    """The box to pick.

    Raises:
        UnknownBody: there is no such box.
        InvalidGoal: it is fixed, or other boxes stand on it.
    """
    box = scene.box(name)
    if box.fixed:
        raise InvalidGoal(f"{name!r} is fixed and cannot be picked; only loose boxes can", name)
    above = [other.name for other in scene.boxes_above(name) if other.name not in state.held.values()]
    if above:
        raise InvalidGoal(
            f"{name!r} is under {', '.join(map(repr, above))}; what stands on it must be moved first (plan_unstacking)",
            name,
        )
    return box


def checked_arms(arm: str, state: RobotState, target: str) -> tuple[str, ...]:
    """The arms that may do it: the one asked for, or with "auto" the one that holds the target, or all that are free.

    Raises:
        InvalidGoal: the arm's name is wrong, or its hand is full.
    """
    if arm not in ("auto", *ARMS):
        raise InvalidGoal(f"there is no arm {arm!r}; there are 'left', 'right' and 'auto'", target)
    holding = [side for side in ARMS if state.held.get(side) == target]
    if holding:
        if arm not in ("auto", holding[0]):
            raise InvalidGoal(f"{target!r} is held by the {holding[0]} hand, not by the {arm} one", target)
        return (holding[0],)
    free = tuple(side for side in (ARMS if arm == "auto" else (arm,)) if side not in state.held)
    if not free:
        what = ", ".join(f"{side}: {box!r}" for side, box in state.held.items())
        raise InvalidGoal(f"no hand is free to take {target!r}; they hold {what}", target)
    return free
