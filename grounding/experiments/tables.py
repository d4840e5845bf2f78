"""Tables as CSV files, as JSON, and as text for a terminal."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

_DIGITS = 6


def write_csv(path: Path, rows: Iterable[Any]) -> None:
    """Write named tuples, or mappings with the same keys, one a line under a line of their names."""
    plain = [_plain(row) for row in rows]
    if not plain:
        return
    part = path.with_name(path.name + ".part")
    with part.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(plain[0]))
        writer.writeheader()
        writer.writerows({key: _cell(value) for key, value in row.items()} for row in plain)
    os.replace(part, path)


def write_json(path: Path, content: Mapping[str, Any]) -> None:
    """Write plain values and named tuples."""
    part = path.with_name(path.name + ".part")
    part.write_text(json.dumps(jsonable(content), indent=1) + "\n", encoding="utf-8")
    os.replace(part, path)


def jsonable(value: Any) -> Any:
    """The same as plain values: named tuples become objects, numbers are rounded to six digits."""
    if hasattr(value, "_asdict"):
        return {key: jsonable(item) for key, item in value._asdict().items()}
    if isinstance(value, Mapping):
        return {str(key): jsonable(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [jsonable(item) for item in value]
    if isinstance(value, float):
        return float(f"{value:.{_DIGITS}g}")
    return value


def text_table(header: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """A table for a terminal, numbers to the right."""
    lines = [list(header), *([_shown(value) for value in row] for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    right = [all(_is_number(line[i]) for line in lines[1:]) for i in range(len(header))]
    return "\n".join(
        "  ".join(
            cell.rjust(width) if flush else cell.ljust(width)
            for cell, width, flush in zip(line, widths, right, strict=True)
        ).rstrip()
        for line in lines
    )


def _plain(row: Any) -> dict[str, Any]:
    return dict(row._asdict() if hasattr(row, "_asdict") else row)


def _cell(value: Any) -> Any:
    if isinstance(value, float):
        return f"{value:.{_DIGITS}g}"
    if isinstance(value, list | tuple):
        return " ".join(str(_cell(item)) for item in value)
    return "" if value is None else value


def _shown(value: Any) -> str:
    if value is None:
        return "-"
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def _is_number(text: str) -> bool:
    return text == "-" or text[:1].isdigit() or text[:1] in "+-."
