"""Worlds of grounding become scenes of motion, and observed poses become worlds again."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from grounding.pictures.palette import color_of
from grounding.world import World, WorldObject
from motion import Box, Pose, Scene

DENSITY = 800.0
"""Of loose objects in [kg/m³], that of hard wood: a cube of 5 cm weighs 100 g."""
_SKIPPED = ("robot", "floor")
_FIXED = ("table",)
_LOOKS = {"table": (0.90, 0.88, 0.84, 1.0)}


def scene_of(world: World) -> Scene:
    """The scene that a world describes; hands, robot and floor are left out, for motion has its own.

    Raises:
        InvalidScene: motion cannot simulate an object; names it.
    """
    return Scene(tuple(_box(item) for item in world.objects if item.type not in _SKIPPED))


def world_at(world: World, poses: Mapping[str, Pose]) -> World:
    """The world with its objects where they were observed; objects that `poses` does not name stay."""
    return world.with_objects(
        item.moved(poses[item.id].position, poses[item.id].orientation) if item.id in poses else item
        for item in world.objects
    )


def _box(item: WorldObject) -> Box:
    red, green, blue = (value / 255 for value in color_of(item.color))
    return Box(
        name=item.id,
        position=item.position,
        orientation=item.orientation,
        size=item.size,
        color=_LOOKS.get(item.type, (red, green, blue, 1.0)),
        mass=round(float(DENSITY * np.prod(item.size)), 6),
        fixed=item.type in _FIXED,
    )
