"""A scene as MuJoCo models: with exact shapes for physics, and with decimated visual meshes for pictures.

Models depend only on what cannot move (names, sizes, colours, masses, fixed poses), so that scenes which differ by
where their loose boxes are share one. Treat them as read-only; whoever changes one copies it first.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motion.errors import InvalidScene
from motion.physics_engine import mujoco
from motion.poses import Array, Pose
from motion.robot.build import robot_spec
from motion.robot.load import load_robot
from motion.robot.recipe import recipe
from motion.robot.state import ARMS, RobotState
from motion.scene import Box, Scene
from motion.threads import shared

BOX_PREFIX = "box/"


class SceneModel:
    """A compiled scene and the indices into it.

    Attributes:
        model: the MjModel.
        box_geoms: geom of each box, by name.
        box_qpos: address of each loose box's free joint in qpos, by name.
        box_dof: address of its velocity in qvel, by name.
        arm_qpos: (7,) addresses of an arm's joints in qpos, by arm.
        arm_dof: (7,) ditto in qvel.
        arm_joints: (7,) an arm's joints in the model.
        carried: (ngeom, 7) which of an arm's joints move a geom, by arm.
        arm_ctrl: (7,) an arm's actuators.
        finger_qpos: (2,) the left and right finger of each hand.
        gripper_ctrl: the gripper's actuator, by arm.
        bodies: name of the body or box of each geom; the floor is "floor".
        robot_geoms: (ngeom,) True for the robot's geoms.
        hand_geoms: (ngeom,) True for the geoms of an arm's gripper, by arm.
        finger_geoms: (2, ngeom) True for the geoms of an arm's left and right finger, by arm.
    """

    def __init__(self, model: Any, boxes: Iterable[Box]) -> None:
        self.model = model
        self.box_geoms: dict[str, int] = {}
        self.box_qpos: dict[str, int] = {}
        self.box_dof: dict[str, int] = {}
        for box in boxes:
            self.box_geoms[box.name] = model.geom(BOX_PREFIX + box.name).id
            if not box.fixed:
                joint = model.joint(BOX_PREFIX + box.name)
                self.box_qpos[box.name] = int(joint.qposadr[0])
                self.box_dof[box.name] = int(joint.dofadr[0])
        robot = load_robot()
        self.arm_qpos = {arm: _addresses(model, robot.arms[arm].joints, "qposadr") for arm in ARMS}
        self.arm_dof = {arm: _addresses(model, robot.arms[arm].joints, "dofadr") for arm in ARMS}
        self.arm_joints = {arm: np.array([model.joint(n).id for n in robot.arms[arm].joints]) for arm in ARMS}
        self.carried = {arm: _carried(model, self.arm_joints[arm]) for arm in ARMS}
        self.arm_ctrl = {arm: np.array([model.actuator(n).id for n in robot.arms[arm].joints]) for arm in ARMS}
        fingers = {arm: [f"{arm[0]}_gripper_{side}_finger_joint" for side in "lr"] for arm in ARMS}
        self.finger_qpos = {arm: _addresses(model, fingers[arm], "qposadr") for arm in ARMS}
        self.gripper_ctrl = {arm: int(model.actuator(f"{arm}_gripper").id) for arm in ARMS}
        names = [model.body(int(body)).name for body in model.geom_bodyid]
        boxed = {geom: name for name, geom in self.box_geoms.items()}
        self.bodies = tuple(boxed.get(i, "floor" if name == "world" else name) for i, name in enumerate(names))
        self.robot_geoms = np.array([i not in boxed and name != "floor" for i, name in enumerate(self.bodies)])
        self.hand_geoms = {
            arm: np.array([self.robot_geoms[i] and _of_hand(name, arm) for i, name in enumerate(self.bodies)])
            for arm in ARMS
        }

        self.finger_geoms = {
            arm: np.array([[n.startswith(f"{arm[0]}_gripper_{side}_finger") for n in self.bodies] for side in "lr"])
            for arm in ARMS
        }

    def write_boxes(self, data: Any, scene: Scene) -> None:
        """Puts the loose boxes of `scene` into `data.qpos`."""
        for box in scene.boxes:
            if not box.fixed:
                self.write_box(data, box.name, box.pose)

    def write_box(self, data: Any, name: str, pose: Pose) -> None:
        """Puts one loose box into `data.qpos`."""
        start = self.box_qpos[name]
        data.qpos[start : start + 3] = pose.position
        data.qpos[start + 3 : start + 7] = pose.orientation

    def write_robot(self, data: Any, state: RobotState) -> None:
        """Puts joints and fingers of `state` into `data.qpos`."""
        closed = recipe().gripper.closed
        for arm in ARMS:
            data.qpos[self.arm_qpos[arm]] = state.joints(arm)
            half = np.clip((state.widths[arm] - closed) / 2, 0, None)
            data.qpos[self.finger_qpos[arm]] = half, -half

    def read_box(self, data: Any, name: str) -> Pose:
        """Pose of a loose box from `data.qpos`."""
        start = self.box_qpos[name]
        return Pose(data.qpos[start : start + 3], data.qpos[start + 3 : start + 7])


def scene_model(scene: Scene, visuals: bool = False) -> SceneModel:
    """The compiled model of `scene`; scenes that differ by poses of loose boxes share it.

    Args:
        scene: what stands around the robot.
        visuals: whether the robot has its visual meshes, for pictures.
    """
    return _compiled(tuple(_Key(box) for box in scene.boxes), visuals)


class _Key:
    """A box up to what may change without compiling again."""

    def __init__(self, box: Box) -> None:
        self.box = box
        place = (tuple(box.position), tuple(box.orientation)) if box.fixed else ()
        self._values = (box.name, tuple(box.size), box.color, box.mass, box.fixed, place)

    def __hash__(self) -> int:
        return hash(self._values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Key) and self._values == other._values


@shared(maxsize=8)
def _compiled(keys: tuple[_Key, ...], visuals: bool) -> SceneModel:
    boxes = [key.box for key in keys]
    spec = robot_spec(load_robot().folder, recipe(), visuals)
    taken = {"floor", "world", *(body.name for body in spec.bodies)}
    for box in boxes:
        if box.name in taken:
            raise InvalidScene(f"a box cannot be named {box.name!r}: the floor or a link of the robot has that name")
    contact = recipe().contact
    spec.option.timestep = contact["timestep"]
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = contact["impratio"]
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    spec.worldbody.add_geom(
        name="floor",
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[5, 5, 0.1],
        rgba=[0.80, 0.82, 0.84, 1],
        friction=contact["box_friction"],
    )
    for box in boxes:
        place = {"pos": box.position, "quat": box.orientation}
        body = spec.worldbody if box.fixed else spec.worldbody.add_body(name=BOX_PREFIX + box.name, **place)
        if not box.fixed:
            body.add_freejoint(name=BOX_PREFIX + box.name)
        body.add_geom(
            name=BOX_PREFIX + box.name,
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=box.size / 2,
            rgba=box.color,
            friction=contact["box_friction"],
            solref=contact["box_solref"],
            solimp=contact["box_solimp"],
            **(place if box.fixed else {"mass": box.mass}),
        )
    if visuals:
        _light(spec)
    return SceneModel(spec.compile(), boxes)


def _light(spec: Any) -> None:
    visual = spec.visual
    visual.headlight.ambient = [0.3, 0.3, 0.3]
    visual.headlight.diffuse = [0.25, 0.25, 0.25]
    visual.headlight.specular = [0.05, 0.05, 0.05]
    visual.map.znear = 0.02
    spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        rgb1=[0.93, 0.95, 0.97],
        rgb2=[0.72, 0.77, 0.82],
        width=64,
        height=384,
    )
    lamp = {"type": mujoco.mjtLightType.mjLIGHT_DIRECTIONAL, "specular": [0.05, 0.05, 0.05], "ambient": [0.0, 0.0, 0.0]}
    spec.worldbody.add_light(pos=[1.5, 1.0, 3.0], dir=[-0.5, -0.35, -1.0], diffuse=[0.4, 0.4, 0.4], **lamp)
    spec.worldbody.add_light(
        pos=[1.5, -1.5, 3.0], dir=[-0.4, 0.5, -1.0], diffuse=[0.15, 0.15, 0.15], castshadow=0, **lamp
    )


def _addresses(model: Any, names: Iterable[str], field: str) -> Array:
    return np.array([int(getattr(model.joint(name), field)[0]) for name in names])


def _carried(model: Any, joints: Array) -> NDArray[np.bool_]:
    """(ngeom, n) whether a geom's body hangs on each of the joints."""
    hangs = np.zeros((model.nbody, len(joints)), bool)
    for body in range(1, model.nbody):
        hangs[body] = hangs[model.body_parentid[body]] | (model.jnt_bodyid[joints] == body)
    return hangs[np.asarray(model.geom_bodyid)]


def _of_hand(body: str, arm: str) -> bool:
    return body.startswith((f"{arm[0]}_gripper", f"{arm}_gripper"))
