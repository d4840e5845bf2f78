"""Weights on disk: `NAME.npz` holds the numbers, `NAME.json` the names and how they came about. Never pickle.

The weights of a first pass come after those of the factors, in the same two files; files without them are read as well.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from grounding.errors import ModelError
from grounding.factors.factor import Factor
from grounding.factors.first_pass import FirstPass
from grounding.factors.model import FactorModel

VERSION = 2
_FIRST_PASS = "first_pass"
_DIGITS = 5  # of a weight: two machines that differ in the last bits of a sum still write the same file
_EPOCH = (1980, 1, 1, 0, 0, 0)
_DAMAGE = (OSError, ValueError, LookupError, TypeError, AttributeError, EOFError, RecursionError, NotImplementedError,
           zlib.error, zipfile.BadZipFile)  # fmt: skip


def save_model(model: FactorModel, path: Path) -> None:
    """Write `path`.npz and `path`.json; the same model gives the same bytes. Files appear whole or not at all.

    Args:
        model: what to write.
        path: without ending.
    """
    names: dict[str, Any] = {}
    arrays: dict[str, np.ndarray] = {}
    for family, factor in sorted(model.factors.items()):
        names[family] = _pack(family, factor, arrays)
    data = {"version": VERSION, "notes": dict(model.notes), "factors": names}
    if model.first_pass is not None:
        packed_names = _pack(_FIRST_PASS, model.first_pass.factor, arrays)
        data[_FIRST_PASS] = {**packed_names, "threshold": round(model.first_pass.threshold, _DIGITS)}
    path.parent.mkdir(parents=True, exist_ok=True)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, array in arrays.items():
            buffer = io.BytesIO()
            np.lib.format.write_array(buffer, np.ascontiguousarray(array), allow_pickle=False)
            archive.writestr(zipfile.ZipInfo(f"{name}.npy", _EPOCH), buffer.getvalue(), zipfile.ZIP_DEFLATED, 9)
    digest = hashlib.sha256(packed.getvalue()).hexdigest()
    text = json.dumps({**data, "sha256": digest}, indent=0, sort_keys=True) + "\n"
    _replace(path.with_suffix(".npz"), packed.getvalue())
    _replace(path.with_suffix(".json"), text.encode())


def load_model(path: Path) -> FactorModel:
    """Read what `save_model` wrote.

    Raises:
        ModelError: a file is missing, damaged, or of another version.
    """
    data = _names(path.with_suffix(".json"))
    weights_path = path.with_suffix(".npz")
    factors: dict[str, Factor] = {}
    try:
        notes = dict(data["notes"])
        packed = weights_path.read_bytes()
        if hashlib.sha256(packed).hexdigest() != data["sha256"]:
            raise ValueError(f"they are not those that {path.with_suffix('.json').name} was written with")
        with np.load(io.BytesIO(packed), allow_pickle=False) as arrays:
            for family, names in data["factors"].items():
                factors[family] = _unpack(family, names, arrays)
            first_pass = _first_pass(data[_FIRST_PASS], arrays) if _FIRST_PASS in data else None
    except FileNotFoundError:
        raise ModelError(f"{weights_path}: no such weights; `make weights` rebuilds them") from None
    except _DAMAGE as error:
        raise ModelError(f"{weights_path}: damaged weights ({error}); `make weights` rebuilds them") from error
    return FactorModel(factors, notes, first_pass)


def _pack(name: str, factor: Factor, arrays: dict[str, np.ndarray]) -> dict[str, list[str]]:
    """The names of facts and roles that have weights; the weights are added to arrays."""
    rows, columns = np.nonzero(np.round(factor.weights, _DIGITS))
    kept_facts, kept_roles = np.unique(rows), np.unique(columns)
    arrays[f"{name}.rows"] = np.searchsorted(kept_facts, rows).astype(np.uint16)
    arrays[f"{name}.columns"] = np.searchsorted(kept_roles, columns).astype(np.uint16)
    arrays[f"{name}.weights"] = np.round(factor.weights[rows, columns], _DIGITS).astype(np.float32)
    return {"facts": [factor.facts[i] for i in kept_facts], "roles": [factor.roles[i] for i in kept_roles]}


def _unpack(name: str, names: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Factor:
    weights = np.zeros((len(names["facts"]), len(names["roles"])))
    weights[arrays[f"{name}.rows"], arrays[f"{name}.columns"]] = arrays[f"{name}.weights"]
    return Factor(tuple(names["facts"]), tuple(names["roles"]), weights)


def _first_pass(names: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> FirstPass:
    """What was written of a first pass.

    Raises:
        ValueError: its threshold is no probability, or its names are no texts.
    """
    threshold = names["threshold"]
    if isinstance(threshold, bool) or not isinstance(threshold, int | float):
        raise ValueError(f"the first pass has the threshold {threshold!r}, which is no number")
    if not all(isinstance(name, str) for name in (*names["facts"], *names["roles"])):
        raise ValueError("the first pass has facts or kinds that are no names")
    return FirstPass(_unpack(_FIRST_PASS, names, arrays), float(threshold))


def _names(path: Path) -> Mapping[str, Any]:
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        version = data["version"]
    except FileNotFoundError:
        raise ModelError(f"{path}: no such weights; `make weights` rebuilds them") from None
    except _DAMAGE as error:
        raise ModelError(f"{path}: damaged weights ({error}); `make weights` rebuilds them") from error
    if version != VERSION:
        raise ModelError(f"{path}: weights of version {version}; this program reads version {VERSION}")
    return dict(data)


def _replace(path: Path, content: bytes) -> None:
    whole = path.with_name(path.name + ".part")
    whole.write_bytes(content)
    os.replace(whole, path)
