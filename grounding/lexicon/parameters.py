"""The parameters of the concepts: every number that was set by hand, with its unit and range."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from grounding.errors import LexiconError
from grounding.lexicon.vocabulary import read_toml

PARAMETERS = Path(__file__).with_name("parameters.toml")
_KEYS = {"value", "unit", "range", "says"}


@dataclass(frozen=True)
class Parameter:
    """One number that was set by hand.

    Attributes:
        name: family and key, "direction.ahead".
        value: of the parameter.
        unit: in which it is.
        low: the smallest value that makes sense.
        high: the largest one.
        says: what it is.
    """

    name: str
    value: float
    unit: str
    low: float
    high: float
    says: str


@lru_cache(maxsize=1)
def parameters() -> Mapping[str, Parameter]:
    """The shipped parameters by name."""
    return read_parameters(PARAMETERS)


_values: dict[str, float] = {}


def value(name: str) -> float:
    """The value of a parameter, "direction.ahead"."""
    if not _values:
        _values.update({key: parameter.value for key, parameter in parameters().items()})
    return _values[name]


def values() -> tuple[float, ...]:
    """All values, so that what was found with others can be told from what holds now."""
    return tuple(_values.values())


@contextmanager
def varied(**changed: float) -> Iterator[None]:
    """Other values for as long as the context lasts, for measuring how much depends on them.

    Args:
        changed: values by name, with two underscores for the point: `direction__ahead=0.5`.

    Raises:
        LexiconError: there is no such parameter, or the value is out of its range.
    """
    wanted = {name.replace("__", "."): number for name, number in changed.items()}
    for name, number in wanted.items():
        if name not in parameters():
            raise LexiconError(f"there is no parameter {name!r}; known are {', '.join(sorted(parameters()))}")
        _check_range(name, number, parameters()[name].low, parameters()[name].high, "parameters")
        value(name)
    before = dict(_values)
    _values.update(wanted)
    try:
        yield
    finally:
        _values.update(before)


def read_parameters(path: Path) -> Mapping[str, Parameter]:
    """Read a file of parameters.

    Args:
        path: of a TOML file with a section for every family, see `parameters.toml`.

    Raises:
        LexiconError: the file is missing or no TOML, an entry lacks a key or is out of its range, or the names are not
            those of the shipped file; names file, entry and what would be right.
    """
    found: dict[str, Parameter] = {}
    for family, entries in read_toml(path, "parameters").items():
        if not isinstance(entries, dict):
            raise LexiconError(f"{path}: expected [{family}] to be a section and found {entries!r}")
        for key, entry in entries.items():
            name = f"{family}.{key}"
            found[name] = _parameter(path, name, entry)
    if path != PARAMETERS:
        for name in sorted(set(found) ^ set(parameters())):
            said = "is missing" if name in parameters() else "is no parameter of a concept"
            raise LexiconError(f"{path}: {name} {said}")
    return found


def _parameter(path: Path, name: str, entry: Any) -> Parameter:
    if not isinstance(entry, dict) or set(entry) != _KEYS:
        raise LexiconError(f"{path}: {name}: expected {{value, unit, range, says}} and found {entry!r}")
    limits = entry["range"]
    if not isinstance(limits, list) or len(limits) != 2 or not all(_is_number(limit) for limit in limits):
        raise LexiconError(f"{path}: {name}: expected a range of two numbers and found {limits!r}")
    if not _is_number(entry["value"]):
        raise LexiconError(f"{path}: {name}: expected a number and found {entry['value']!r}")
    _check_range(name, entry["value"], limits[0], limits[1], str(path))
    return Parameter(name, float(entry["value"]), str(entry["unit"]), float(limits[0]), float(limits[1]), entry["says"])


def _is_number(item: Any) -> bool:
    return isinstance(item, int | float) and not isinstance(item, bool)


def _check_range(name: str, number: float, low: float, high: float, source: str) -> None:
    if not low <= number <= high:
        raise LexiconError(f"{source}: {name} = {number} is out of range; it lies between {low} and {high}")
