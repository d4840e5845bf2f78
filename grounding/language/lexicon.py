"""Knowledge of the closed classes: which symbols a word may name. It proposes; what a phrase means is for the weights.

Numbers, ordinals, directions, superlatives, colours, kinds of arrangement and of action are closed classes, so that
"seventh" is understood though training held only "third".
"""

from __future__ import annotations

import re
from functools import lru_cache

from grounding.language.number_words import number_of
from grounding.lexicon.shades import colours
from grounding.lexicon.vocabulary import vocabulary
from grounding.symbols import (
    LAST,
    Action,
    Cardinal,
    Container,
    ObjectColor,
    ObjectType,
    Ordinal,
    SpatialReference,
    Symbol,
)

_NUMBERS = (
    "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
    "eighteen nineteen twenty"
).split()
_ORDINALS = (
    "first second third fourth fifth sixth seventh eighth ninth tenth eleventh twelfth thirteenth fourteenth fifteenth "
    "sixteenth seventeenth eighteenth nineteenth twentieth"
).split()

_DIRECTIONS: dict[str, str] = {
    "left": "left leftmost lefthand left-hand leftward",
    "right": "right rightmost righthand right-hand rightward",
    "front": "front frontmost foremost forward fore bottom bottommost lowest lower below under underneath beneath",
    "back": "back rear backmost rearmost behind top topmost upper uppermost highest above",
    "near": "near nearest nearer close closest closer next beside by adjacent alongside nearby",
    "far": "far farthest furthest farther further farmost",
    "center": "center centre central middle centermost middlemost mid midpoint inner",
    "top": "top topmost upper uppermost highest above on onto upon atop over",
    "bottom": "bottom bottommost lowest lower below under underneath beneath",
    "between": "between amid among",
}
_COLORS = "red blue green yellow orange purple white black gray brown pink cyan magenta".split()
_TYPES: dict[str, str] = {
    "block": "block box cube brick blocks boxes cubes bricks",
    "table": "table tabletop tables desk",
}
_CONTAINERS: dict[str, str] = {
    "row": "row rows line lines horizontal",
    "column": "column columns line lines vertical",
    "group": "group groups cluster clusters bunch set pair pairs clump",
    "circle": "circle circles ring rings",
    "tower": "tower towers stack stacks pile piles",
    "robot": "robot baxter gripper you",
}
_ACTIONS: dict[str, str] = {
    "pick": "pick pickup give pass hand grab take lift get select grasp raise fetch hold bring collect choose",
    "place": "put place set move stack lay drop position slide push",
    "clear": "clear remove",
}
_SUPERLATIVES = frozenset(
    "leftmost rightmost nearest closest farthest furthest frontmost foremost backmost rearmost topmost uppermost "
    "highest bottommost lowest most middlemost".split()
)
_UNIVERSAL = frozenset("all both every each everything whole".split())
_PLURAL_TAGS = ("NNS", "NNPS")
_SIZES = {"large": 1, "small": -1}
_SIDES = re.compile("left|right")
_ALIKE: dict[type, str] = {Ordinal: "<ordinal>", Cardinal: "<cardinal>", ObjectColor: "<color>"}
_DIGITS = re.compile(r"(\d{1,40})(st|nd|rd|th)?")
_MOST = 999  # numbers beyond are as good as this one: nobody counts so far


def _table() -> dict[str, frozenset[Symbol]]:
    table: dict[str, set[Symbol]] = {}

    def enter(words: str, symbol: Symbol) -> None:
        for word in words.split():
            table.setdefault(word, set()).add(symbol)

    for value, word in enumerate(_NUMBERS, start=1):
        enter(word, Cardinal(value))
    for value, word in enumerate(_ORDINALS, start=1):
        enter(word, Ordinal(value))
    enter("last", Ordinal(LAST))
    enter("both pair pairs", Cardinal(2))
    for name, words in _DIRECTIONS.items():
        enter(words, SpatialReference(name))
    for colour in colours().values():
        enter(" ".join(colour.words), ObjectColor(colour.name))
    for name, words in _TYPES.items():
        enter(words, ObjectType(name))
    for name, words in _CONTAINERS.items():
        enter(words, Container(name))
    for name, words in _ACTIONS.items():
        enter(words, Action(name))
    return {word: frozenset(symbols) for word, symbols in table.items()}


_MEANINGS = _table()


@lru_cache(maxsize=4096)
def meanings(word: str) -> frozenset[Symbol]:
    """The symbols that a word may name; empty for words outside the closed classes.

    Args:
        word: lower case. Digits count as numbers ("5") and ordinals ("3rd"), as do words for large ones.
    """
    if word in _MEANINGS:
        return _MEANINGS[word]
    match = _DIGITS.fullmatch(word)
    if match:
        value = min(int(match.group(1)), _MOST)
        return frozenset({Ordinal(value) if match.group(2) else Cardinal(value)}) if value else frozenset()
    number = number_of(word)
    if number is not None:
        return frozenset({Ordinal(number[0]) if number[1] else Cardinal(number[0])})
    return frozenset()


@lru_cache(maxsize=4096)
def alike(word: str) -> str:
    """One name for words that differ only in which number, rank, colour or side they name: "third" is as "seventh".

    Left and right are mirror images, so that what is learned of one holds of the other.
    """
    classes = {type(symbol) for symbol in meanings(word)}
    if len(classes) == 1 and word != "last":
        kind = classes.pop()
        if kind in _ALIKE:
            return _ALIKE[kind]
        if kind is SpatialReference:
            return _SIDES.sub("<side>", word)
    return word


def is_colour(word: str) -> bool:
    """Whether a word names a colour."""
    return any(isinstance(symbol, ObjectColor) for symbol in meanings(word))


def is_superlative(word: str) -> bool:
    """Whether a word ranks: "nearest", "leftmost"."""
    return word in _SUPERLATIVES


def is_universal(word: str) -> bool:
    """Whether a word means all members of a set: "all", "both"."""
    return word in _UNIVERSAL


def size_order(word: str) -> int:
    """1 for words that ask for the larger arrangement ("tallest"), -1 for the smaller, 0 for others."""
    return _SIZES.get(vocabulary().value("size", word) or "", 0)


def is_plural(tag: str) -> bool:
    """Whether a Penn tag is that of a plural noun."""
    return tag in _PLURAL_TAGS


def known_words() -> frozenset[str]:
    """All words that the closed classes know."""
    return frozenset(_MEANINGS) | _SUPERLATIVES | _UNIVERSAL | vocabulary().words("size")


def known_colors() -> tuple[str, ...]:
    """The names of the colours of Γ, in a fixed order."""
    return tuple(_COLORS)
