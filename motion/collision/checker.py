"""Contact checks of whole configurations: both arms, the boxes, and what the hand holds as part of the robot.

MuJoCo's collision detection on a copy of the scene's model whose robot has a margin, so that whatever comes nearer
than the margin is listed with its distance. Pairs that the robot's SRDF disables are left out, and boxes are not
checked against one another, unless one of them is held.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motion.collision.clearance import CLEARANCE, CLOSE, Near, Rules
from motion.collision.grid import GRID, bisected, dense, resampled
from motion.collision.scene_model import SceneModel, scene_model
from motion.physics_engine import mujoco
from motion.poses import Array, Pose
from motion.robot.state import RobotState
from motion.scene import Scene
from motion.threads import per_thread

_RESTING_OVERLAP = 0.003
_ROBOT, _THINGS = 1, 2

Flags = NDArray[np.bool_]


class CollisionChecker:
    """Checks configurations of one arm while everything else stands still.

    Args:
        scene: where the boxes are.
        state: where the robot is; what `state.held` names moves with its hand.
        arm: the arm that moves.
        width: opening of its gripper, metres.
        held: name of the box in its hand, or None.
        grip: pose of that box in the tool frame.
    """

    def __init__(
        self,
        scene: Scene,
        state: RobotState,
        arm: str,
        *,
        width: float | None = None,
        held: str | None = None,
        grip: Pose | None = None,
    ) -> None:
        self._indices = scene_model(scene)
        space = _workspace(self._indices, held)
        self._model, self._data, self._mine = space.model, space.data, space.mine
        self._arm = arm
        widths = dict(state.widths)
        if width is not None:
            widths[arm] = width
        self._indices.write_boxes(self._data, scene)
        self._indices.write_robot(self._data, RobotState(state.left, state.right, widths, state.held))
        self._positions = np.array(self._data.qpos)
        self._held, self._grip = held, grip
        self._hand = self._indices.hand_geoms[arm].copy()
        if held is not None:
            self._hand[self._indices.box_geoms[held]] = True
        robot = self._indices.robot_geoms
        self._boxes = ~robot
        self._held_elsewhere = [
            (self._indices.hand_geoms[side], np.arange(len(robot)) == self._indices.box_geoms[name])
            for side, name in state.held.items()
            if side != arm and name in self._indices.box_geoms
        ]
        self._tables: dict[Rules, Array] = {}
        self._site = int(self._model.site(f"{arm}_tool").id)
        self._held_geom = -1 if held is None else self._indices.box_geoms[held]
        self._held_body = int(self._model.geom_bodyid[self._held_geom])
        self._grip_rotation = np.eye(3) if grip is None else grip.rotation

    def nearest(self, joints: Array, rules: Rules) -> Near | None:
        """The pair that breaks `rules` most when the arm is at `joints` (7,), or None."""
        self._place(joints)
        if self._data.ncon == 0:
            return None
        geoms, distances = self._data.contact.geom, self._data.contact.dist
        excess = self._required(rules)[geoms[:, 0], geoms[:, 1]] - distances
        worst = int(np.argmax(excess))
        if excess[worst] <= 0:
            return None
        first, second = geoms[worst]
        x, y, z = self._data.contact.pos[worst].tolist()
        return Near((self._indices.bodies[first], self._indices.bodies[second]), float(distances[worst]), (x, y, z))

    def distances(self, joints: Array, rules: Rules, within: float) -> list[tuple[float, float, Array]]:
        """Pairs of bodies that are near when the arm is at `joints` (7,).

        Args:
            joints: radians.
            rules: what may be near to what.
            within: how near, metres.

        Returns:
            the distance of each pair and what `rules` ask for in metres, and the slope of the distance over the joints,
            (7,) in metres a radian, by the Jacobians of both bodies at the place between them.
        """
        space = _workspace(self._indices, self._held, within)
        here, self._model, self._data = (self._model, self._data), space.model, space.data
        try:
            self._place(joints)
            return self._sloped(self._required(rules))
        finally:
            self._model, self._data = here

    def _sloped(self, required: Array) -> list[tuple[float, float, Array]]:
        data = self._data
        if data.ncon == 0:
            return []
        pairs = np.array(data.contact.geom)
        wanted = required[pairs[:, 0], pairs[:, 1]]
        together = self._hand[pairs[:, 0]] & self._hand[pairs[:, 1]]
        kept = np.flatnonzero(np.isfinite(wanted) & ~together)
        pairs, wanted, gaps = pairs[kept], wanted[kept], np.array(data.contact.dist)[kept]
        normals, places = data.contact.frame[kept, :3], data.contact.pos[kept]
        # The distance grows as the second body's point moves along the normal and the first one's against it.
        carried = self._indices.carried[self._arm].copy()
        if self._held is not None:
            carried[self._held_geom] = True
        signs = carried[pairs[:, 1]].astype(np.float64) - carried[pairs[:, 0]]
        joints = self._indices.arm_joints[self._arm]
        arms = places[:, None] - data.xanchor[joints]
        slopes = np.einsum("cjk,ck->cj", np.cross(data.xaxis[joints], arms), normals) * signs
        moving = np.flatnonzero(np.any(np.abs(slopes) > 1e-9, axis=1))
        return [(float(gaps[k]), float(wanted[k]), slopes[k]) for k in moving]

    def around_held(self, joints: Array, distance: float) -> frozenset[str]:
        """Names of the bodies other than the robot that are within `distance` of the held box at `joints` (7,)."""
        self._place(joints)
        if self._held is None:
            return frozenset()
        held = self._indices.box_geoms[self._held]
        found = set()
        for (first, second), gap in zip(self._data.contact.geom, self._data.contact.dist, strict=True):
            if held in (first, second) and gap <= distance:
                other = int(second if first == held else first)
                if self._boxes[other]:
                    found.add(self._indices.bodies[other])
        return frozenset(found)

    def of_hand(self, near: Near) -> bool:
        """Tells whether a box is near the moving hand, or what it holds: no other posture of the arm parts them."""
        fixed, hand = [], []
        for name in near.bodies:
            geoms = np.array([other == name for other in self._indices.bodies])
            hand.append(bool(np.any(geoms & self._hand)))
            fixed.append(bool(np.any(geoms & self._boxes & ~self._hand)))
        return (hand[0] and fixed[1]) or (hand[1] and fixed[0])

    def first_conflict(self, path: Sequence[Array], rules: Rules, grid: float = GRID) -> Near | None:
        """The first conflict along straight lines in joint space through `path`, on the grid, or None."""
        return self._first(dense(path, grid), rules)

    def conflict_of(self, positions: Array, rules: Rules) -> Near | None:
        """The first conflict along the (n, 7) samples of a trajectory, on the grid, or None."""
        return self._first(resampled(positions, GRID), rules)

    def _first(self, configurations: Iterable[Array], rules: Rules) -> Near | None:
        for joints in configurations:
            near = self.nearest(joints, rules)
            if near is not None:
                return near
        return None

    def free(self, first: Array, second: Array, rules: Rules, grid: float = GRID) -> bool:
        """Tells whether the line between two configurations is free, by halves, so that conflicts show early."""
        steps = max(1, int(np.ceil(np.max(np.abs(second - first)) / grid)))
        return all(self.nearest(first + (second - first) * k / steps, rules) is None for k in bisected(steps))

    def _place(self, joints: Array) -> None:
        """Moves the arm, and the held box with it, and finds what is near to what."""
        model, data, indices = self._model, self._data, self._indices
        data.qpos[:] = self._positions
        data.qpos[indices.arm_qpos[self._arm]] = joints
        mujoco.mj_kinematics(model, data)
        if self._held is not None and self._grip is not None:
            # Only what collision detection reads is written; the box's free joint would need the kinematics once more.
            rotation = data.site_xmat[self._site].reshape(3, 3)
            position = data.site_xpos[self._site] + rotation @ self._grip.position
            turned = (rotation @ self._grip_rotation).ravel()
            geom, body = self._held_geom, self._held_body
            data.xpos[body] = data.xipos[body] = data.geom_xpos[geom] = position
            data.xmat[body] = data.ximat[body] = data.geom_xmat[geom] = turned
        mujoco.mj_collision(model, data)

    def _required(self, rules: Rules) -> Array:
        """(ngeom, ngeom) least distance that each pair of geoms keeps by `rules`, metres."""
        if rules in self._tables:
            return self._tables[rules]
        mine, hand, boxes = self._mine, self._hand, self._boxes
        held = np.zeros(len(mine), bool)
        if self._held is not None:
            held[self._held_geom] = True
        names = np.array(self._indices.bodies)
        touching = boxes & np.isin(names, list(rules.touching)) & ~held
        resting = boxes & np.isin(names, list(rules.resting)) & ~held
        table = np.full((len(mine), len(mine)), -np.inf)
        table[mine, :] = table[:, mine] = rules.clearance
        _both(table, hand, boxes & ~held, rules.hand_clearance)
        _both(table, hand, boxes & ~held & np.isin(names, list(rules.close)), min(CLOSE, rules.hand_clearance))
        _both(table, hand, hand, 0.0)
        _both(table, hand, held, -np.inf)
        _both(table, hand, touching, -np.inf)
        _both(table, held, resting, -_RESTING_OVERLAP)
        for other_hand, box in self._held_elsewhere:
            _both(table, other_hand, box, -np.inf)
        self._tables[rules] = table
        return table


class _Workspace(NamedTuple):
    """Model and data that checkers of the same bodies share, each writing all positions before it looks.

    Attributes:
        model: the MjModel with the margins and the pairs that matter.
        data: its MjData.
        mine: (ngeom,) True for the geoms of the robot and of what it holds.
    """

    model: Any
    data: Any
    mine: Flags


@per_thread(maxsize=16)
def _workspace(indices: SceneModel, held: str | None, margin: float = CLEARANCE) -> _Workspace:
    model = copy.copy(indices.model)
    model.opt.enableflags = 0
    mine = indices.robot_geoms.copy()
    if held is not None:
        mine[indices.box_geoms[held]] = True
    solid = (model.geom_contype | model.geom_conaffinity) != 0
    model.geom_contype[:] = np.where(mine & solid, _ROBOT, np.where(solid, _THINGS, 0))
    model.geom_conaffinity[:] = np.where(mine & solid, _ROBOT | _THINGS, 0)
    model.geom_margin[mine] = margin
    model.geom_gap[:] = 0
    # The broad phase has margins of its own, per body, which compiling would have set.
    model.body_margin[np.unique(model.geom_bodyid[mine])] = margin
    return _Workspace(model, mujoco.MjData(model), mine)


def _both(table: Array, first: Flags, second: Flags, value: float) -> None:
    table[np.ix_(first, second)] = value
    table[np.ix_(second, first)] = value
