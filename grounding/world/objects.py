"""Objects, worlds and viewpoints: frozen values, and the world files they are read from.

The frame: origin on the floor under the robot's base; x away from the robot, y to its left, z up; metres, radians;
quaternions w, x, y, z.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from grounding.errors import WorldError

Array = NDArray[np.float64]

SCHEMA = 1  # of files of worlds that name theirs
_KEYS = ("id", "type", "color", "position", "orientation", "size")
_UNIT_TOLERANCE = 1e-3  # on the quaternion's norm: files are written with few digits
_HUGE = 1e9  # no coordinate reaches this
_EXACT = 1e-12  # nearer to 1 a norm is left alone, so that what was written is what is read
FURNITURE = ("table", "robot", "floor")  # types that instructions do not mean by "block" or "object"


def _read_only(values: Iterable[float]) -> Array:
    array = np.array(tuple(values), dtype=np.float64)
    array.setflags(write=False)
    return array


@dataclass(frozen=True, eq=False)
class WorldObject:
    """One thing in the world.

    Attributes:
        id: its name, unique in a world.
        type: what it is ("block", "table", "robot" for a hand, ...); open.
        color: its colour, "unknown" if nobody knows.
        position: centre in the world's frame, shape (3,) in [m].
        orientation: unit quaternion w, x, y, z, shape (4,).
        size: full edges along its own axes, shape (3,) in [m].
    """

    id: str
    type: str
    color: str
    position: Array
    orientation: Array
    size: Array

    @cached_property
    def half_extents(self) -> Array:
        """Half edges of the box along the world's axes that encloses it, shape (3,) in [m]."""
        w, x, y, z = self.orientation
        rotation = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
        return np.asarray(np.abs(rotation) @ self.size / 2)

    def moved(self, position: Iterable[float], orientation: Iterable[float] | None = None) -> WorldObject:
        """The same object elsewhere."""
        turned = self.orientation if orientation is None else _read_only(orientation)
        return WorldObject(self.id, self.type, self.color, _read_only(position), turned, self.size)


@dataclass(frozen=True, eq=False)
class Viewpoint:
    """Where somebody stands and looks.

    Attributes:
        position: shape (3,) in [m].
        yaw: direction of the look about z, from x, in [rad].
    """

    position: Array
    yaw: float


ROBOT_VIEWPOINT = Viewpoint(_read_only((0.0, 0.0, 0.0)), 0.0)


@dataclass(frozen=True, eq=False)
class World:
    """Υ: the objects and, where known, the person who gives the instruction.

    Attributes:
        objects: in the order of the file; nothing may depend on it.
        speaker: the person's viewpoint, or None: then the robot's is the only one.
    """

    objects: tuple[WorldObject, ...]
    speaker: Viewpoint | None = None

    @cached_property
    def by_id(self) -> Mapping[str, WorldObject]:
        """The objects by their ids."""
        return {item.id: item for item in self.objects}

    @cached_property
    def things(self) -> tuple[WorldObject, ...]:
        """What instructions can mean by an object: everything but furniture, hands and floor; sorted by id."""
        return tuple(sorted((o for o in self.objects if o.type not in FURNITURE), key=lambda item: item.id))

    @cached_property
    def positions(self) -> Array:
        """Centres of `things`, shape (n, 3) in [m]."""
        array = np.array([item.position for item in self.things]).reshape(-1, 3)
        array.setflags(write=False)
        return array

    def __getitem__(self, object_id: str) -> WorldObject:
        try:
            return self.by_id[object_id]
        except KeyError:
            raise WorldError(f"no object {object_id!r} in this world; it has {_names(self.by_id)}") from None

    def with_objects(self, objects: Iterable[WorldObject]) -> World:
        """This world with other objects."""
        return World(tuple(objects), self.speaker)


def make_object(
    object_id: str,
    object_type: str = "block",
    color: str = "unknown",
    position: Iterable[float] = (0.0, 0.0, 0.0),
    orientation: Iterable[float] = (1.0, 0.0, 0.0, 0.0),
    size: Iterable[float] = (0.05, 0.05, 0.05),
) -> WorldObject:
    """Build an object, checked as an entry of a world file would be.

    Raises:
        WorldError: naming the object and the key.
    """
    entry = {"id": object_id, "type": object_type, "color": color, "position": list(position),
             "orientation": list(orientation), "size": list(size)}  # fmt: skip
    return _object(entry, 0)


def world_from_json(data: Any, source: str = "world") -> World:
    """Check plain values as a world file holds them and build the world.

    Args:
        data: what JSON gave.
        source: how to call it in messages, e.g. the file's name.

    Raises:
        WorldError: unknown or missing keys, duplicate ids, NaN, sizes that are not positive, quaternions that are not
            of unit length; names the source, the object and the key.
    """
    try:
        if not isinstance(data, dict):
            raise WorldError(f"a world is an object with the key 'objects', not {type(data).__name__}")
        _check_keys(data, ("objects",), ("speaker",), "the world")
        if not isinstance(data["objects"], list):
            raise WorldError("'objects' is a list of objects")
        objects = tuple(_object(entry, number) for number, entry in enumerate(data["objects"]))
        seen: set[str] = set()
        for item in objects:
            if item.id in seen:
                raise WorldError(f"object {item.id!r}: duplicate id; every id occurs once")
            seen.add(item.id)
        speaker = None if data.get("speaker") is None else _viewpoint(data["speaker"])
    except WorldError as error:
        raise WorldError(f"{source}: {error}") from None
    return World(objects, speaker)


def world_to_json(world: World) -> dict[str, Any]:
    """A world as plain values; `world_from_json` reads them back."""
    data: dict[str, Any] = {
        "objects": [
            {
                "id": item.id,
                "type": item.type,
                "color": item.color,
                "position": item.position.tolist(),
                "orientation": item.orientation.tolist(),
                "size": item.size.tolist(),
            }
            for item in world.objects
        ]
    }
    if world.speaker is not None:
        data["speaker"] = {"position": world.speaker.position.tolist(), "yaw": world.speaker.yaw}
    return data


def read_json(path: Path | str, what: str = "file") -> Any:
    """Read a JSON file.

    Raises:
        WorldError: the file is missing, unreadable, or not JSON; names the file and the place.
    """
    try:
        text = Path(path).read_text(encoding="utf-8")
    except FileNotFoundError:
        raise WorldError(f"{path}: no such {what}") from None
    except (OSError, UnicodeDecodeError) as error:
        raise WorldError(f"{path}: cannot be read as a {what}: {error}") from error
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:  # also an integer of thousands of digits
        detail = f"line {error.lineno}: {error.msg}" if isinstance(error, json.JSONDecodeError) else str(error)
        raise WorldError(f"{path}: not a whole JSON {what} ({detail}); is it truncated?") from error


def load_world(path: Path | str) -> World:
    """Read a world file.

    Raises:
        WorldError: see `world_from_json` and `read_json`.
    """
    return world_from_json(read_json(path, "world file"), str(path))


def load_worlds(path: Path | str) -> dict[str, World]:
    """Read a file of named worlds: a JSON object from names to worlds, or a single world, then named "".

    A file may name its format: `{"schema": 1, "worlds": {...}}`.

    Raises:
        WorldError: see `world_from_json` and `read_json`; the world's name is part of the message.
    """
    data = read_json(path, "worlds file")
    if isinstance(data, dict) and "objects" in data:
        return {"": world_from_json(data, str(path))}
    if not isinstance(data, dict):
        raise WorldError(f"{path}: a worlds file maps names to worlds, this one is a {type(data).__name__}")
    named = data.get("worlds") if "schema" in data else data
    if named is not data and (data["schema"] != SCHEMA or not isinstance(named, dict)):
        right = f'{{"schema": {SCHEMA}, "worlds": {{name: world}}}}'
        raise WorldError(f"{path}: 'schema' is {data['schema']!r}, or there are no 'worlds'; right would be {right}")
    return {name: world_from_json(entry, f"{path}: world {name!r}") for name, entry in dict(named or {}).items()}


def save_world(world: World, path: Path | str) -> None:
    """Write a world file, one object a line."""
    data = world_to_json(world)
    lines = ",\n  ".join(json.dumps(entry) for entry in data["objects"])
    speaker = f',\n "speaker": {json.dumps(data["speaker"])}' if "speaker" in data else ""
    Path(path).write_text(f'{{"objects": [\n  {lines}]{speaker}}}\n', encoding="utf-8")


def _names(names: Iterable[str]) -> str:
    listed = sorted(names)
    return ", ".join(listed[:12]) + (f" and {len(listed) - 12} more" if len(listed) > 12 else "") or "none"


def _check_keys(entry: Mapping[str, Any], required: tuple[str, ...], optional: tuple[str, ...], who: str) -> None:
    for key in entry:
        if key not in required + optional:
            raise WorldError(f"{who}: unknown key {key!r}; known are {', '.join(required + optional)}")
    for key in required:
        if key not in entry:
            raise WorldError(f"{who}: key {key!r} is missing")


def _numbers(value: Any, count: int, who: str, key: str) -> Array:
    if not isinstance(value, list | tuple) or len(value) != count:
        raise WorldError(f"{who}: {key!r} is a list of {count} numbers, not {value!r}")
    for number in value:
        if isinstance(number, bool) or not isinstance(number, int | float):
            raise WorldError(f"{who}: {key!r} holds {number!r}, which is no number")
        if not abs(number) < _HUGE:
            shown = f"{number!r}" if isinstance(number, float) else f"an integer of {number.bit_length()} bits"
            raise WorldError(f"{who}: {key!r} holds {shown}; every number is finite and below {_HUGE:g}")
    return _read_only(value)


def _object(entry: Any, number: int) -> WorldObject:
    if not isinstance(entry, dict):
        raise WorldError(f"object number {number}: is a {type(entry).__name__}, not an object with keys")
    named = isinstance(entry.get("id"), str)
    who = f"object {entry['id']!r}" if named else f"object number {number}"
    _check_keys(entry, _KEYS, (), who)
    for key in ("id", "type", "color"):
        if not isinstance(entry[key], str) or not entry[key].strip():
            raise WorldError(f"{who}: {key!r} is a text that is not empty, not {entry[key]!r}")
    if _has_reserved(entry["id"]):
        raise WorldError(f"{who}: 'id' has blanks or one of ( ) ; , in it, which names may not have")
    position = _numbers(entry["position"], 3, who, "position")
    orientation = _numbers(entry["orientation"], 4, who, "orientation")
    size = _numbers(entry["size"], 3, who, "size")
    if (size <= 0).any():
        raise WorldError(f"{who}: 'size' holds {size.min():g}; edges are longer than 0 m")
    norm = float(np.linalg.norm(orientation))
    if abs(norm - 1) > _UNIT_TOLERANCE:
        raise WorldError(f"{who}: 'orientation' has length {norm:.4g}; a quaternion w, x, y, z of length 1 is needed")
    if abs(norm - 1) > _EXACT:
        orientation = _read_only(orientation / norm)
    return WorldObject(entry["id"], entry["type"], entry["color"], position, orientation, size)


def _has_reserved(name: str) -> bool:
    """Whether a name holds a character that the notation of symbols uses."""
    return any(character.isspace() or character in "(){};," for character in name)


def _viewpoint(entry: Any) -> Viewpoint:
    if not isinstance(entry, dict):
        raise WorldError(f"'speaker': is a {type(entry).__name__}, not an object with 'position' and 'yaw'")
    _check_keys(entry, ("position", "yaw"), (), "'speaker'")
    yaw = _numbers([entry["yaw"]], 1, "'speaker'", "yaw")
    return Viewpoint(_numbers(entry["position"], 3, "'speaker'", "position"), float(yaw[0]))
