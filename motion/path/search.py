"""Paths of one arm that are free of contact: straight in joint space, over a via point, or found by sampling.

What is found by sampling is shortened by straight lines where those are free.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Near, Rules
from motion.collision.grid import GRID
from motion.errors import PathNotFound, PlanInCollision
from motion.ik.tracking import track
from motion.path.sampling import Free, sampled_path
from motion.poses import Array, Pose
from motion.robot.load import load_robot
from motion.robot.recipe import recipe

_SHORTCUTS = 40
_LINE_STEP = 0.005


def connect(
    checker: CollisionChecker,
    arm: str,
    start: Array,
    goal: Array,
    rules: Rules,
    rng: np.random.Generator,
    phase: str,
    expansions: int,
    grid: float = GRID,
) -> list[Array]:
    """Waypoints from `start` to `goal`, the straight lines between them free by `rules` on the grid.

    Args:
        checker: the world around, and what the hand holds.
        arm: "left" or "right".
        start: (7,) radians.
        goal: (7,) radians.
        rules: what may be near to what.
        rng: where samples come from.
        phase: the phase's name, for errors.
        expansions: how often the sampling planner may grow its trees.
        grid: longest step of any joint between two configurations that are checked, radians.

    Raises:
        PlanInCollision: the start or the goal itself is in conflict.
        PathNotFound: both are free, but nothing was found between them.
    """
    for joints, what in ((start, "start"), (goal, "goal")):
        near = checker.nearest(joints, rules)
        if near is not None:
            raise PlanInCollision(
                f"the {what} of {phase} is in conflict: {describe(near)}, {1000 * rules.clearance:.0f} mm are kept",
                phase,
                near.bodies,
                near.distance,
                near.place,
            )
    free = partial(checker.free, rules=rules, grid=grid)

    def valid(joints: Array) -> bool:
        return checker.nearest(joints, rules) is None

    if free(start, goal):
        return [start, goal]
    home = recipe().home[arm]
    if free(start, home) and free(home, goal):
        return _shortened(free, [start, home, goal], rng)
    path = sampled_path(load_robot().arm(arm), free, valid, start, goal, rng, expansions, grid)
    if path is None:
        raise PathNotFound(
            f"no way was found for {phase} of the {arm} arm in {expansions} expansions, "
            "although its start and goal are free"
        )
    return _shortened(free, path, rng)


def straight(arm: str, first: Pose, last: Pose, joints: Array) -> list[Array] | None:
    """Joints along the straight line of the tool from `first` to `last`; None if the arm cannot follow.

    Args:
        arm: "left" or "right".
        first: pose of the tool frame at the beginning; its orientation is kept.
        last: pose at the end.
        joints: (7,) joints at or near `first`, radians.
    """
    distance = float(np.linalg.norm(last.position - first.position))
    steps = max(2, int(np.ceil(distance / _LINE_STEP)))
    targets = [
        Pose(first.position + (last.position - first.position) * (k / steps), first.orientation)
        for k in range(1, steps + 1)
    ]
    path = track(arm, targets, joints)
    return None if path is None else [np.asarray(joints), *path]


def describe(near: Near) -> str:
    """The distance in words, such as: a and b are 3.0 mm apart."""
    first, second = near.bodies
    if near.distance < 0:
        return f"{first} and {second} overlap by {-1000 * near.distance:.1f} mm"
    return f"{first} and {second} are {1000 * near.distance:.1f} mm apart"


def _shortened(free: Free, path: list[Array], rng: np.random.Generator) -> list[Array]:
    """Replaces detours by straight lines where those are free."""
    for _ in range(_SHORTCUTS):
        if len(path) < 3:
            break
        i, j = sorted(rng.integers(0, len(path) - 1, 2))
        a = path[i] + (path[i + 1] - path[i]) * rng.uniform()
        b = path[j] + (path[j + 1] - path[j]) * rng.uniform()
        if i == j or not free(a, b):
            continue
        path = [*path[: i + 1], a, b, *path[j + 1 :]]
    return path
