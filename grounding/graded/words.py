"""What single words contribute to a graded reading: directions, ranks, relations, kinds of place.

Wider than the closed classes of `grounding.language.lexicon`, which propose symbols: here belongs what can be weighed
though no symbol stands for it (corners, compass points, "alone").
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

_SIDES = {
    "left": "left lefthand left-hand leftward leftwards west western westward",
    "right": "right righthand right-hand rightward rightwards east eastern eastward",
    "front": "front fore foremost backward backwards south southern southward southwards",
    "back": "back rear forward forwards north northern northward northwards",
    "up": "top upper up upward upwards high higher highest above uppermost topmost",
    "down": "bottom lower down downward downwards low lowest below bottommost",
}
_COMPASS = {"north": "back", "south": "front", "east": "right", "west": "left"}
COMPASS_WORDS = frozenset(_COMPASS)
VIEWS = frozenset("perspective view viewpoint standpoint vantage position point".split())
OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front", "up": "down", "down": "up"}
_HORIZONTAL = {"up": "back", "down": "front"}
_ABBREVIATED = {"ne": "northeast", "nw": "northwest", "se": "southeast", "sw": "southwest"}
_POINT = re.compile(r"(north|south)-?(east|west)(?:ern)?(?:-?most|ward|wards|erly)?")
_MOST = re.compile(r"(.+?)(?:ern)?-?most|(.+?)-hand")
_NEAR = frozenset("closest nearest closer nearer near close closes closet nearby".split())
_FAR = frozenset(
    "farthest furthest farther further furthermost farthermost furtherest farest furthers far away".split()
)
_RANKING = frozenset(
    "closest nearest closer nearer closes closet farthest furthest farther further furthermost farthermost furtherest "
    "farest furthers".split()
)
_MIDDLE = frozenset("middle center centre central middlemost centermost mid centered midpoint innermost centric "
                    "centralmost".split())  # fmt: skip
_PLACES = {
    "side": "side sides half halves section area part portion region end ends edge edges border boundary hand zone",
    "corner": "corner corners quadrant quadrants",
}
_AGENTS = {
    "robot": "you your yourself robot yours baxter gripper them their theirs his",
    "speaker": "me my myself i mine us our",
}
_LONE = frozenset("lone alone single solitary isolated lonely sole solo itself standalone own separate loner loose "
                  "stray unstacked freestanding free-standing unattached nonattached non-attached".split())  # fmt: skip
_UNSTACKED = frozenset("single sole solo standalone unstacked freestanding free-standing loose".split())
_OTHER = frozenset("other another remaining else".split())
_APART = frozenset("separated apart isolated detached separate away outside".split())
_TOUCHING = frozenset("touching touches touch adjacent flush against connected contacting attached joined abutting "
                      "bordering touched".split())  # fmt: skip
_BESIDE = frozenset("next beside by near close alongside nearby besides".split())
_BETWEEN = frozenset("between amid among amongst in-between inbetween sandwiched".split())
_SURROUNDED = frozenset("surrounded surrounding encircled enclosed".split())
_STRICT = frozenset("directly immediately just right exactly straight due".split())
_BLOCKS = frozenset(
    "block blocks box boxes cube cubes brick bricks square squares object objects one ones piece pieces item items "
    "thing things neighbor neighbors neighbour neighbours bloc tile tiles die dice box's block's".split()
)
_CONTAINERS = {
    "row": "row rows line lines horizontal string chain",
    "column": "column columns col vertical line lines string chain",
    "diagonal": "diagonal diagonals line",
    "group": "group groups cluster clusters bunch set sets pair pairs clump grouping groupings trio duo couple "
             "arrangement formation collection",
    "circle": "circle circles ring rings",
    "tower": "tower towers stack stacks pile piles structure structures story stories building",
}  # fmt: skip
_TABLE = frozenset("table board tabletop desk surface screen grid picture workspace field".split())
_MEASURES = frozenset("length lengths width widths space spaces height heights inch inches spot spots "
                      "unit units step steps".split())  # fmt: skip


def _table(entries: dict[str, str]) -> dict[str, tuple[str, ...]]:
    found: dict[str, list[str]] = {}
    for name, words in entries.items():
        for word in words.split():
            found.setdefault(word, []).append(name)
    return {word: tuple(dict.fromkeys(names)) for word, names in found.items()}


_SIDE_OF = _table(_SIDES)
_PLACE_OF = _table(_PLACES)
_AGENT_OF = _table(_AGENTS)
_CONTAINER_OF = _table(_CONTAINERS)


@lru_cache(maxsize=4096)
def directions(word: str) -> tuple[str, ...]:
    """The directions that a word names: left, right, front, back, up, down; two for "northeast"."""
    if word in _COMPASS:
        return (_COMPASS[word],)
    if word in _ABBREVIATED:
        word = _ABBREVIATED[word]
    match = _POINT.fullmatch(word)
    if match:
        return (_COMPASS[match.group(1)], _COMPASS[match.group(2)])
    if word in _SIDE_OF:
        return _SIDE_OF[word]
    match = _MOST.fullmatch(word)
    stem = (match.group(1) or match.group(2)) if match else None
    return directions(stem) if stem and stem != word else ()


def flat(names: Iterable[str]) -> tuple[str, ...]:
    """Directions on the table, each once: what is not stacked lies "above" where it is further away."""
    return tuple(dict.fromkeys(_HORIZONTAL.get(name, name) for name in names))


@lru_cache(maxsize=4096)
def is_extreme(word: str) -> bool:
    """Whether a word names the outermost in its direction: "leftmost", "northernmost", "highest"."""
    return bool(directions(word)) and (word.endswith("most") or word in ("highest", "lowest"))


def distance(word: str) -> str | None:
    """Either "near" or "far" for words of distance, None for others."""
    return "near" if word in _NEAR else "far" if word in _FAR else None


def is_ranking(word: str) -> bool:
    """Whether a word of distance ranks: "closest", "further"."""
    return word in _RANKING


def is_middle(word: str) -> bool:
    """Whether a word names the middle."""
    return word in _MIDDLE


def place(word: str) -> str | None:
    """Either "side" or "corner" for nouns of places."""
    return _PLACE_OF[word][0] if word in _PLACE_OF else None


def agent(word: str) -> str | None:
    """Who is meant: "robot" for the one who is spoken to, "speaker" for the one who speaks."""
    return _AGENT_OF[word][0] if word in _AGENT_OF else None


def is_lone(word: str) -> bool:
    """Whether a word says that something stands apart from others."""
    return word in _LONE


def is_apart(words: Iterable[str]) -> bool:
    """Whether one of some words says that things are far from each other: "separated from", "away from"."""
    return not _APART.isdisjoint(words)


def is_unstacked(word: str) -> bool:
    """Whether such a word says so of what is not part of a stack, near others or not."""
    return word in _UNSTACKED


def is_other(word: str) -> bool:
    """Whether a word excludes what was spoken of."""
    return word in _OTHER


def is_touching(word: str) -> bool:
    """Whether a word says that things touch."""
    return word in _TOUCHING


def is_beside(word: str) -> bool:
    """Whether a word says that things are near each other."""
    return word in _BESIDE


def is_between(word: str) -> bool:
    """Whether a word puts something between others."""
    return word in _BETWEEN


def is_surrounded(word: str) -> bool:
    """Whether a word puts others around something."""
    return word in _SURROUNDED


def is_strict(word: str) -> bool:
    """Whether a word narrows a direction: "directly"."""
    return word in _STRICT


def is_block(word: str) -> bool:
    """Whether a noun means a thing that can be moved."""
    return word in _BLOCKS


def containers(word: str) -> tuple[str, ...]:
    """The kinds of arrangement that a noun names; "diagonal" beside those of Γ."""
    return _CONTAINER_OF.get(word, ())


def is_table(word: str) -> bool:
    """Whether a noun means the table as a whole."""
    return word in _TABLE


def is_measure(word: str) -> bool:
    """Whether a noun measures distances in blocks."""
    return word in _MEASURES
