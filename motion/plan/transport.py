"""From one side of the table to the other: one hand sets the box down in the middle, the other takes it on."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from motion.errors import (
    GraspUnavailable,
    InvalidGoal,
    MotionError,
    PathNotFound,
    PlanInCollision,
    UnreachableTarget,
)
from motion.plan.budget import BUDGET
from motion.plan.goals import positions
from motion.plan.planner import plan_place
from motion.plan.plans import Plan
from motion.polygons import overlap
from motion.poses import Array
from motion.robot.state import RobotState
from motion.scene import Scene

_MIDDLE_X = (0.58, 0.66, 0.5)
_MIDDLE_Y = (0.0, 0.08, -0.08, 0.16, -0.16)
_ROOM = 0.025
_SPOTS = 4


def plan_transport(
    scene: Scene,
    target: str,
    position: ArrayLike,
    *,
    yaw: float | None = None,
    arm: str = "auto",
    start: RobotState | None = None,
    rng: np.random.Generator | None = None,
    budget: float = BUDGET,
) -> tuple[Plan, ...]:
    """Plans that bring a box to its destination: one, or two over the middle where no single hand reaches both places.

    The second plan assumes that the first one ends as planned. Whoever would rather look again carries out the first
    and calls this function, or `plan_place`, once more.

    Args:
        scene: where everything is.
        target: name of the box.
        position: (3,) where its centre shall be, metres; or (n, 3) places of which one will do, the best first.
        yaw: as for `plan_place`.
        arm: with "left" or "right" there is no handing over.
        start: where the robot is; home by default.
        rng: source of all chance; a fixed seed by default.
        budget: processor time that each plan may take, seconds.

    Raises:
        MotionError: as for `plan_place`, of which the first reason is given.
    """
    start = RobotState.home() if start is None else start
    rng = np.random.default_rng(0) if rng is None else rng
    try:
        return (plan_place(scene, target, position, yaw=yaw, arm=arm, start=start, rng=rng, budget=budget),)
    except (UnreachableTarget, GraspUnavailable, PlanInCollision, PathNotFound):
        if arm != "auto":
            raise
        goal = positions(target, position)[0]
        first, second = ("left", "right") if scene.box(target).position[1] > goal[1] else ("right", "left")
        if target in start.held.values():
            first = next(side for side, name in start.held.items() if name == target)
            second = "right" if first == "left" else "left"
        if second in start.held:
            raise
        for spot in itertools.islice(_spots(scene, target, goal), _SPOTS):
            try:
                there = plan_place(scene, target, spot, arm=first, start=start, rng=rng, budget=budget)
                assert there.goal is not None
                moved = scene.moved({target: there.goal})
                on = plan_place(moved, target, position, yaw=yaw, arm=second, start=there.end, rng=rng, budget=budget)
                return there, on
            except MotionError:
                continue
        raise


def _spots(scene: Scene, target: str, goal: Array) -> Iterator[Array]:
    """Free places on the table between both arms, with room for the fingers around."""
    for y, x in itertools.product(_MIDDLE_Y, _MIDDLE_X):
        try:
            spot = scene.resting_position(target, (x, y))
        except InvalidGoal:
            continue
        here = scene.box(target).footprint - scene.box(target).position[:2] + spot[:2]
        loose = [box for box in scene.boxes if not box.fixed and box.name != target]
        if all(overlap(here, box.footprint) < -_ROOM for box in loose) and np.linalg.norm(spot - goal) > 0.1:
            yield spot
