"""Grammars in a form that is quick to load: beside `grammar.json`, a file with the counts by context.

A parser that counts a grammar's events by context takes many times as long for that as for a sentence. The file of
tables has them counted, one row a line, and a row is taken apart when a parse first asks for it. It names the grammar
that it was made of by checksum; where it does not fit, the events are counted as if it were not there.

The first line is a header, the second holds what is small, both JSON. Then follow, for every table, its contexts and
its rows, "outcome count outcome count ...", in the same order.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from grounding.language.boundaries import Boundaries
from grounding.language.estimates import BackOff, Row
from grounding.language.events import Child, Head
from grounding.language.grammar import Grammar
from grounding.language.tables import NOVELTIES, Tables
from grounding.language.tags import TagModel

_FORMAT = "grounding grammar tables"
_VERSION = 1


class StoredRows(Mapping[str, Row]):
    """Rows by context, taken apart when they are asked for.

    Args:
        contexts: all different.
        rows: of each, outcomes and counts in turn, separated by single blanks.
    """

    def __init__(self, contexts: Iterable[str], rows: Iterable[str]) -> None:
        self._rows = dict(zip(contexts, rows, strict=True))

    def __getitem__(self, context: str) -> Row:
        parts = self._rows[context].split(" ")
        return dict(zip(parts[::2], map(int, parts[1::2]), strict=True))

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)


class LaterChildren(Mapping[Child, int]):
    """The counted children of a grammar file, which is read when they are asked for: parsing needs the tables only."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._read: Mapping[Child, int] | None = None

    def _children(self) -> Mapping[Child, int]:
        if self._read is None:
            self._read = Grammar.read(self._path).children
        return self._read

    def __getitem__(self, event: Child) -> int:
        return self._children()[event]

    def __iter__(self) -> Iterator[Child]:
        return iter(self._children())

    def __len__(self) -> int:
        return len(self._children())


def tables_beside(path: Path) -> Path:
    """The file of tables that belongs to a grammar file."""
    return path.with_suffix(".tables")


def write_tables(path: Path) -> None:
    """Write the file of tables beside a grammar file.

    Raises:
        ModelError: the grammar file is missing, damaged, or of another version.
    """
    body = _body(Grammar.read(path)).encode()
    header = {"format": _FORMAT, "version": _VERSION, "grammar": _digest(path.read_bytes()), "sha256": _digest(body)}
    target = tables_beside(path)
    whole = target.with_name(target.name + ".part")
    whole.write_bytes(json.dumps(header).encode() + b"\n" + body)
    os.replace(whole, target)


def read_grammar(path: Path) -> Grammar:
    """Read a grammar file, with the tables beside it where they are its own.

    Raises:
        ModelError: the grammar file is missing, or it has no tables and is damaged or of another version.
    """
    try:
        stored, digest = tables_beside(path).read_bytes(), _digest(path.read_bytes())
    except OSError:
        return Grammar.read(path)
    body = _fitting(stored, digest)
    return Grammar.read(path) if body is None else _grammar(body, path)


def _fitting(stored: bytes, digest: str) -> str | None:
    """The text after the header; None where the file is damaged, of another version or of another grammar."""
    opening, _, body = stored.partition(b"\n")
    try:
        header = json.loads(opening)
    except ValueError:
        return None
    wanted = {"format": _FORMAT, "version": _VERSION, "grammar": digest, "sha256": _digest(body)}
    return body.decode() if header == wanted else None


def _grammar(body: str, path: Path) -> Grammar:
    """The grammar of a text that `_body` wrote."""
    small, *lines = body.split("\n")
    content = json.loads(small)
    back_offs: dict[str, BackOff] = {}
    start = 0
    for name, size in content["tables"].items():
        middle, end = start + size, start + 2 * size
        back_offs[name] = BackOff(StoredRows(lines[start:middle], lines[middle:end]), NOVELTIES[name])
        start = end
    sides = {(tag, side): frozenset(tags) for tag, side, tags in content["sides"]}
    return Grammar(
        TagModel(content["words"]),
        {Head(*event): count for *event, count in content["heads"]},
        LaterChildren(path),
        Boundaries(_shares(content["begins"]), _shares(content["ends"])),
        Tables(**back_offs, label_words=content["label_words"], sides=sides),
    )


def _body(grammar: Grammar) -> str:
    """All but the header."""
    tables = grammar.tables
    rows: dict[str, Mapping[str, Row]] = {name: getattr(tables, name).rows for name in NOVELTIES}
    small = {
        "words": {word: dict(row) for word, row in grammar.words.counts.items()},
        "heads": [[*event, count] for event, count in grammar.heads.items()],
        "begins": grammar.boundaries.begins,
        "ends": grammar.boundaries.ends,
        "label_words": dict(tables.label_words),
        "sides": [[*side, sorted(tags)] for side, tags in tables.sides.items()],
        "tables": {name: len(table) for name, table in rows.items()},
    }
    lines = [json.dumps(small, separators=(",", ":"))]
    for table in rows.values():
        lines += table
        lines += (" ".join(f"{outcome} {count:.0f}" for outcome, count in row.items()) for row in table.values())
    return "\n".join(lines)


def _shares(table: Any) -> dict[str, dict[str, tuple[int, int]]]:
    return {word: {kind: (seen, marked) for kind, (seen, marked) in row.items()} for word, row in table.items()}


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()
