"""Weights on disk: `NAME.npz` holds the numbers, `NAME.json` the names and how they came about. Never pickle."""

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
from grounding.factors.model import Factor, FactorModel

VERSION = 2
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
        rows, columns = np.nonzero(np.round(factor.weights, _DIGITS))
        kept_facts, kept_roles = np.unique(rows), np.unique(columns)
        names[family] = {
            "facts": [factor.facts[i] for i in kept_facts],
            "roles": [factor.roles[i] for i in kept_roles],
        }
        arrays[f"{family}.rows"] = np.searchsorted(kept_facts, rows).astype(np.uint16)
        arrays[f"{family}.columns"] = np.searchsorted(kept_roles, columns).astype(np.uint16)
        arrays[f"{family}.weights"] = np.round(factor.weights[rows, columns], _DIGITS).astype(np.float32)
    path.parent.mkdir(parents=True, exist_ok=True)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, array in arrays.items():
            buffer = io.BytesIO()
            np.lib.format.write_array(buffer, np.ascontiguousarray(array), allow_pickle=False)
            archive.writestr(zipfile.ZipInfo(f"{name}.npy", _EPOCH), buffer.getvalue(), zipfile.ZIP_DEFLATED, 9)
    digest = hashlib.sha256(packed.getvalue()).hexdigest()
    data = {"version": VERSION, "notes": dict(model.notes), "factors": names, "sha256": digest}
    text = json.dumps(data, indent=0, sort_keys=True) + "\n"
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
                weights = np.zeros((len(names["facts"]), len(names["roles"])))
                weights[arrays[f"{family}.rows"], arrays[f"{family}.columns"]] = arrays[f"{family}.weights"]
                factors[family] = Factor(tuple(names["facts"]), tuple(names["roles"]), weights)
    except FileNotFoundError:
        raise ModelError(f"{weights_path}: no such weights; `make weights` rebuilds them") from None
    except _DAMAGE as error:
        raise ModelError(f"{weights_path}: damaged weights ({error}); `make weights` rebuilds them") from error
    return FactorModel(factors, notes)


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
