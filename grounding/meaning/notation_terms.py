"""The terms of the notation of meanings: which words stand for which fields, and places as they are written."""

from __future__ import annotations

import json
import re

from grounding.meaning.referents import (
    CHOOSING,
    NOTHING,
    OBJECTS,
    PERSON,
    PLACE,
    RANKING,
    RESTRICTING,
    SETS,
    TABLE,
    Region,
)

SORTS = (OBJECTS, SETS, PLACE, PERSON, TABLE, NOTHING)
CONCEPTS = RESTRICTING | CHOOSING | RANKING
PLACED = frozenset("at extreme part".split())
"""Concepts behind which a place follows at once; behind others their words do."""
PREPOSITIONS = {
    "nearest": "to", "farthest": "from", "same": "as", "other": "than", "apart": "from", "surrounded": "by",
    "between": "", "beside": "", "touching": "", "on": "", "outside": "",
}  # fmt: skip
"""What stands before the referents to which a condition relates, where it is not "of"."""
NAME = re.compile(r"x[1-9][0-9]*")

PEOPLE = ("robot", "speaker")
FLAGS = {"strict": "strictly", "nearly": "nearly", "counting": "counted", "metric": "metres"}
"""Fields of conditions that hold or do not."""
REFERENT_FLAGS = {"plural": "plural", "universal": "all", "only": "only", "like": "alike", "crossing": "crossing"}
"""Fields of referents that hold or do not."""

_NOUNS = {(False, False): "side", (True, False): "quadrant", (False, True): "edge", (True, True): "corner"}
_BARE = {(False, False): "", (True, False): "together", (False, True): "outermost", (True, True): "cornermost"}
_PLACE_WORDS = {"middle", "anywhere", *_NOUNS.values(), *_BARE.values()} - {""}
KEYWORDS = frozenset(
    "of to from as than and not is words place number indefinite parts person amount ways rank said seen by the"
    .split()
) | _PLACE_WORDS | {*FLAGS.values(), *REFERENT_FLAGS.values(), *PEOPLE}  # fmt: skip
"""Words that are part of the notation; a word of a meaning that is one of them is put in quotes."""

_PLAIN = re.compile(r"[a-z][a-z0-9'-]*")
_TOKEN = re.compile(r'\s*("(?:[^"\\]|\\.)*"|[^\s"]+)')


def quoted(text: str) -> str:
    """A text in quotes, whatever is in it."""
    return json.dumps(text, ensure_ascii=False)


def word(text: str) -> str:
    """A word of a meaning: in quotes where it could be taken for a part of the notation."""
    return text if _PLAIN.fullmatch(text) and text not in KEYWORDS and not NAME.fullmatch(text) else quoted(text)


def somebody(person: str) -> str:
    """A person."""
    return person if person in PEOPLE else quoted(person)


def amount(number: float) -> str:
    """A number, whole ones without a point."""
    return str(int(number)) if number == int(number) else repr(number)


def split(line: str) -> list[str]:
    """The words of a line, those in quotes as one with their quotes.

    Raises:
        ValueError: a quote is open at its end.
    """
    tokens, at = [], 0
    text = line.rstrip()
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError(text[at:])
        tokens.append(match.group(1))
        at = match.end()
    return tokens


def place_of(region: Region) -> str:
    """A place in words: directions, "middle", a noun, whose it is."""
    shape = (region.corner, region.rim)
    parts = [word(name) for name in region.names]
    parts += ["middle"] if region.middle else []
    parts.append(_BARE[shape] if region.bare else _NOUNS[shape])
    parts += ["of the table"] if region.table else []
    parts += [f"of {region.owner}"] if region.owner is not None else []
    if not region.names and not region.middle and region.bare and shape == (False, False):
        parts.insert(0, "anywhere")
    return " ".join(filter(None, parts))


def region_of(names: tuple[str, ...], said: str | None, *, middle: bool, table: bool, owner: str | None) -> Region:
    """The place of some directions.

    Args:
        names: of the directions.
        said: its noun, or the word that stands there where it has none; None where nothing stands there.
        middle: whether the middle is meant.
        table: whether it is said to be the table's.
        owner: whose side it is, or None.
    """
    bare = said in (None, *_BARE.values())
    table_of = _BARE if bare else _NOUNS
    corner, rim = next(shape for shape, noun in table_of.items() if noun == (said or ""))
    return Region(names, middle, corner, rim, bare, owner, table)


def shapes() -> frozenset[str]:
    """The words that stand behind the directions of a place."""
    return frozenset({*_NOUNS.values(), *_BARE.values()} - {""})
