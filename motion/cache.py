"""A folder in the user's cache, built once, written atomically, checked on every use and rebuilt when it is damaged."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

APPLICATION = "adcg-baxter"
_MANIFEST = "manifest.json"


def cache_root() -> Path:
    """$XDG_CACHE_HOME/adcg-baxter, or ~/.cache/adcg-baxter."""
    configured = os.environ.get("XDG_CACHE_HOME", "")
    base = Path(configured) if os.path.isabs(configured) else Path.home() / ".cache"
    return base / APPLICATION


def cached_folder(key: str, build: Callable[[Path], None], root: Path | None = None) -> Path:
    """The folder `key` of the cache, built by `build(folder)` when it is missing or damaged.

    Two processes may build at once: each builds in a folder of its own and the last rename wins, with equal contents.
    Without a cache folder that can be written, a temporary one serves this process.

    Args:
        key: what the contents depend on, as a name for a folder.
        build: fills an empty folder.
        root: the cache's root, if it is not the user's.
    """
    root = cache_root() if root is None else root
    folder = root / key
    if intact(folder):
        return folder
    try:
        root.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(prefix=f".{key}-", dir=root))
    except OSError:
        folder = Path(tempfile.mkdtemp(prefix=f"{APPLICATION}-"))
        build(folder)
        return folder
    try:
        build(work)
        _seal(work)
        if folder.exists() and not intact(folder):
            shutil.rmtree(folder, ignore_errors=True)
        try:
            work.rename(folder)
        except OSError:
            if not intact(folder):
                raise
    finally:
        shutil.rmtree(work, ignore_errors=True)
    return folder


def intact(folder: Path) -> bool:
    """Tells whether every file that the folder's manifest lists is there, unchanged."""
    try:
        files = json.loads((folder / _MANIFEST).read_text())
        return bool(files) and all(_digest(folder / name) == digest for name, digest in files.items())
    except (OSError, ValueError, AttributeError):
        return False


def _seal(folder: Path) -> None:
    names = sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
    text = json.dumps({name: _digest(folder / name) for name in names}, indent=1)
    (folder / _MANIFEST).write_text(text)


def _digest(path: Path) -> str:
    return hashlib.blake2b(path.read_bytes(), digest_size=16).hexdigest()
