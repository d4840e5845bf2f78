"""Worlds from where they are: a MuJoCo model that somebody else simulates, and poses written back to it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from grounding.errors import WorldError
from grounding.world import Viewpoint, World, WorldObject, make_object
from integration.errors import UsageError
from motion.physics_engine import mujoco
from motion.poses import Pose, matrix, quaternion


def from_mujoco(
    model: Any,
    data: Any,
    *,
    tables: Sequence[str] = ("table",),
    only: Sequence[str] | None = None,
    types: Mapping[str, str] | None = None,
    base: str | None = None,
    speaker: Viewpoint | None = None,
) -> World:
    """The world that a MuJoCo model shows: what moves freely and is a box, on tables.

    Args:
        model: the MjModel.
        data: its MjData; kinematics are worked out anew.
        tables: names of bodies or geoms that are tables; each is or has one box that never moves.
        only: names of the bodies that count; by default all that have a free joint.
        types: what bodies are, by name; blocks where nothing is said.
        base: name of the body or site that stands where Baxter's does, on the floor and looking along x; by default
            that is where the model has its origin.
        speaker: where the person who speaks stands.

    Raises:
        UsageError: something that is named is not in the model, or no box.
    """
    mujoco.mj_kinematics(model, data)
    frame = _frame(model, data, base)
    names = [str(name) for name in only] if only is not None else _free_bodies(model)
    kinds = dict(types or {})
    for name in kinds:
        if name not in names:
            raise UsageError(f"types: there is no body {name!r} that moves freely; there are {_listed(names)}")
    objects = [_object(model, data, frame, _box_of(model, name), name, kinds.get(name, "block")) for name in names]
    objects += [_object(model, data, frame, _box_of(model, name), name, "table") for name in tables]
    return World(tuple(objects), speaker)


def write_poses(world: World, model: Any, data: Any, *, base: str | None = None) -> None:
    """Write where the things of a world are into a MuJoCo simulation; they come to rest there, everything else stays.

    Args:
        world: as `from_mujoco` gives it, with things moved.
        model: the MjModel.
        data: its MjData, which is written to.
        base: as for `from_mujoco`.

    Raises:
        UsageError: the model has no body for one of the things that moves freely.
    """
    mujoco.mj_kinematics(model, data)
    frame = _frame(model, data, base)
    free = _free_bodies(model)
    for item in world.things:
        if item.id not in free:
            raise UsageError(f"the model has no body {item.id!r} that moves freely; it has {_listed(free)}")
    for item in world.things:
        body = model.body(item.id)
        geom = _box_of(model, item.id)
        local = Pose(np.array(model.geom_pos[geom]), np.array(model.geom_quat[geom]))
        pose = frame @ Pose(item.position, item.orientation) @ local.inverse()
        at, dof = int(model.jnt_qposadr[body.jntadr[0]]), int(model.jnt_dofadr[body.jntadr[0]])
        data.qpos[at : at + 3], data.qpos[at + 3 : at + 7] = pose.position, pose.orientation
        data.qvel[dof : dof + 6] = 0.0
    mujoco.mj_forward(model, data)


def _free_bodies(model: Any) -> list[str]:
    """Names of the bodies that move freely."""
    free = [j for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    return [model.body(int(model.jnt_bodyid[j])).name for j in free]


def _box_of(model: Any, name: str) -> int:
    """The geom of a body, or the geom of that name, which has to be a box."""
    geom = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, name)
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name)
    if body >= 0:
        geoms = [g for g in range(model.ngeom) if model.geom_bodyid[g] == body]
        boxes = [g for g in geoms if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_BOX]
        if len(boxes) != 1 or len(geoms) != 1:
            raise UsageError(f"body {name!r} of the model has {len(geoms)} shapes, of which {len(boxes)} are boxes; "
                             "what is handled is one box")  # fmt: skip
        return boxes[0]
    if geom < 0:
        known = [model.body(b).name for b in range(1, model.nbody)]
        raise UsageError(f"the model has no body and no geom {name!r}; its bodies are {_listed(known)}")
    if model.geom_type[geom] != mujoco.mjtGeom.mjGEOM_BOX:
        raise UsageError(f"geom {name!r} of the model is no box")
    return int(geom)


def _frame(model: Any, data: Any, base: str | None) -> Pose:
    """The frame of the robot's base in that of the model."""
    if base is None:
        return Pose(np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0]))
    for kind, positions, rotations in (
        (mujoco.mjtObj.mjOBJ_BODY, data.xpos, data.xmat),
        (mujoco.mjtObj.mjOBJ_SITE, data.site_xpos, data.site_xmat),
    ):
        index = mujoco.mj_name2id(model, kind, base)
        if index >= 0:
            return Pose(np.array(positions[index]), quaternion(np.array(rotations[index]).reshape(3, 3)))
    raise UsageError(f"the model has no body and no site {base!r} for the robot to stand at")


def _object(model: Any, data: Any, frame: Pose, geom: int, name: str, kind: str) -> WorldObject:
    rotation = np.array(data.geom_xmat[geom]).reshape(3, 3)
    pose = frame.inverse() @ Pose(np.array(data.geom_xpos[geom]), quaternion(rotation))
    red, green, blue = (round(255 * float(value)) for value in model.geom_rgba[geom][:3])
    color = f"#{red:02x}{green:02x}{blue:02x}"
    size = 2 * np.array(model.geom_size[geom])
    if kind == "table" and not np.allclose(np.abs(matrix(pose.orientation)).round(3) % 1, 0):
        raise UsageError(f"the table {name!r} is not parallel to the axes of the robot's frame")
    if kind == "table":
        size, orientation = np.abs(matrix(pose.orientation)) @ size, np.array([1.0, 0.0, 0.0, 0.0])
    else:
        orientation = pose.orientation
    try:
        return make_object(name, kind, color, pose.position.tolist(), orientation.tolist(), size.tolist())
    except WorldError as error:
        raise UsageError(f"body {name!r} of the model: {error}") from error


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names) or "none"
