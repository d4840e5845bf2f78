"""How colours are seen: names, what most people call so, and how far two of them are apart.

Differences are CIEDE2000 (CIE 142-2001) in CIELAB under D65, where 1 is just noticed side by side.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from grounding.errors import LexiconError
from grounding.lexicon.vocabulary import read_toml, vocabulary

if TYPE_CHECKING:
    from coloraide import Color

_SHADE = re.compile("#[0-9a-f]{6}")
_TINTS = {"light": "white", "dark": "black"}
COLOURS = Path(__file__).with_name("colours.toml")


@dataclass(frozen=True)
class Colour:
    """A name for a colour.

    Attributes:
        name: by which the table knows it.
        seen: what most people call so, as "#rrggbb".
        words: that say it.
        basic: whether everybody has a term for it, so that what has this colour is called by no other name.
    """

    name: str
    seen: str
    words: tuple[str, ...]
    basic: bool


@lru_cache(maxsize=1)
def colours() -> Mapping[str, Colour]:
    """The table of colours by their names."""
    return read_colours(COLOURS)


def read_colours(path: Path) -> dict[str, Colour]:
    """Read a table of colours, a section for every name.

    Raises:
        LexiconError: the file is missing or no TOML, an entry lacks "seen" or "words" or has a key that nobody knows,
            a shade is none, or a word says two colours; names file and entry.
    """
    found: dict[str, Colour] = {}
    said: dict[str, str] = {}
    for name, entry in read_toml(path, "table of colours").items():
        found[name] = _entry(path, name, entry)
        for word in found[name].words:
            if word in said:
                raise LexiconError(f"{path}: the word {word!r} says both {said[word]!r} and {name!r}; keep one of them")
            said[word] = name
    return found


def _entry(path: Path, name: str, entry: Any) -> Colour:
    if not isinstance(entry, dict) or not {"seen"} <= set(entry) <= {"seen", "words", "basic"}:
        raise LexiconError(f"{path}: [{name}]: expected 'seen' and perhaps 'words' and 'basic', and found {entry!r}")
    seen, words = entry["seen"], entry.get("words", "")
    if not isinstance(words, str) or not isinstance(seen, str) or _SHADE.fullmatch(seen) is None:
        raise LexiconError(f"{path}: [{name}]: expected a shade such as '#1f77b4' and words in quotes, found {entry!r}")
    return Colour(name, seen, tuple(words.split()), bool(entry.get("basic", False)))


@lru_cache(maxsize=1)
def _names() -> Mapping[str, str]:
    return {word: colour.name for colour in colours().values() for word in (colour.name, *colour.words)}


@lru_cache(maxsize=4096)
def name_of(said: str) -> str:
    """The name of a colour as a world or a person calls it; for a shade such as "#1f77b4" the nearest name."""
    plain = said.strip().lower()
    known = _names().get(plain)
    if known is not None:
        return known
    seen = shade(plain) if plain.startswith(("#", "rgb")) else None
    if seen is None:
        return plain
    return base_of(min(colours().values(), key=lambda colour: difference(colour.seen, plain)).name)


@lru_cache(maxsize=4096)
def shade(said: str) -> Color | None:
    """How a colour is seen: by a name of the table, with "light-" or "dark-" before it, or as any CSS colour.

    None for what is no colour to anybody.
    """
    from coloraide import Color  # takes a tenth of a second, which only those pay who need it

    plain = said.strip().lower()
    known = colours().get(_names().get(plain, ""))
    if known is not None:
        return Color(known.seen)
    base, tint = shade(base_of(plain)) if base_of(plain) != plain else None, _TINTS.get(plain.partition("-")[0])
    if base is not None and tint is not None:
        return base.mix(tint, 0.5, space="lab-d65")  # half of each
    try:
        return Color(plain)
    except ValueError:
        return None


def base_of(said: str) -> str:
    """The colour of which a shade is said: blue of "light-blue"."""
    tint, _, rest = said.partition("-")
    return rest if rest and tint in _TINTS else said


@lru_cache(maxsize=4096)
def difference(one: str, other: str) -> float:
    """How different two colours look, CIEDE2000; infinite where nobody knows how one looks."""
    first, second = shade(one), shade(other)
    return float("inf") if first is None or second is None else float(first.delta_e(second, method="2000"))


def tint_of(word: str) -> str | None:
    """The tint that a word gives a colour, "light" or "dark"; None for other words."""
    return vocabulary().value("tint", word)
