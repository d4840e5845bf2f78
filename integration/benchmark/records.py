"""Records of episodes on disk: one JSON line each after a line of settings, so that a run can be taken up again."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, TextIO

from integration.errors import UsageError

VERSION = 1


class Records:
    """The file of one benchmark.

    Args:
        path: where it is; made with its folders if it is not there.
        settings: what the episodes depend on besides their numbers.
        restart: whether to throw away what is there.

    Attributes:
        done: the records there are, by number.

    Raises:
        UsageError: it belongs to other settings, is damaged, or cannot be written.
    """

    def __init__(self, path: Path, settings: dict[str, Any], restart: bool = False) -> None:
        self.path = path
        self.done: dict[int, dict[str, Any]] = {}
        head = {"version": VERSION, **settings}
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            if not restart and path.exists() and path.stat().st_size:
                self._read(head)
            else:
                path.write_text(json.dumps(head) + "\n", encoding="utf-8")
            self._stream: TextIO = path.open("a", encoding="utf-8")
        except OSError as error:
            raise UsageError(f"records cannot be kept in {path}: {error}") from error

    def add(self, record: dict[str, Any]) -> None:
        """Keeps a record."""
        self.done[int(record["episode"])] = record
        self._stream.write(json.dumps(record) + "\n")
        self._stream.flush()

    def close(self) -> None:
        """Closes the file."""
        self._stream.close()

    def _read(self, head: dict[str, Any]) -> None:
        """Reads what is there; a last line that was cut off is dropped from the file."""
        lines = self.path.read_text(encoding="utf-8").splitlines(keepends=True)
        kept = []
        for number, line in enumerate(lines):
            try:
                data = json.loads(line)
            except json.JSONDecodeError:
                if number + 1 == len(lines) and number > 0:
                    break
                raise UsageError(
                    f"{self.path} is damaged in line {number + 1}; --restart begins it anew, or name another --output"
                ) from None
            if number == 0 and data != head:
                raise UsageError(
                    f"{self.path} holds records of {data}, not of {head}; --restart begins it anew, or name another "
                    "--output"
                )
            if number:
                self.done[int(data["episode"])] = data
            kept.append(line)
        if len(kept) < len(lines):
            self.path.write_text("".join(kept), encoding="utf-8")
