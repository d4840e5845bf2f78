"""The reach map: where on a table which hand can take a block, and how far it must tilt.

For each place of a grid a block is put down in several turns; a hand reaches it with a tilt if for one of the block's
grasps there are joints from which the hand can back off and rise, clear of the table, of itself and of the other arm.
Neighbours are not part of the map: for a block among others ask `reach.reach_box`.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import NamedTuple

import numpy as np

from motion.cache import cached_folder
from motion.collision.checker import CollisionChecker
from motion.collision.clearance import CLOSE, Rules
from motion.errors import InvalidGoal, InvalidScene, UnreachableTarget
from motion.grasp.approaches import APPROACH
from motion.grasp.candidates import TILTS, Grasp, grasp_candidates
from motion.grasp.reach import LIFT
from motion.ik.solver import solve_ik
from motion.ik.tracking import track
from motion.poses import Array, Pose, frozen
from motion.progress_bar import ProgressBar
from motion.robot.recipe import recipe
from motion.robot.state import ARMS, RobotState
from motion.scene import Box, Scene

STEEPNESS = tuple(sorted({abs(tilt) for tilt in TILTS}))
"""Angles of the approach from the vertical that the map tells apart, radians."""
TURNS = (0.0, np.pi / 6, np.pi / 3)
"""Turns of the block that are tried at each place, radians; after a quarter turn a cube looks the same."""
SPACING = 0.05
LAYOUT = 1
"""Raised whenever the map is made in another way than before."""

_RESTARTS = 8
_ALONG = 0.02
_PROBE = "block"


class Reachable(NamedTuple):
    """One way to a place.

    Attributes:
        arm: "left" or "right".
        tilt: angle of the approach from the vertical, radians.
        share: of the block's turns that were tried, how many can be taken like this, 0 to 1.
    """

    arm: str
    tilt: float
    share: float


@dataclass(frozen=True, eq=False)
class ReachMap:
    """The answer of `reach_map`.

    Attributes:
        table: the table.
        size: (3,) edges of the block, metres.
        x: (n,) places away from the robot, metres.
        y: (m,) places to its left, metres.
        share: (2, tilts, n, m) by arm (left, right) and tilt (`STEEPNESS`): the share of the block's turns that can be
            taken.
    """

    table: Box
    size: Array
    x: Array
    y: Array
    share: Array

    def at(self, x: float, y: float) -> tuple[Reachable, ...]:
        """The ways to take a block at the place of the grid nearest to (x, y), the least tilted first; none: no hand.

        Raises:
            InvalidGoal: the place is not finite or not on the table.
        """
        if not (np.isfinite(x) and np.isfinite(y)):
            raise InvalidGoal(f"a place on the table is two finite numbers, not {x} and {y}")
        half = self.table.half_extents
        low, high = self.table.position - half, self.table.position + half
        if not (low[0] <= x <= high[0] and low[1] <= y <= high[1]):
            raise InvalidGoal(
                f"({x:.3f}, {y:.3f}) is not on the table, which reaches from x = {low[0]:.3f} to {high[0]:.3f} "
                f"and from y = {low[1]:.3f} to {high[1]:.3f}"
            )
        row, column = int(np.argmin(np.abs(self.x - x))), int(np.argmin(np.abs(self.y - y)))
        ways = [
            Reachable(arm, tilt, float(self.share[side, steep, row, column]))
            for steep, tilt in enumerate(STEEPNESS)
            for side, arm in enumerate(ARMS)
            if self.share[side, steep, row, column] > 0
        ]
        return tuple(sorted(ways, key=lambda way: (way.tilt, -way.share)))

    def hands(self) -> Array:
        """(2, n, m) the best share of turns with any tilt, by arm."""
        return np.asarray(self.share.max(axis=1))

    def least_tilt(self) -> Array:
        """(n, m) the least tilt with which either hand takes some turn of the block, radians; NaN: out of reach."""
        within = self.share.max(axis=0) > 0
        return np.where(within.any(axis=0), np.array(STEEPNESS)[within.argmax(axis=0)], np.nan)


def reach_map(
    table: Box,
    size: tuple[float, float, float] = (0.05, 0.05, 0.05),
    *,
    spacing: float = SPACING,
    progress: bool = True,
    root: Path | None = None,
) -> ReachMap:
    """The map of a table: made once (a minute or so), then kept in the user's cache.

    Args:
        table: a fixed, level box.
        size: edges of the block, metres; its first two lie on the table.
        spacing: of the grid, metres.
        progress: whether a bar on standard error shows how far it is.
        root: where maps are kept, if not in the user's cache.

    Raises:
        InvalidScene: the table is not fixed or not level, or the spacing makes no sense.
        InvalidGoal: no hand can grasp a block of that size.
    """
    if not table.fixed or not np.allclose(np.abs(table.axes[2]), (0, 0, 1), atol=1e-6):
        raise InvalidScene(f"the reach map is for a fixed and level box, and {table.name!r} is not")
    if not (np.isfinite(spacing) and 0.005 <= spacing <= 0.5):
        raise InvalidScene(f"the spacing of the reach map is 0.005 to 0.5 m, not {spacing}")
    grasp_candidates(
        Scene((table, _probe(table, size, float(table.position[0]), float(table.position[1]), 0.0))), _PROBE
    )
    packages = [f"{name} {metadata.version(name)}" for name in ("pin", "mujoco", "example-robot-data")]
    place = [*table.position.tolist(), *table.orientation.tolist(), *table.size.tolist()]
    settings = {"layout": LAYOUT, "recipe": recipe().digest, "packages": packages, "table": place,
                "size": [float(edge) for edge in size], "spacing": spacing}  # fmt: skip
    key = "reach-" + hashlib.sha256(json.dumps(settings, sort_keys=True).encode()).hexdigest()[:16]

    def build(folder: Path) -> None:
        x, y = _places(table, spacing)
        bar = ProgressBar("Mapping what the arms reach", len(x) * len(ARMS)) if progress else None
        share = _mapped(table, size, x, y, (lambda: None) if bar is None else bar.step)
        if bar is not None:
            bar.close()
        for name, values in {"x": x, "y": y, "share": share}.items():
            np.save(folder / f"{name}.npy", values)

    folder = cached_folder(key, build, root)
    x, y, share = (frozen(np.load(folder / f"{name}.npy")) for name in ("x", "y", "share"))
    return ReachMap(table, frozen(size), x, y, share)


def _places(table: Box, spacing: float) -> tuple[Array, Array]:
    """Places of the grid, symmetric about the table's middle, none on its edge."""
    both = []
    for axis in (0, 1):
        count = max(1, int(np.floor(2 * table.half_extents[axis] / spacing + 1e-6)))
        both.append(table.position[axis] + (np.arange(count) - (count - 1) / 2) * spacing)
    return both[0], both[1]


def _probe(table: Box, size: tuple[float, float, float], x: float, y: float, turn: float) -> Box:
    height = table.top + size[2] / 2
    return Box(_PROBE, np.array([x, y, height]), np.array([np.cos(turn / 2), 0, 0, np.sin(turn / 2)]), np.array(size))


def _mapped(table: Box, size: tuple[float, float, float], x: Array, y: Array, step: Callable[[], None]) -> Array:
    alone, share = Scene((table,)), np.zeros((len(ARMS), len(STEEPNESS), len(x), len(y)))
    rules = Rules(hand_clearance=CLOSE, close=frozenset({table.name}))
    for side, arm in enumerate(ARMS):
        free: dict[float, CollisionChecker] = {}
        for row, along in enumerate(x):
            for column, across in enumerate(y):
                seed: Array | None = None
                for turn in TURNS:
                    scene = Scene((table, _probe(table, size, along, across, turn)))
                    grasps = grasp_candidates(scene, _PROBE, (arm,))
                    for steep, tilt in enumerate(STEEPNESS):
                        for grasp in (one for one in grasps if abs(one.tilt) == tilt):
                            if grasp.opening not in free:
                                home = RobotState.home()
                                free[grasp.opening] = CollisionChecker(alone, home, arm, width=grasp.opening)
                            joints = _taken(grasp, free[grasp.opening], rules, seed)
                            if joints is not None:
                                seed = joints
                                share[side, steep, row, column] += 1 / len(TURNS)
                                break
            step()
    return np.minimum(share, 1.0)


def _taken(grasp: Grasp, checker: CollisionChecker, rules: Rules, seed: Array | None) -> Array | None:
    """Joints at the grasp from which the hand can back off and rise; None if there are none."""

    def free(joints: Array) -> bool:
        if checker.nearest(joints, rules) is not None:
            return False
        top = Pose(grasp.tool.position + np.array([0, 0, LIFT]), grasp.tool.orientation)
        for last in (grasp.backed(APPROACH), top):
            path = track(grasp.arm, _between(grasp.tool, last), joints)
            if path is None or any(checker.nearest(place, rules) is not None for place in path):
                return False
        return True

    try:
        return solve_ik(grasp.arm, grasp.tool, seed=seed, restarts=_RESTARTS, accept=free).joints
    except UnreachableTarget:
        return None


def _between(first: Pose, last: Pose) -> list[Pose]:
    way = last.position - first.position
    steps = int(np.ceil(np.linalg.norm(way) / _ALONG))
    return [Pose(first.position + way * (k / steps), first.orientation) for k in range(1, steps + 1)]
