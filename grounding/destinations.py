"""From a region to a metric destination: where an object's centre goes so that it is free and supported."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from grounding.geometry.regions import in_region
from grounding.result import Destination
from grounding.symbols import Region
from grounding.world import FURNITURE, Array, World, WorldObject

CLEARANCE = 0.03  # free space beside a placed object, so that fingers can leave it [m]
STEP = 0.01  # of the search for a free place [m]
FARTHEST = 0.4  # that it looks from what the words mean best [m]
FAR = 0.3  # what is so far from a thing is far from it [m]
MARGIN = 0.02  # from the table's edge [m]

_DIRECTIONS = {"left": (0.0, 1.0), "right": (0.0, -1.0), "back": (1.0, 0.0), "front": (-1.0, 0.0)}
_SIDES = {"near": "front", "far": "back"}  # of a table
_BATCH = 64  # places that are looked at together
_BESIDE = ("front", "left", "right", "back")


def find_destination(region: Region, moved: Iterable[str], world: World) -> Destination | None:
    """Where to put the first of some objects.

    Args:
        region: what the words say.
        moved: ids of the objects; the first is placed, none of them is in the way.
        world: as it is.

    Returns:
        the destination nearest to what the words mean that is free and supported; None where there is none.
    """
    names = list(moved)
    item = world[names[0]]
    if region.relation == "top" and region.objects and not _furniture(region, world):
        return _on_top(region, item, names, world)
    table = _table(world, item)
    if table is None or region.relation == "bottom":
        return None
    others = [o for o in world.objects if o.id not in names and o.type not in FURNITURE]
    height = float(table.position[2] + table.half_extents[2] + item.size[2] / 2)
    places = _candidates(region, item, world, table)
    places = places[free_places(places, item, others, table)]
    points = [(x, y, round(height, 5)) for x, y in np.round(places, 5).tolist()]
    for start in range(0, len(points), _BATCH):
        batch = points[start : start + _BATCH]
        fitting = np.flatnonzero(_obeys(region, [item.moved(point) for point in batch], world))
        if len(fitting):
            return Destination(batch[int(fitting[0])], region.relation, region.objects)
    return None


def _obeys(region: Region, placed: list[WorldObject], world: World) -> np.ndarray:
    """Which placed objects are where the words want them, as these would be understood of what is there."""
    if (region.relation == "center" and len(region.objects) < 2) or not region.objects:
        return np.ones(len(placed), dtype=bool)
    if region.relation in ("top", "far") and _furniture(region, world):
        return np.ones(len(placed), dtype=bool)
    if region.relation == "far":
        low, high = _bounds([world[name] for name in region.objects])
        points = np.array([item.position[:2] for item in placed])
        return np.linalg.norm(np.maximum(0.0, np.maximum(low - points, points - high)), axis=1) >= FAR / 2
    return in_region(region.relation, [world[name] for name in region.objects], placed)


def _furniture(region: Region, world: World) -> bool:
    return all(world[name].type in FURNITURE for name in region.objects)


def _table(world: World, item: WorldObject) -> WorldObject | None:
    tables = [o for o in world.objects if o.type == "table"]
    if not tables:
        return None
    return min(tables, key=lambda o: float(np.linalg.norm(o.position[:2] - item.position[:2])))


def _on_top(region: Region, item: WorldObject, names: list[str], world: World) -> Destination | None:
    support = max((world[name] for name in region.objects), key=lambda o: float(o.position[2] + o.half_extents[2]))
    top = float(support.position[2] + support.half_extents[2])
    for other in world.objects:
        if other.id in (support.id, *names) or other.type in FURNITURE:
            continue
        reach = other.half_extents + item.half_extents
        above = abs(float(other.position[2]) - top - float(item.size[2]) / 2) < float(reach[2]) * 0.9
        if above and np.all(np.abs(other.position[:2] - support.position[:2]) < reach[:2]):
            return None
    x, y = (float(value) for value in support.position[:2])
    return Destination((x, y, top + float(item.size[2]) / 2), "top", region.objects)


def _candidates(region: Region, item: WorldObject, world: World, table: WorldObject) -> Array:
    """Places on the floor plan, what fits the words best first, shape (n, 2) in [m]."""
    ideals = np.array(_ideals(region, item, [world[name] for name in region.objects], table))
    rings = [ideals]
    for radius in np.arange(STEP, FARTHEST, STEP):
        turns = max(8, int(2 * np.pi * radius / STEP / 2))
        angles = np.linspace(0, 2 * np.pi, turns, endpoint=False)
        around = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        rings.append((ideals[:, None] + around).reshape(-1, 2))
    return np.concatenate(rings)


def _bounds(references: list[WorldObject]) -> tuple[Array, Array]:
    low = np.min([o.position - o.half_extents for o in references], axis=0)[:2]
    high = np.max([o.position + o.half_extents for o in references], axis=0)[:2]
    return np.asarray(low), np.asarray(high)


def _ideals(region: Region, item: WorldObject, references: list[WorldObject], table: WorldObject) -> list[Array]:
    half = float(item.half_extents[:2].max())
    if region.kind == "robot" or not references:
        aside = _DIRECTIONS.get(region.relation, (0.0, 0.0))[1]
        away = np.array([1.0 if region.relation in ("far", "back") else -1.0, aside]) * table.half_extents[:2] / 2
        return [np.asarray(table.position[:2] + away)]
    low, high = _bounds(references)
    centre = (low + high) / 2
    if all(o.type in FURNITURE for o in references):
        half_of_it = _SIDES.get(region.relation, region.relation)
        if half_of_it in _DIRECTIONS:
            return [np.asarray(centre + np.array(_DIRECTIONS[half_of_it]) * (high - low) / 4)]
        return [item.position[:2] if region.relation == "top" else centre]
    if region.relation == "between" and len(references) == 2:
        return [np.asarray((references[0].position[:2] + references[1].position[:2]) / 2)]
    if region.relation in ("center", "between"):
        return [np.mean([o.position[:2] for o in references], axis=0)]
    away = (high - low) / 2 + half + (FAR if region.relation == "far" else CLEARANCE)
    if region.relation in _DIRECTIONS:
        return [np.asarray(centre + np.array(_DIRECTIONS[region.relation]) * away)]
    return [np.asarray(centre + np.array(_DIRECTIONS[side]) * away) for side in _BESIDE]


def free_places(places: Array, item: WorldObject, others: Sequence[WorldObject], table: WorldObject) -> np.ndarray:
    """Which places are on a table and clear of other objects, with room for fingers.

    Args:
        places: of an object's centre, shape (n, 2) in [m].
        item: the object.
        others: what it has to be clear of.
        table: what it shall stand on.

    Returns:
        boolean, shape (n,).
    """
    half = float(item.half_extents[:2].max())
    room = table.half_extents[:2] - MARGIN - half
    free = np.all(np.abs(places - table.position[:2]) <= room, axis=1)
    for other in others:
        reach = other.half_extents[:2] + half + CLEARANCE - 1e-6
        free &= np.any(np.abs(places - other.position[:2]) >= reach, axis=1)
    return free
