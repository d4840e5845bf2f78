"""Taking a stack apart from above: what stands on a box is set down elsewhere, so that the box can be reached."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from motion.errors import GraspUnavailable, InvalidGoal, MotionError
from motion.grasp.targets import checked_target
from motion.plan.free_spots import free_spots
from motion.plan.planner import plan_place
from motion.plan.plans import Plan
from motion.polygons import overlap
from motion.poses import Array
from motion.robot.state import ARMS, RobotState
from motion.scene import Box, Scene

_ROOM = 0.10
"""Least distance between what is set aside and the stack, so that the hand gets at what is left; metres."""
_APART = 0.07
_SPOTS = 12


def stacked_on(scene: Scene, name: str, held: Sequence[str] = ()) -> tuple[Box, ...]:
    """The boxes that stand on a box, directly or on one another, the topmost first.

    Args:
        scene: where everything is.
        name: the box.
        held: names of boxes in hands, which do not count.

    Raises:
        UnknownBody: there is no such box.
    """
    found: dict[str, Box] = {}
    waiting = [name]
    while waiting:
        for box in scene.boxes_above(waiting.pop()):
            if box.name not in found and box.name not in held:
                found[box.name] = box
                waiting.append(box.name)
    return tuple(sorted(found.values(), key=lambda box: (-box.bottom, box.name)))


def plan_unstacking(
    scene: Scene,
    target: str,
    *,
    arm: str = "auto",
    start: RobotState | None = None,
    rng: np.random.Generator | None = None,
    keep_free: Sequence[ArrayLike] = (),
) -> tuple[Plan, ...]:
    """Verified plans that set everything that stands on a box down at free places, the topmost first.

    Each plan assumes that the one before ended as planned. Whoever would rather look again carries out the first and
    calls this function once more, until there are none. `plan_pick` of the box can follow.

    Args:
        scene: where everything is.
        target: name of the box.
        arm: "left", "right", or "auto" for whichever does it better.
        start: where the robot is; home by default.
        rng: source of all chance; a fixed seed by default.
        keep_free: convex outlines, (n, 2) in metres, where nothing is to be set down.

    Returns:
        as many plans as boxes stand on it; none where nothing does.

    Raises:
        UnknownBody, InvalidGoal: as for `plan_pick`.
        GraspUnavailable: one of them cannot be set aside; the message says which and why.
    """
    start = RobotState.home() if start is None else start
    rng = np.random.default_rng(0) if rng is None else rng
    if arm not in ("auto", *ARMS):
        raise InvalidGoal(f"there is no arm {arm!r}; there are 'left', 'right' and 'auto'", target)
    above = stacked_on(scene, target, tuple(start.held.values()))
    checked_target(Scene(tuple(box for box in scene.boxes if box not in above)), target, start)
    plans: list[Plan] = []
    for box in above:
        plan = _set_aside(scene, box.name, target, arm, start, rng, keep_free)
        assert plan.goal is not None
        plans.append(plan)
        scene, start = scene.moved({box.name: plan.goal}), plan.end
    return tuple(plans)


def _set_aside(
    scene: Scene,
    name: str,
    target: str,
    arm: str,
    start: RobotState,
    rng: np.random.Generator,
    keep_free: Sequence[ArrayLike],
) -> Plan:
    """A plan that puts one box at the nearest free place that a hand reaches.

    Raises:
        GraspUnavailable: there is none.
    """
    first: MotionError | None = None
    for spot in _spots(scene, name, target, keep_free):
        try:
            return plan_place(scene, name, spot, arm=arm, start=start, rng=rng)
        except MotionError as error:
            first = first or error
    why = "there is no free room on the table" if first is None else str(first)
    raise GraspUnavailable(
        f"{target!r} is under {name!r}, which cannot be set aside first: {why}", target, None
    ) from first


def _spots(scene: Scene, name: str, target: str, keep_free: Sequence[ArrayLike]) -> list[Array]:
    """Free places for a box, the nearest first and some way apart, so that tries are not wasted on neighbours."""
    box, stack = scene.box(name), scene.box(target).position[:2]
    outlines = [np.asarray(outline, dtype=np.float64) for outline in keep_free]
    spots = free_spots(scene, name)
    ways = np.linalg.norm(spots[:, :2] - stack, axis=1)
    chosen: list[Array] = []
    for index in np.lexsort((spots[:, 1], spots[:, 0], np.round(ways, 4))):
        spot = spots[index]
        there = box.footprint - box.position[:2] + spot[:2]
        if (
            ways[index] >= _ROOM
            and all(np.linalg.norm(spot - other) >= _APART for other in chosen)
            and all(overlap(there, outline) < 0 for outline in outlines)
        ):
            chosen.append(spot)
        if len(chosen) == _SPOTS:
            break
    return chosen
