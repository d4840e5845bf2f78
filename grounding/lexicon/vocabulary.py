"""The table of words: which value of a family of concepts a word says."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from grounding.errors import LexiconError

WORDS = Path(__file__).with_name("words.toml")


@dataclass(frozen=True)
class Vocabulary:
    """What words say, family by family.

    Attributes:
        families: for every family, the values that each of its words says, in the order of the table.
    """

    families: Mapping[str, Mapping[str, tuple[str, ...]]]

    def values(self, family: str, word: str) -> tuple[str, ...]:
        """The values that a word says in a family; none where it says nothing there."""
        return self.families[family].get(word, ())

    def value(self, family: str, word: str) -> str | None:
        """The value that a word says in a family, or None."""
        found = self.families[family].get(word)
        return found[0] if found else None

    def has(self, family: str, word: str, value: str | None = None) -> bool:
        """Whether a word says a value of a family, or any of its values."""
        found = self.families[family].get(word, ())
        return bool(found) and (value is None or value in found)

    def words(self, family: str, value: str | None = None) -> frozenset[str]:
        """All words of a family, or those that say one of its values."""
        entries = self.families[family]
        return frozenset(word for word, values in entries.items() if value is None or value in values)

    def known(self, word: str) -> bool:
        """Whether any family has a word."""
        return any(word in entries for entries in self.families.values())


def vocabulary() -> Vocabulary:
    """The table that is in force: the shipped one, where nothing extends it."""
    return _extra[-1] if _extra else _shipped()


@lru_cache(maxsize=1)
def _shipped() -> Vocabulary:
    return read_vocabulary(WORDS)


_extra: list[Vocabulary] = []


@contextmanager
def extended(family: str, value: str, *words: str) -> Iterator[None]:
    """A table that has further words for as long as the context lasts.

    Args:
        family: of concepts.
        value: that the words say.
        words: to be added.

    Raises:
        LexiconError: there is no such family, or a word says something else there already.
    """
    table = vocabulary()
    if family not in table.families:
        raise LexiconError(f"there is no family of concepts [{family}]; known are {', '.join(sorted(table.families))}")
    for word in words:
        before = table.value(family, word)
        if before not in (None, value):
            raise LexiconError(f"in [{family}] the word {word!r} says {before!r}; it cannot say {value!r} as well")
    entries = {**table.families[family], **dict.fromkeys(words, (value,))}
    _extra.append(Vocabulary({**table.families, family: entries}))
    try:
        yield
    finally:
        _extra.pop()


def read_vocabulary(path: Path) -> Vocabulary:
    """Read a table of words.

    Args:
        path: of a TOML file with a section for every family, see `words.toml`.

    Raises:
        LexiconError: the file is missing or no TOML, lacks a family, has one that nobody knows, or lets a word say two
            things in one family.
    """
    data = read_toml(path, "table of words")
    several = data.pop("several", [])
    if path != WORDS:
        _check_families(set(data), path)
    families = {}
    for family, entries in data.items():
        if not isinstance(entries, dict):
            raise LexiconError(f"{path}: expected [{family}] to be a section of values and found {entries!r}")
        families[family] = _entries(path, family, entries, several=family in several)
    return Vocabulary(families)


def read_toml(path: Path, what: str) -> dict[str, Any]:
    """Read a TOML file of the lexicon.

    Raises:
        LexiconError: it is missing or no TOML; names the file.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise LexiconError(f"cannot read the {what} {path}: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise LexiconError(f"the {what} {path} is no TOML: {error}") from error


def _check_families(found: set[str], path: Path) -> None:
    wanted = set(_shipped().families)
    for name in sorted(found - wanted):
        raise LexiconError(f"{path}: there is no family of concepts [{name}]; known are {', '.join(sorted(wanted))}")
    for name in sorted(wanted - found):
        raise LexiconError(f"{path}: the family [{name}] is missing")


def _entries(path: Path, family: str, entries: Mapping[str, Any], *, several: bool) -> dict[str, tuple[str, ...]]:
    said: dict[str, tuple[str, ...]] = {}
    for value, words in entries.items():
        if not isinstance(words, str):
            raise LexiconError(f"{path}: [{family}] {value}: expected words in quotes and found {words!r}")
        for word in words.split():
            before = said.get(word, ())
            if before and (not several or value in before):
                raise LexiconError(
                    f"{path}: in [{family}] the word {word!r} says both {before[0]!r} and {value!r}; keep one of them"
                )
            said[word] = (*before, value)
    return said
