"""Paths of one arm that are free of contact: straight in joint space, over a via point, or found by sampling.

The sampling planner is RRT-Connect (Kuffner and LaValle, 2000) with shortcuts afterwards.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from motion.collisions import GRID, CollisionChecker, Near, Rules
from motion.errors import PathNotFound, PlanInCollision
from motion.ik import track
from motion.poses import Array, Pose
from motion.recipe import recipe
from motion.robot import load_robot

_STEP = 0.35
_SHORTCUTS = 40
_LINE_STEP = 0.005

Free = Callable[[Array, Array], bool]
"""Whether the straight line between two configurations is free."""


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
    if free(start, goal):
        return [start, goal]
    home = recipe().home[arm]
    if free(start, home) and free(home, goal):
        return _shortened(free, [start, home, goal], rng)
    path = _rrt_connect(free, arm, start, goal, rng, expansions)
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
    """How near they are in words, such as: a and b are 3.0 mm apart."""
    first, second = near.bodies
    if near.distance < 0:
        return f"{first} and {second} overlap by {-1000 * near.distance:.1f} mm"
    return f"{first} and {second} are {1000 * near.distance:.1f} mm apart"


class _Tree:
    def __init__(self, root: Array) -> None:
        self.nodes = [root]
        self.parents = [-1]

    def nearest(self, point: Array) -> int:
        return int(np.argmin(np.max(np.abs(np.array(self.nodes) - point), axis=1)))

    def add(self, point: Array, parent: int) -> int:
        self.nodes.append(point)
        self.parents.append(parent)
        return len(self.nodes) - 1

    def branch(self, node: int) -> list[Array]:
        """From the node to the root."""
        path = []
        while node >= 0:
            path.append(self.nodes[node])
            node = self.parents[node]
        return path


def _rrt_connect(
    free: Free, arm: str, start: Array, goal: Array, rng: np.random.Generator, expansions: int
) -> list[Array] | None:
    data = load_robot().arm(arm)
    trees = [_Tree(start), _Tree(goal)]
    middle, spread = (start + goal) / 2, np.abs(goal - start) / 2 + 0.6
    for count in range(expansions):
        # First near the two ends, later anywhere.
        reach = spread * (1 + count / 40)
        sample = np.clip(middle + rng.uniform(-reach, reach), data.lower, data.upper)
        growing, other = trees[count % 2], trees[1 - count % 2]
        node = _extend(free, growing, sample)
        if node is None:
            continue
        target = growing.nodes[node]
        meeting: int | None = None
        while True:
            following = _extend(free, other, target, meeting)
            if following is None:
                break
            meeting = following
            if np.max(np.abs(other.nodes[meeting] - target)) < 1e-9:
                a, b = growing.branch(node), other.branch(meeting)
                joined = a[::-1] + b[1:]
                return joined if count % 2 == 0 else joined[::-1]
    return None


def _extend(free: Free, tree: _Tree, target: Array, source: int | None = None) -> int | None:
    """Grows the tree one step towards `target`; the new node, or None when that step is not free."""
    near = tree.nearest(target) if source is None else source
    origin = tree.nodes[near]
    gap = float(np.max(np.abs(target - origin)))
    if gap < 1e-9:
        return near
    point = target if gap <= _STEP else origin + (target - origin) * (_STEP / gap)
    return tree.add(point, near) if free(origin, point) else None


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
