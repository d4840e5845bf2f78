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
from grounding.model.cases import Weights

VERSION = 1
_DIGITS = 5  # of a weight: two machines that differ in the last bits of a sum still write the same file


def save_weights(weights: Weights, path: Path, notes: Mapping[str, Any] | None = None) -> None:
    """Write weights; the same ones give the same bytes. The file appears whole or not at all.

    Args:
        weights: by the names of features.
        path: of the JSON file.
        notes: how they came about.
    """
    kept = {name: round(value, _DIGITS) for name, value in sorted(weights.items()) if round(value, _DIGITS)}
    data = {"version": VERSION, "notes": dict(notes or {}), "weights": kept, "sha256": _digest(kept)}
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    part.write_text(json.dumps(data, indent=0, sort_keys=True) + "\n", encoding="utf-8")
    os.replace(part, path)


def load_weights(path: Path) -> Weights:
    """Read weights.

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
    weights = data.get("weights")
    numbers = isinstance(weights, dict) and all(
        isinstance(v, int | float) and not isinstance(v, bool) and math.isfinite(v) for v in weights.values()
    )
    if not isinstance(weights, dict) or not numbers:
        raise ModelError(f"expected a number for every feature in {path}; `make weights` makes them anew")
    if data.get("sha256") != _digest(weights):
        raise ModelError(f"the weights {path} do not fit their digest; `make weights` makes them anew")
    return {name: float(value) for name, value in weights.items()}


def _digest(weights: Mapping[str, float]) -> str:
    text = "\n".join(f"{name} {float(value)!r}" for name, value in sorted(weights.items()))
    return hashlib.sha256(text.encode()).hexdigest()
