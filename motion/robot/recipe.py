"""The numbers that make the robot, read from the shipped recipe: heights, gains, limits, the gripper, contacts."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType
from typing import Any

import models
from motion.poses import Array, frozen


@dataclass(frozen=True, eq=False)
class JointLimits:
    """Limits of the seven joints of an arm.

    Attributes:
        velocity: (7,) rad/s.
        acceleration: (7,) rad/s².
        jerk: (7,) rad/s³.
        position_margin: how far planning stays from the ends of the joints' ranges, radians.
    """

    velocity: Array
    acceleration: Array
    jerk: Array
    position_margin: float


@dataclass(frozen=True)
class GripperRecipe:
    """The parallel gripper with paddle tips.

    Attributes:
        closed: opening when the fingers meet their inner stop, metres.
        opened: opening at the outer stop, metres.
        force: limit of the actuator over both fingers, newtons.
        kp: stiffness of the actuator, N/m of half the opening.
        kv: damping of the actuator, N s/m.
        squeeze: how much narrower than the box the fingers are told to be, metres.
        finger_armature: added inertia of each finger's drive, kilograms.
        finger_damping: N s/m.
        equality_solref: softness of the constraint that keeps both fingers symmetric (MuJoCo's solref).
        equality_solimp: ditto (MuJoCo's solimp).
    """

    closed: float
    opened: float
    force: float
    kp: float
    kv: float
    squeeze: float
    finger_armature: float
    finger_damping: float
    equality_solref: list[float]
    equality_solimp: list[float]


@dataclass(frozen=True, eq=False)
class Recipe:
    """Everything the shipped recipe says; `digest` changes whenever it does."""

    base_height: float
    home: MappingProxyType[str, Array]
    visual_faces: int
    dummy_sphere_radius: float
    limits: JointLimits
    carrying_speed: float
    actuators: dict[str, Any]
    gripper: GripperRecipe
    inertia: dict[str, float]
    contact: dict[str, Any]
    digest: str


@lru_cache(maxsize=1)
def recipe() -> Recipe:
    """The shipped recipe, read once."""
    text = models.BAXTER_RECIPE.read_text()
    data = json.loads(text)
    limits = data["limits"]
    return Recipe(
        base_height=float(data["base_height"]),
        home=MappingProxyType({arm: frozen(joints) for arm, joints in data["home"].items()}),
        visual_faces=int(data["visual_faces"]),
        dummy_sphere_radius=float(data["dummy_sphere_radius"]),
        limits=JointLimits(
            frozen(limits["velocity"]),
            frozen(limits["acceleration"]),
            frozen(limits["jerk"]),
            limits["position_margin"],
        ),
        carrying_speed=float(data["carrying_speed"]),
        actuators=data["actuators"],
        gripper=GripperRecipe(**data["gripper"]),
        inertia=data["inertia"],
        contact=data["contact"],
        digest=hashlib.sha256(text.encode()).hexdigest()[:16],
    )
