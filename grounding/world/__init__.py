"""Worlds: objects and viewpoints, their files, and everything that is measured of them."""

from grounding.world.objects import (
    FURNITURE,
    ROBOT_VIEWPOINT,
    SCHEMA,
    Array,
    Viewpoint,
    World,
    WorldObject,
    load_world,
    load_worlds,
    make_object,
    read_json,
    save_world,
    world_from_json,
    world_to_json,
)

__all__ = [
    "FURNITURE",
    "ROBOT_VIEWPOINT",
    "SCHEMA",
    "Array",
    "Viewpoint",
    "World",
    "WorldObject",
    "load_world",
    "load_worlds",
    "make_object",
    "read_json",
    "save_world",
    "world_from_json",
    "world_to_json",
]
