"""The hand's boxes around a grasp, and whether they would overlap what stands beside: a check without any joints.

It knows the fingers only, as the boxes that the URDF gives them, so that what it refuses is surely impossible; the
whole configuration is for `collision.checker` to check.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pinocchio

from motion.poses import Array, Pose
from motion.robot.load import load_robot
from motion.robot.recipe import recipe
from motion.scene import Box

Pair = tuple[str, str]


class FingerBox(NamedTuple):
    """A box of a finger, with the gripper closed.

    Attributes:
        body: name of the link.
        centre: (3,) in the tool frame, metres.
        axes: (3, 3) directions of its edges in the tool frame, in columns.
        half: (3,) half its edges, metres.
        side: 1 or -1, the direction along the tool's y axis in which it moves when the gripper opens.
    """

    body: str
    centre: Array
    axes: Array
    half: Array
    side: float


@lru_cache(maxsize=2)
def finger_boxes(arm: str) -> tuple[FingerBox, ...]:
    """The boxes of both fingers of an arm, from its URDF.

    Raises:
        InvalidGoal: there is no such arm.
    """
    robot = load_robot()
    robot.arm(arm)
    model, data = robot.pinocchio, robot.pinocchio.createData()
    pinocchio.framesForwardKinematics(model, data, pinocchio.neutral(model))
    tool = data.oMf[model.getFrameId(f"{arm}_gripper")]
    found = []
    for link in ET.fromstring((robot.folder / "robot.urdf").read_text()).findall("link"):
        body = link.get("name", "")
        if not body.startswith(f"{arm[0]}_gripper_") or "finger" not in body:
            continue
        frame = tool.actInv(data.oMf[model.getFrameId(body)])
        for collision in link.findall("collision"):
            shape = collision.find("geometry/box")
            if shape is None:
                continue
            origin = collision.find("origin")
            xyz, rpy = (_numbers(origin, key) for key in ("xyz", "rpy"))
            placement = frame * pinocchio.SE3(pinocchio.rpy.rpyToMatrix(*rpy), xyz)
            half = _numbers(shape, "size") / 2
            found.append(FingerBox(body, np.array(placement.translation), np.array(placement.rotation), half, 0.0))
    tips = {box.body.removesuffix("_tip"): float(np.sign(box.centre[1])) for box in found if box.body.endswith("_tip")}
    return tuple(box._replace(side=tips[box.body.removesuffix("_tip")]) for box in found)


def obstacles(arm: str, tools: Sequence[Pose], openings: Sequence[float], boxes: Sequence[Box]) -> list[Pair | None]:
    """For each pose of an open hand the finger and the box that overlap most, or None.

    Args:
        arm: "left" or "right".
        tools: n poses of the tool frame in the world's frame.
        openings: n openings of the gripper, metres.
        boxes: what stands around; not what is to be grasped.
    """
    found: list[Pair | None] = [None] * len(tools)
    if not boxes or not tools:
        return found
    fingers = finger_boxes(arm)
    rotation = np.array([tool.rotation for tool in tools])
    moved = np.maximum(0.0, np.asarray(openings) - recipe().gripper.closed) / 2
    shift = moved[:, None] * np.array([finger.side for finger in fingers])
    local = np.array([finger.centre for finger in fingers]) + shift[..., None] * np.array([0.0, 1.0, 0.0])
    centres = np.array([tool.position for tool in tools])[:, None] + local @ np.swapaxes(rotation, 1, 2)
    axes = rotation[:, None] @ np.array([finger.axes for finger in fingers])
    halves = np.array([finger.half for finger in fingers])
    extents = np.einsum("nfki,fi->nfk", np.abs(axes), halves)
    others = np.array([box.position for box in boxes])
    gaps = np.abs(centres[:, :, None] - others) - extents[:, :, None] - np.array([box.half_extents for box in boxes])
    which, finger, box = np.nonzero(np.all(gaps < 0, axis=3))
    if not len(which):
        return found
    sides = np.array([other.axes for other in boxes]), np.array([other.size / 2 for other in boxes])
    depths = overlaps(
        centres[which, finger], axes[which, finger], halves[finger], others[box], sides[0][box], sides[1][box]
    )
    for index in np.argsort(depths):  # the deepest last
        if depths[index] > 0:
            found[which[index]] = (fingers[finger[index]].body, boxes[box[index]].name)
    return found


def overlaps(
    first: Array, first_axes: Array, first_half: Array, second: Array, second_axes: Array, second_half: Array
) -> Array:
    """Depths of the overlaps of pairs of boxes, along the best of fifteen axes (Gottschalk et al., "OBBTree", 1996).

    Args:
        first: (n, 3) centres, metres.
        first_axes: (n, 3, 3) directions of the edges, in columns.
        first_half: (n, 3) half the edges, metres.
        second: (n, 3), as `first`.
        second_axes: (n, 3, 3).
        second_half: (n, 3).

    Returns:
        (n,) depths in metres; where negative, the boxes are apart by at least that much.
    """
    between = second - first
    a, b = np.swapaxes(first_axes, 1, 2), np.swapaxes(second_axes, 1, 2)
    crossed = np.cross(np.repeat(a, 3, axis=1), np.tile(b, (1, 3, 1)))
    lengths = np.linalg.norm(crossed, axis=2, keepdims=True)
    # Parallel edges span no plane; an edge's own direction, which is tested anyway, stands in.
    crossed = np.where(lengths > 1e-6, crossed / np.maximum(lengths, 1e-6), np.repeat(a, 3, axis=1))
    directions = np.concatenate([a, b, crossed], axis=1)
    reach = np.einsum("ndi,ni->nd", np.abs(directions @ first_axes), first_half)
    reach += np.einsum("ndi,ni->nd", np.abs(directions @ second_axes), second_half)
    return np.asarray(np.min(reach - np.abs(np.einsum("ndk,nk->nd", directions, between)), axis=1))


def _numbers(element: ET.Element | None, key: str) -> Array:
    text = None if element is None else element.get(key)
    return np.zeros(3) if text is None else np.array([float(part) for part in text.split()])
