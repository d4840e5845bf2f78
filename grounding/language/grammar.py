"""The grammar: how often which phrase has which head and which children, counted in a treebank.

It is a weighted context-free grammar in the lexicalised, markovised form of Collins (2003): a phrase makes its head
child, then its children to the right of the head, outwards, then those to the left. What the counts make probable is
said in `grounding.language.probabilities`.
"""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from grounding.errors import ModelError
from grounding.language.boundaries import Boundaries
from grounding.language.events import Child, Head, tree_events
from grounding.language.tables import Tables
from grounding.language.tags import TagModel
from grounding.language.tree import Phrase

_FORMAT = "grounding grammar"
_VERSION = 2


@dataclass(frozen=True)
class Grammar:
    """Counts of a treebank.

    Attributes:
        words: tag counts of the words.
        heads: how often each head was seen.
        children: how often each child was seen.
        boundaries: which words began and ended phrases.
        counted: the counts by context, where a file has them; see `tables`.
    """

    words: TagModel
    heads: Mapping[Head, int]
    children: Mapping[Child, int]
    boundaries: Boundaries
    counted: Tables | None = field(default=None, compare=False, repr=False)

    @cached_property
    def tables(self) -> Tables:
        """The counts by context."""
        return self.counted or Tables.count(self.heads, self.children)

    @classmethod
    def learn(cls, trees: Iterable[Phrase]) -> Grammar:
        """Count a treebank.

        Args:
            trees: phrase trees without punctuation; at least one for the grammar to be of any use.
        """
        treebank = tuple(trees)
        words = TagModel.learn(treebank)
        heads: Counter[Head] = Counter()
        children: Counter[Child] = Counter()
        for tree in treebank:
            for event in tree_events(tree, words):
                if isinstance(event, Head):
                    heads[event] += 1
                else:
                    children[event] += 1
        return cls(
            words, dict(sorted(heads.items())), dict(sorted(children.items())), Boundaries.learn(treebank, words)
        )

    def to_json(self) -> str:
        """The grammar as text: the same bytes for the same counts."""
        content = {
            "words": {word: dict(row) for word, row in self.words.counts.items()},
            "heads": [[*event, count] for event, count in self.heads.items()],
            "children": [[*event, count] for event, count in self.children.items()],
            "begins": self.boundaries.begins,
            "ends": self.boundaries.ends,
        }
        body = _body(content)
        opening = json.dumps({"format": _FORMAT, "version": _VERSION, "sha256": _digest(body)})
        return opening[:-1] + ',\n"content": ' + body.replace('],["', '],\n["') + "}\n"

    @classmethod
    def from_json(cls, text: str) -> Grammar:
        """Read what `to_json` wrote.

        Raises:
            ModelError: the text is damaged, or of another version.
        """
        content = _checked_content(text)
        try:
            words = {word: {tag: _count(n) for tag, n in row.items()} for word, row in content["words"].items()}
            return cls(
                TagModel(words),
                {Head(*event): _count(n) for *event, n in content["heads"]},
                {Child(*event): _count(n) for *event, n in content["children"]},
                Boundaries(_neighbours(content["begins"]), _neighbours(content["ends"])),
            )
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise ModelError(f"the grammar's content is not as expected: {error!r}") from error

    @classmethod
    def read(cls, path: Path) -> Grammar:
        """Read a grammar file.

        Raises:
            ModelError: the file is missing, damaged, or of another version; names the file.
        """
        try:
            return cls.from_json(path.read_text(encoding="utf-8"))
        except OSError as error:
            raise ModelError(f"the grammar {path} cannot be read: {error.strerror}") from error
        except (ModelError, UnicodeDecodeError) as error:
            raise ModelError(f"the grammar {path} cannot be used: {error}") from error

    def write(self, path: Path) -> None:
        """Write a grammar file."""
        path.write_text(self.to_json(), encoding="utf-8")

    @cached_property
    def phrase_tags(self) -> tuple[str, ...]:
        """The phrase types, in alphabetical order."""
        return tuple(sorted({event.tag for event in self.heads}))

    @cached_property
    def mothers(self) -> Mapping[str, tuple[str, ...]]:
        """Child tag -> the phrase tags that it can be the head of."""
        table: dict[str, set[str]] = {}
        for event in self.heads:
            table.setdefault(event.child_tag, set()).add(event.tag)
        return {tag: tuple(sorted(table[tag])) for tag in sorted(table)}

    @cached_property
    def chains(self) -> frozenset[tuple[str, str]]:
        """(phrase tag, tag of its only child, a phrase), without circles."""
        counts: Counter[tuple[str, str]] = Counter()
        for event, count in self.heads.items():
            if event.only and event.tag != event.child_tag:
                counts[event.tag, event.child_tag] += count
        kept: set[tuple[str, str]] = set()
        for (upper, lower), _ in sorted(counts.items(), key=lambda item: (-item[1], item[0])):
            if not _reaches(kept, lower, upper):
                kept.add((upper, lower))
        return frozenset(kept)


def _checked_content(text: str) -> Any:
    try:
        document = json.loads(text)
    except ValueError as error:
        raise ModelError(f"the grammar is not JSON: {error}") from error
    if not isinstance(document, dict) or document.get("format") != _FORMAT:
        raise ModelError(f"expected a grammar with format {_FORMAT!r} and found something else")
    if document.get("version") != _VERSION:
        raise ModelError(f"expected a grammar of version {_VERSION} and found {document.get('version')!r}")
    if _digest(_body(document.get("content"))) != document.get("sha256"):
        raise ModelError("the grammar is damaged: its checksum does not fit its content")
    return document["content"]


def _body(content: Any) -> str:
    return json.dumps(content, separators=(",", ":"))


def _digest(body: str) -> str:
    return hashlib.sha256(body.encode()).hexdigest()


def _count(value: Any) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or value < 1:
        raise ValueError(f"expected a count of at least 1 and found {value!r}")
    return value


def _neighbours(table: Any) -> dict[str, dict[str, tuple[int, int]]]:
    return {word: {kind: _share(*pair) for kind, pair in row.items()} for word, row in table.items()}


def _share(seen: Any, marked: Any) -> tuple[int, int]:
    if not isinstance(marked, int) or isinstance(marked, bool) or not 0 <= marked <= _count(seen):
        raise ValueError(f"expected a count of at most {seen} and found {marked!r}")
    return seen, marked


def _reaches(chains: set[tuple[str, str]], start: str, goal: str) -> bool:
    return start == goal or any(_reaches(chains, lower, goal) for upper, lower in sorted(chains) if upper == start)
