"""Worlds of the paper's XML corpus as worlds of this project.

The recordings give no sizes: blocks are cubes of 5 cm. The table's recorded origin is not its centre; its top is put
where the lowest block rests and its size is one on which all recorded blocks lie. Colours read "na" and become
"unknown". Names are shortened as far as they stay unique in their world.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

import numpy as np

from grounding.corpus.elements import Element
from grounding.errors import CorpusError
from grounding.world import World, WorldObject, make_object

BLOCK_EDGE = 0.05  # [m]
TABLE_SIZE = (0.7, 1.8, 0.04)  # [m]; the recorded blocks lie within 0.65 m x 1.75 m around the table's x and y
TABLE_TOP = 0.711  # z in [m], for a world without blocks
HAND_SIZE = (0.1, 0.1, 0.1)  # [m]
FLOOR_SIZE = (10.0, 10.0, 0.001)  # [m]
_SAME = 3  # digits of a position in [m] by which layouts are told apart


def short_names(world: Element) -> dict[str, str]:
    """Ids by recorded names: `object8-cube-cube-base` is `object8`, `baxter1-baxter-left_hand` is `left_hand`.

    A name that would start with a digit gets its type in front; one that would not be unique is kept whole.

    Raises:
        CorpusError: two objects of the same name.
    """
    short = {}
    for element in world.all("object"):
        name = element.get("name")
        if name in short:
            raise CorpusError(f"{element}: duplicate object {name!r}; every name occurs once in a world")
        parts = name.split("-")
        head = parts[-1] if element.get("type") == "robot" else parts[0]
        short[name] = f"{element.get('type')}{head}" if head[:1].isdigit() else head
    counts = Counter(short.values())
    return {name: head if counts[head] == 1 and head else name for name, head in short.items()}


def read_world(element: Element, names: Mapping[str, str]) -> World:
    """Translate a `<world>`.

    Args:
        element: with its objects.
        names: from `short_names`.

    Raises:
        CorpusError: numbers that cannot be read; names the line and the element.
        WorldError: an object that world files would refuse.
    """
    objects = [_object(child, names[child.get("name")]) for child in element.all("object")]
    lowest = min((item.position[2] - BLOCK_EDGE / 2 for item in objects if item.type == "block"), default=TABLE_TOP)
    height = round(float(lowest) - TABLE_SIZE[2] / 2, 6)
    return World(tuple(item.moved((*item.position[:2], height)) if item.type == "table" else item for item in objects))


def layout(world: World) -> tuple[object, ...]:
    """What tells one recorded world from another: which blocks lie where, to the millimetre."""
    return tuple((item.id, *(round(float(value), _SAME) for value in item.position)) for item in world.things)


def shifted(world: World, shift: float) -> World:
    """The world with its table, and everything that is not the robot's or the floor, moved along x by `shift` [m]."""
    offset = np.array([shift, 0.0, 0.0])
    return world.with_objects(
        item if item.type in ("robot", "floor") else item.moved(item.position + offset) for item in world.objects
    )


def _object(element: Element, object_id: str) -> WorldObject:
    kind = element.get("type")
    if kind == "na":
        kind = "floor" if "ground" in element.get("name") else "unknown"
    color = element.attributes.get("color", "na")
    x, y, z, w = _numbers(element, "orientation", 4)
    size = {"table": TABLE_SIZE, "robot": HAND_SIZE, "floor": FLOOR_SIZE}.get(kind, (BLOCK_EDGE,) * 3)
    return make_object(
        object_id,
        kind,
        "unknown" if color == "na" else color,
        _numbers(element, "position", 3),
        (w, x, y, z),
        size,
    )


def _numbers(element: Element, key: str, count: int) -> tuple[float, ...]:
    text = element.get(key)
    try:
        values = tuple(float(part) for part in text.split(","))
    except ValueError:
        values = ()
    if len(values) != count:
        raise CorpusError(f"{element}: {key!r} is {count} numbers with commas between them, not {text!r}")
    return values
