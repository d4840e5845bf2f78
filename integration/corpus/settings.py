"""Settings of a generated corpus, and its folder on disk: settings first, then finished parts, then the corpus.

A part is a small JSON file in `parts/`, written whole or not at all; the same command goes on with the parts that are
not there yet.
"""

from __future__ import annotations

import json
import os
import shutil
import zlib
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from integration.errors import UsageError

VERSION = 1
"""Raised whenever the same settings give another corpus."""
SETTINGS, PARTS = "settings.json", "parts"
CORPUS, HELD_OUT, SUMMARY = "corpus.jsonl", "held_out.json", "summary.json"
IMAGES, VIDEOS, INDEX = "images", "videos", "index.json"

_HOW_TO_GO_ON = "--restart begins anew, or name another --output"
_BYTES = {"instructions": 3_000, "worlds": 12_000, "images": 400_000, "videos": 6_000_000}  # on disk, generously


@dataclass(frozen=True)
class Settings:
    """Settings that a corpus depends on.

    Attributes:
        instructions: how many.
        worlds: how many are settled for them.
        images: of worlds with the boxes of what instructions speak of.
        videos: of instructions being carried out.
        seed: of all chance.
    """

    instructions: int
    worlds: int
    images: int
    videos: int
    seed: int

    def to_json(self) -> dict[str, int]:
        """Plain values."""
        return {"version": VERSION, **asdict(self)}

    @property
    def room(self) -> int:
        """The most bytes that the corpus and its parts take."""
        return sum(getattr(self, name) * size for name, size in _BYTES.items())


class Folder:
    """The folder of one corpus.

    Args:
        path: made if it is not there.
        settings: of the corpus.
        restart: whether to throw away what an earlier run left.

    Raises:
        UsageError: it is a file, holds a corpus of other settings or other things, has no room, or is not writable.
    """

    def __init__(self, path: Path, settings: Settings, restart: bool = False) -> None:
        self.path = path
        self._read: dict[str, list[Any]] = {}
        if path.exists() and not path.is_dir():
            raise UsageError(f"{path}: is a file; --output names a folder")
        try:
            path.mkdir(parents=True, exist_ok=True)
            free = shutil.disk_usage(path).free
        except OSError as error:
            raise UsageError(f"{path}: cannot be made: {error.strerror or error}") from error
        if settings.room > free:
            raise UsageError(
                f"{path}: no room: up to {settings.room / 1e6:,.0f} MB are needed and {free / 1e6:,.0f} MB are free; "
                "ask for fewer instructions, images or videos, or name a folder on a larger disk"
            )
        begun = (path / SETTINGS).exists()
        if begun and restart:
            self._clear()
        elif begun:
            self._compare(settings)
        elif any(path.iterdir()):
            raise UsageError(f"{path}: is not empty and holds no corpus that was begun; --output names a new folder")
        if restart or not begun:
            self.write(SETTINGS, json.dumps(settings.to_json(), indent=1) + "\n")

    def write(self, name: str, text: str) -> None:
        """Write a file of the folder, whole or not at all.

        Raises:
            UsageError: it cannot be written, for want of room for instance.
        """
        write_whole(self.path / name, text.encode())

    def has(self, part: str) -> bool:
        """Tells whether a part is finished."""
        return part in self._read or self._file(part).exists()

    def complete(self, part: str, where: str, key: str) -> bool:
        """Tells whether a part is finished and the files that its items name under `key` are in the folder `where`.

        Raises:
            UsageError: its file is damaged.
        """
        return self.has(part) and all((self.path / where / item[key]).exists() for item in self.items(part))

    def keep(self, part: str, items: Sequence[Any]) -> None:
        """Keep a finished part.

        Args:
            part: its name.
            items: plain values.

        Raises:
            UsageError: it cannot be written.
        """
        text = json.dumps(list(items), ensure_ascii=False)
        write_whole(self._file(part), f'{{"digest": {_digest(text)}, "items":\n{text}}}\n'.encode())
        self._read[part] = json.loads(text)  # as it would be read: tuples are lists

    def items(self, part: str) -> list[Any]:
        """The items of a finished part.

        Raises:
            UsageError: its file is damaged.
        """
        if part not in self._read:
            path = self._file(part)
            try:
                data = json.loads(path.read_text(encoding="utf-8"))
                items = data["items"]
                if not isinstance(items, list) or data["digest"] != _digest(json.dumps(items, ensure_ascii=False)):
                    raise ValueError("its checksum does not fit")
            except (OSError, ValueError, KeyError, TypeError) as error:
                raise UsageError(
                    f"{path}: is damaged ({error}); delete it and run the same command again, it alone is made anew"
                ) from error
            self._read[part] = items
        return self._read[part]

    def _file(self, part: str) -> Path:
        return self.path / PARTS / f"{part}.json"

    def _compare(self, settings: Settings) -> None:
        try:
            found = json.loads((self.path / SETTINGS).read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise UsageError(f"{self.path / SETTINGS}: is damaged ({error}); {_HOW_TO_GO_ON}") from error
        wanted = settings.to_json()
        if found != wanted:
            known = found if isinstance(found, dict) else {}
            told = ", ".join(f"{key} {known.get(key)} there and {wanted[key]} now" for key in wanted
                             if known.get(key) != wanted[key]) or "other settings"  # fmt: skip
            raise UsageError(f"{self.path}: holds a corpus of other settings: {told}; {_HOW_TO_GO_ON}")

    def _clear(self) -> None:
        """Throw away what this command writes, and nothing else."""
        try:
            for name in (PARTS, IMAGES, VIDEOS):
                if (self.path / name).exists():
                    shutil.rmtree(self.path / name)
            for name in (CORPUS, Path(CORPUS).with_suffix(".worlds.json").name, HELD_OUT, SUMMARY, SETTINGS):
                (self.path / name).unlink(missing_ok=True)
        except OSError as error:
            raise UsageError(f"{self.path}: cannot be cleared: {error.strerror or error}") from error


def write_whole(path: Path, content: bytes) -> None:
    """Write a file with its folders, whole or not at all.

    Raises:
        UsageError: it cannot be written.
    """
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            unfinished.write_bytes(content)
            os.replace(unfinished, path)
        finally:
            unfinished.unlink(missing_ok=True)
    except OSError as error:
        raise UsageError(f"{path}: cannot be written: {error.strerror or error}") from error


def _digest(text: str) -> int:
    return zlib.crc32(text.encode())
