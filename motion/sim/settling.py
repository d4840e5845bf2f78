"""Boxes on a table come to rest, by themselves or after random pushes; without the robot, so that it is fast.

Contacts are those of the recipe, as in `Simulator`: what rests here rests there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from motion.errors import InvalidScene, SimulationDiverged
from motion.physics_engine import mujoco
from motion.poses import Array, Pose
from motion.robot.recipe import recipe
from motion.scene import LEANING, Box, Scene

REST_SPEED = 1e-3
"""Speed in m/s and rad/s below which a box is at rest, once it has kept below it for `REST_TIME`."""
REST_TIME = 0.1
"""In simulated seconds."""
PENETRATION = 1e-3
"""Boxes at rest are at most so deep in each other, in metres; the soft contacts of a tower take a tenth of it."""
GUST = 0.125
"""For so many simulated seconds a force stays as it is."""
PUSHED = 0.3
"""Probability that a box is pushed during a gust."""
FORCE = (0.8, 1.6)
"""Of pushes, in weights of the box that is pushed: from about what slides it to what tumbles it."""

_WATCHED = 0.5
_NUDGES = 6
_GRAVITY = 9.81


@dataclass(frozen=True)
class Settled:
    """A scene that came to rest.

    Attributes:
        scene: the fixed boxes, and the loose ones that stayed, where they rest.
        fallen: names of the boxes that fell off the table and are not in the scene.
        leaning: names of those that stand on no face.
        seconds: simulated.
        resting: whether nothing moves any more.
        depth: the deepest penetration of any two boxes, metres.
    """

    scene: Scene
    fallen: tuple[str, ...]
    leaning: tuple[str, ...]
    seconds: float
    resting: bool
    depth: float

    @property
    def stable(self) -> bool:
        """True if everything that stayed is at rest, stands on a face, and is not inside another box."""
        return self.resting and not self.leaning and self.depth <= PENETRATION


def settle(scene: Scene, seconds: float = 3.0) -> Settled:
    """Let boxes come to rest.

    Args:
        scene: what is there, with at least one fixed box for a table.
        seconds: simulated at most.

    Raises:
        InvalidScene: no box is fixed, or none is loose.
        SimulationDiverged: the physics broke down.
    """
    physics = _Physics(scene)
    physics.rest(seconds, _WATCHED)
    return physics.settled()


def push_about(scene: Scene, rng: np.random.Generator, seconds: float = 2.5, rest: float = 3.0) -> Settled:
    """Push boxes by random level forces at their centres, then let them come to rest (Section V-A).

    A box that leans on another at the end is pushed a few times more. What falls off the table is taken away.

    Args:
        scene: what is there, with at least one fixed box for a table.
        rng: source of all chance.
        seconds: simulated, for which forces act.
        rest: simulated at most, after each time that forces acted.

    Raises:
        InvalidScene: no box is fixed, or none is loose.
        SimulationDiverged: the physics broke down.
    """
    physics = _Physics(scene)
    everything = np.ones(len(physics.loose), dtype=bool)
    for _ in range(round(seconds / GUST)):
        physics.gust(rng, everything, PUSHED)
    physics.rest(rest)
    for _ in range(_NUDGES):
        leaning = physics.leaning()
        if not leaning.any():
            break
        physics.gust(rng, leaning, 1.0)
        physics.rest(rest)
    return physics.settled()


class _Physics:
    """A simulation of boxes alone."""

    def __init__(self, scene: Scene) -> None:
        self.loose = tuple(box for box in scene.boxes if not box.fixed)
        self._fixed = tuple(box for box in scene.boxes if box.fixed)
        if not self.loose or not self._fixed:
            raise InvalidScene("a scene settles on what is fixed: it needs a fixed box, a table, and a loose one")
        self._model: Any = _model(scene)
        self._data: Any = mujoco.MjData(self._model)
        self._weights = _GRAVITY * np.array([box.mass for box in self.loose])
        self._ground = min(box.bottom for box in self._fixed)

    def gust(self, rng: np.random.Generator, which: np.ndarray, share: float) -> None:
        """Pushes some of the boxes `which`, (n,), each in a direction of its own, for `GUST`."""
        count = len(self.loose)
        angles = rng.uniform(0.0, 2 * np.pi, count)
        sizes = rng.uniform(*FORCE, count) * self._weights * (rng.random(count) < share) * which
        self._data.xfrc_applied[1:, 0] = sizes * np.cos(angles)
        self._data.xfrc_applied[1:, 1] = sizes * np.sin(angles)
        mujoco.mj_step(self._model, self._data, round(GUST / self._model.opt.timestep))
        self._data.xfrc_applied[:] = 0.0

    def rest(self, seconds: float, least: float = 0.0) -> None:
        """Lets time pass until nothing on the table moves, `seconds` at most, and `least` since the beginning."""
        steps = round(REST_TIME / 4 / self._model.opt.timestep)
        calm = 0
        for _ in range(round(seconds / self._model.opt.timestep / steps)):
            mujoco.mj_step(self._model, self._data, steps)
            calm = calm + 1 if self._still() else 0
            if calm >= 5 and self._data.time >= least:
                break

    def leaning(self) -> np.ndarray:
        """(n,) which boxes lie on the table but stand on no face."""
        quaternions = self._data.qpos.reshape(-1, 7)[:, 3:]
        w, x, y, z = quaternions.T
        rising = np.abs(np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]))
        return np.asarray(self._staying() & (rising.max(axis=0) < np.cos(LEANING)))

    def settled(self) -> Settled:
        """The scene as it is now."""
        if not (np.isfinite(self._data.qpos).all() and np.isfinite(self._data.qvel).all()):
            raise SimulationDiverged(f"the physics broke down at {self._data.time:.3f} s: positions are not finite")
        staying, leaning = self._staying(), self.leaning()
        mujoco.mj_forward(self._model, self._data)
        depths = -np.asarray(self._data.contact.dist)
        places = [Pose(row[:3], row[3:] / np.linalg.norm(row[3:])) for row in self._data.qpos.reshape(-1, 7)]
        kept = [box.at(place) for box, place, stays in zip(self.loose, places, staying, strict=True) if stays]
        return Settled(
            scene=Scene((*self._fixed, *kept)),
            fallen=tuple(box.name for box, stays in zip(self.loose, staying, strict=True) if not stays),
            leaning=tuple(box.name for box, leans in zip(self.loose, leaning, strict=True) if leans),
            seconds=float(self._data.time),
            resting=self._still(),
            depth=float(depths.max(initial=0.0)),
        )

    def _staying(self) -> np.ndarray:
        """(n,) which boxes did not fall: those whose centres are above the lowest fixed box's underside."""
        return np.asarray(self._data.qpos.reshape(-1, 7)[:, 2] > self._ground)

    def _still(self) -> bool:
        speeds: Array = np.abs(self._data.qvel.reshape(-1, 6)).max(axis=1)
        return bool((speeds[self._staying()] < REST_SPEED).all())


def _model(scene: Scene) -> Any:
    """The boxes of a scene, in its order, as a compiled model; nothing catches what falls."""
    contact = recipe().contact
    spec = mujoco.MjSpec()
    spec.option.timestep = contact["timestep"]
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = contact["impratio"]
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    for box in scene.boxes:
        place = {"pos": box.position, "quat": box.orientation}
        body = spec.worldbody if box.fixed else spec.worldbody.add_body(name=box.name, **place)
        if not box.fixed:
            body.add_freejoint()
        _add_geom(body, box, contact, place if box.fixed else {"mass": box.mass})
    return spec.compile()


def _add_geom(body: Any, box: Box, contact: dict[str, Any], more: dict[str, Any]) -> None:
    body.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=box.size / 2,
        friction=contact["box_friction"],
        solref=contact["box_solref"],
        solimp=contact["box_solimp"],
        **more,
    )
