"""Builds the robot's files, and from them MuJoCo's description of it.

The files are one URDF, which Pinocchio and MuJoCo both read (MuJoCo's own XML keeps six digits, too few for both
kinematics to agree), the meshes as binary STL, and each arm alone as a compiled model. The MuJoCo description adds
what URDF cannot say: actuators, gravity compensation, the tendon that drives both fingers, the pairs of links that may
touch, the tool frames.
"""

from __future__ import annotations

import hashlib
import json
import sys
import xml.etree.ElementTree as ET
from importlib import metadata
from pathlib import Path
from typing import Any

from motion.cache import cached_folder
from motion.physics_engine import mujoco
from motion.progress_bar import ProgressBar
from motion.robot.description import PACKAGE, description_folder, disabled_pairs, overlaid_urdf
from motion.robot.meshes import write_hull, write_visual
from motion.robot.recipe import Recipe, recipe

ARM_JOINTS = ("s0", "s1", "e0", "e1", "w0", "w1", "w2")
LAYOUT = 3
"""Raised whenever this module writes other files than before."""


def robot_folder(progress: bool = True) -> Path:
    """The folder with `robot.urdf`, `pairs.json`, `arm_left.mjb`, `arm_right.mjb` and the meshes.

    Args:
        progress: whether a first build shows a progress bar on standard error.
    """
    versions = [metadata.version(name) for name in (PACKAGE, "mujoco", "pin", "trimesh", "fast-simplification")]
    text = "|".join([str(LAYOUT), recipe().digest, sys.byteorder, *versions])
    key = "robot-" + hashlib.sha256(text.encode()).hexdigest()[:16]
    return cached_folder(key, lambda folder: build(folder, recipe(), progress))


def build(folder: Path, settings: Recipe, progress: bool = True) -> None:
    """Writes all files of the robot into `folder`."""
    source = description_folder()
    urdf = overlaid_urdf(source, settings)
    visuals, hulls = _mesh_files(urdf)
    bar = ProgressBar("Building Baxter", len(visuals) + len(hulls) + 2) if progress else None
    total = 267_000
    for name, file in {**visuals, **hulls}.items():
        if name in hulls:
            write_hull(source / file, folder / name)
        else:
            write_visual(source / file, folder / name, settings.visual_faces / total)
        if bar:
            bar.step(Path(file).stem)
    (folder / "robot.urdf").write_text(ET.tostring(urdf, encoding="unicode"))
    (folder / "pairs.json").write_text(json.dumps(disabled_pairs(source)))
    if bar:
        bar.step("URDF")
    for arm in ("left", "right"):
        mujoco.mj_saveModel(_arm_model(folder, settings, arm), str(folder / f"arm_{arm}.mjb"))
    if bar:
        bar.step("arms")
        bar.close()


def _mesh_files(urdf: ET.Element) -> tuple[dict[str, str], dict[str, str]]:
    """Renames the meshes in `urdf` to flat STL names; new name to old, for visuals and for collision shapes."""
    found: tuple[dict[str, str], dict[str, str]] = ({}, {})
    for files, kind in zip(found, ("visual", "collision"), strict=True):
        for mesh in urdf.iterfind(f"link/{kind}/geometry/mesh"):
            old = mesh.get("filename", "")
            new = f"{kind}_{Path(old).stem}.stl"
            files[new] = old
            mesh.set("filename", new)
    return found


def robot_spec(folder: Path, settings: Recipe, visuals: bool) -> Any:
    """The robot as an MjSpec, to which a scene can be added.

    Args:
        folder: what `robot_folder` gives.
        settings: the recipe it was built by.
        visuals: whether it has its visual meshes.
    """
    urdf = ET.fromstring((folder / "robot.urdf").read_text())
    if not visuals:
        for link in urdf.findall("link"):
            for element in link.findall("visual"):
                link.remove(element)
    compiler = ET.SubElement(ET.SubElement(urdf, "mujoco"), "compiler")
    for key, value in {"discardvisual": "false", "fusestatic": "false", "strippath": "true"}.items():
        compiler.set(key, value)
    assets = {name: (folder / name).read_bytes() for name in {mesh.get("filename", "") for mesh in urdf.iter("mesh")}}
    spec = mujoco.MjSpec.from_string(ET.tostring(urdf, encoding="unicode"), assets=assets)
    spec.compiler.degree = False
    _joints(spec, settings)
    for body in spec.bodies[1:]:
        body.gravcomp = 1.0
    names = {body.name for body in spec.bodies}
    for first, second in json.loads((folder / "pairs.json").read_text()):
        if first in names and second in names:
            spec.add_exclude(bodyname1=first, bodyname2=second)
    for arm in ("left", "right"):
        spec.body(f"{arm}_gripper").add_site(name=f"{arm}_tool")
        _gripper(spec, arm, settings)
    for geom in spec.geoms:
        geom.group = 2 if geom.contype == 0 and geom.conaffinity == 0 else 3
        if geom.group == 3 and "finger" in geom.parent.name:
            # MuJoCo's friction is blind to the acceleration of a turning hand; a held box creeps by that acceleration
            # divided by the contact's damping. The stiffest contact that the time step allows keeps this below a
            # millimetre.
            geom.priority = 1
            geom.friction = settings.contact["finger_friction"]
            geom.solref[:] = settings.contact["finger_solref"]
            geom.solimp[:] = settings.contact["finger_solimp"]
    return spec


def _joints(spec: Any, settings: Recipe) -> None:
    gains = settings.actuators
    for arm in ("left", "right"):
        for i, short in enumerate(ARM_JOINTS):
            joint = spec.joint(f"{arm}_{short}")
            joint.armature = gains["armature"][i]
            joint.damping[:] = 0
            joint.frictionloss = 0
            joint.actfrclimited = 0
            _position_actuator(spec, joint.name, gains["kp"][i], gains["kv"][i], gains["effort"][i])
    head = spec.joint("head_pan")
    head.armature = 0.1
    head.actfrclimited = 0
    _position_actuator(spec, "head_pan", gains["head"]["kp"], gains["head"]["kv"], 50.0)


def _position_actuator(spec: Any, name: str, kp: float, kv: float, force: float, tendon: bool = False) -> None:
    actuator = spec.add_actuator(
        name=name,
        target=name,
        trntype=mujoco.mjtTrn.mjTRN_TENDON if tendon else mujoco.mjtTrn.mjTRN_JOINT,
        gaintype=mujoco.mjtGain.mjGAIN_FIXED,
        biastype=mujoco.mjtBias.mjBIAS_AFFINE,
        forcelimited=1,
        forcerange=[-force, force],
    )
    actuator.gainprm[0] = kp
    actuator.biasprm[:3] = [0, -kp, -kv]


def _gripper(spec: Any, arm: str, settings: Recipe) -> None:
    """One tendon, half the opening beyond the closed width, drives both fingers; an equality keeps them symmetric."""
    data = settings.gripper
    fingers = [f"{arm[0]}_gripper_{side}_finger_joint" for side in ("l", "r")]
    for name in fingers:
        joint = spec.joint(name)
        joint.armature = data.finger_armature
        joint.damping[:] = 0
        joint.damping[0] = data.finger_damping
        joint.actfrclimited = 0
    tendon = spec.add_tendon(name=f"{arm}_gripper")
    tendon.wrap_joint(fingers[0], 0.5)
    tendon.wrap_joint(fingers[1], -0.5)
    _position_actuator(spec, f"{arm}_gripper", data.kp, data.kv, data.force, tendon=True)
    equality = spec.add_equality(
        type=mujoco.mjtEq.mjEQ_JOINT, objtype=mujoco.mjtObj.mjOBJ_JOINT, name1=fingers[1], name2=fingers[0]
    )
    equality.data[:5] = [0, -1, 0, 0, 0]
    equality.solref[:] = data.equality_solref
    equality.solimp[:] = data.equality_solimp


def _arm_model(folder: Path, settings: Recipe, arm: str) -> Any:
    """One arm and nothing else: seven joints and the tool frame, for inverse kinematics."""
    spec = robot_spec(folder, settings, visuals=False)
    wanted = {f"{arm}_{short}" for short in ARM_JOINTS}
    for kind in (spec.actuators, spec.tendons, spec.equalities, spec.excludes, spec.geoms, spec.meshes):
        for element in list(kind):
            spec.delete(element)
    for joint in list(spec.joints):
        if joint.name not in wanted:
            spec.delete(joint)
    spec.option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    return spec.compile()
