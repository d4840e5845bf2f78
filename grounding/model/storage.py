"""Learned weights on disk: one JSON file with the names of features, their weights and a digest of both."""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from grounding.errors import ModelError
from grounding.model.cases import Learned, Weights

VERSION = 3
_DIGITS = 5  # of a weight: two machines that differ in the last bits of a sum still write the same file


def save_learned(learned: Learned, path: Path, notes: Mapping[str, Any] | None = None) -> None:
    """Write what was learned; the same weights give the same bytes. The file appears whole or not at all.

    Args:
        learned: weights by the names of features.
        path: of the JSON file.
        notes: how they came about.
    """
    kept = {
        part: {name: round(value, _DIGITS) for name, value in sorted(weights.items())}
        for part, weights in learned._asdict().items()
    }
    data = {"version": VERSION, "notes": dict(notes or {}), **kept, "sha256": _digest(kept)}
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    part.write_text(json.dumps(data, indent=0, sort_keys=True) + "\n", encoding="utf-8")
    os.replace(part, path)


def load_learned(path: Path) -> Learned:
    """Read what was learned.

    Raises:
        ModelError: the file is missing, damaged or of another version; names it and what would be right.
    """
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ModelError(f"cannot read the weights {path}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise ModelError(f"the weights {path} are no JSON; `make weights` makes them anew") from error
    if not isinstance(data, dict) or data.get("version") != VERSION:
        raise ModelError(f"expected weights of version {VERSION} in {path}; `make weights` makes them anew")
    parts: dict[str, Any] = {part: data.get(part) for part in Learned._fields}
    if not all(_is_weights(weights) for weights in parts.values()):
        raise ModelError(f"expected a number for every feature in {path}; `make weights` makes them anew")
    if data.get("sha256") != _digest(parts):
        raise ModelError(f"the weights {path} do not fit their digest; `make weights` makes them anew")
    return Learned(**{part: Weights({n: float(v) for n, v in found.items()}) for part, found in parts.items()})


def _is_weights(weights: Any) -> bool:
    return isinstance(weights, dict) and all(
        isinstance(v, int | float) and not isinstance(v, bool) and math.isfinite(v) for v in weights.values()
    )


def _digest(parts: Mapping[str, Any]) -> str:
    text = "\n".join(
        f"{part} {name} {float(value)!r}" for part in sorted(parts) for name, value in sorted(parts[part].items())
    )
    return hashlib.sha256(text.encode()).hexdigest()
