"""What single words say, by the table of words and by how compass points and superlatives are formed."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

from grounding.lexicon.vocabulary import vocabulary

OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front", "up": "down", "down": "up"}
HORIZONTAL = {"up": "back", "down": "front"}
_POINT = re.compile(r"(north|south)-?(east|west)(?:ern)?(?:-?most|ward|wards|erly)?")
_MOST = re.compile(r"(.+?)(?:ern)?-?most|(.+?)-hand")


@lru_cache(maxsize=4096)
def directions(word: str) -> tuple[str, ...]:
    """The directions that a word names: left, right, front, back, up, down; two for "northeast"."""
    table = vocabulary()
    point = table.value("compass", word)
    if point is not None:
        return tuple(point.split("-"))
    match = _POINT.fullmatch(word)
    if match:
        return tuple(name for part in match.groups() for name in directions(part))
    values = table.values("direction", word)
    if values:
        return values
    most = _MOST.fullmatch(word)
    stem = (most.group(1) or most.group(2)) if most else None
    return directions(stem) if stem and stem != word else ()


def flat(names: Iterable[str]) -> tuple[str, ...]:
    """Directions on the table, each once: what is not stacked lies "above" where it is further away."""
    return tuple(dict.fromkeys(HORIZONTAL.get(name, name) for name in names))


@lru_cache(maxsize=4096)
def is_extreme(word: str) -> bool:
    """Whether a word names the outermost in its direction: "leftmost", "northernmost", "highest"."""
    return bool(directions(word)) and (word.endswith("most") or word in ("highest", "lowest"))


def distance(word: str) -> str | None:
    """Either "near" or "far" for words of distance, None for others."""
    return vocabulary().value("distance", word)


def is_ranking(word: str) -> bool:
    """Whether a word of distance ranks: "closest", "further"."""
    return vocabulary().has("ranking", word)


def is_middle(word: str) -> bool:
    """Whether a word names the middle."""
    return vocabulary().has("middle", word)


def place(word: str) -> str | None:
    """Either "side" or "corner" for nouns of places."""
    return vocabulary().value("place", word)


def is_edge(word: str) -> bool:
    """Whether a noun means where a table ends: "edge", "border"."""
    return vocabulary().has("rim", word, "edge")


def is_rim(word: str) -> bool:
    """Whether a word names a part that lies outermost: "edge", "end", "corner"."""
    return vocabulary().has("rim", word)


def agent(word: str) -> str | None:
    """Who is meant: "robot" for the one who is spoken to, "speaker" for the one who speaks."""
    return vocabulary().value("person", word)


def is_view(word: str) -> bool:
    """Whether a word names a viewpoint: "perspective"."""
    return vocabulary().has("view", word)


def is_lone(word: str) -> bool:
    """Whether a word says that something stands apart from others."""
    return vocabulary().has("lone", word)


def is_unstacked(word: str) -> bool:
    """Whether such a word says so of what is not part of a stack, near others or not."""
    return vocabulary().has("lone", word, "single")


def is_apart(words: Iterable[str]) -> bool:
    """Whether one of some words says that things are far from each other: "separated from", "away from"."""
    return any(vocabulary().has("apart", word) for word in words)


def is_other(word: str) -> bool:
    """Whether a word excludes what was spoken of."""
    return vocabulary().has("other", word)


def is_touching(word: str) -> bool:
    """Whether a word says that things touch."""
    return vocabulary().has("contact", word)


def is_beside(word: str) -> bool:
    """Whether a word says that things are near each other."""
    return vocabulary().has("nearness", word)


def related(word: str) -> str | None:
    """The relation of `grounding.lexicon.relations` that a word says, None for other words."""
    return vocabulary().value("relation", word)


def nearness(word: str) -> str | None:
    """How near a word says that things are, "beside" or "near"; None for other words."""
    return vocabulary().value("nearness", word)


def is_between(word: str) -> bool:
    """Whether a word puts something between others."""
    return vocabulary().has("between", word, "between")


def is_surrounded(word: str) -> bool:
    """Whether a word puts others around something."""
    return vocabulary().has("between", word, "surrounded")


def is_on(word: str) -> bool:
    """Whether a word puts something on top of another thing."""
    return vocabulary().has("support", word, "on")


def is_over(word: str) -> bool:
    """Whether a preposition puts something above another thing whatever stands beside it: "over"."""
    return vocabulary().has("preposition", word, "up")


def is_off(word: str) -> bool:
    """Whether a word takes something from what it stands on."""
    return vocabulary().has("support", word, "off")


def is_strict(word: str) -> bool:
    """Whether a word narrows a direction: "directly"."""
    return vocabulary().has("strictness", word, "strict")


def is_nearly(word: str) -> bool:
    """Whether a word loosens a relation: "almost"."""
    return vocabulary().has("strictness", word, "nearly")


def is_block(word: str) -> bool:
    """Whether a noun means a thing that can be moved."""
    return vocabulary().has("thing", word) or vocabulary().has("kind", word)


def kind(word: str) -> str | None:
    """What a thing is that a noun calls so, such as "pyramid" of "prism"; None for "object" and for unknown words."""
    return vocabulary().value("kind", word)


def containers(word: str) -> tuple[str, ...]:
    """The kinds of arrangement that a noun names; "diagonal" beside those of Γ."""
    return vocabulary().values("arrangement", word)


def members(word: str) -> int | None:
    """How many members an arrangement has by its name: two of a "pair"."""
    value = vocabulary().value("members", word)
    return None if value is None else {"two": 2, "three": 3, "four": 4}[value]


def is_table(word: str) -> bool:
    """Whether a noun means the table as a whole."""
    return vocabulary().has("surface", word)


def is_layout(word: str) -> bool:
    """Whether a noun means what the things on the table span: "grid"."""
    return vocabulary().has("surface", word, "layout")


def is_measure(word: str) -> bool:
    """Whether a noun measures distances: in blocks, or as a unit of length."""
    return vocabulary().has("measure", word) or vocabulary().has("unit", word)


def is_negation(word: str) -> bool:
    """Whether a word denies what follows: "not"."""
    return vocabulary().has("negation", word)


def is_having(word: str) -> bool:
    """Whether a verb says what something has: "has"."""
    return vocabulary().has("possession", word)
