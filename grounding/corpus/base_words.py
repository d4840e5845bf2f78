"""The words of base noun phrases, sorted by what they say of the objects that are meant."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from grounding.corpus.meaning import NotAnnotatable
from grounding.corpus.words import (
    BLOCKS,
    IGNORED,
    INDEFINITE,
    LENGTHS,
    LONE,
    MEASURING,
    OPPOSITE,
    OTHER,
    PLACE_NOUNS,
    TABLES,
    directions,
)
from grounding.language.lexicon import is_plural, is_universal, meanings, size_order
from grounding.language.tree import Phrase, Word
from grounding.symbols import (
    Cardinal,
    Container,
    ObjectColor,
    ObjectType,
    Ordinal,
    SpatialReference,
    Symbol,
)

UNKNOWN_NOUNS = frozenset(
    "ball balls cup cups bottle bottles pen pens spoon mug hammer apple apples banana sponge toy coin coins book books "
    "key keys shoe phone plate glass lamp hat sock marble marbles song pyramid cylinder car bowl fork knife "
    "door".split()
)
_LYING = {"horizontal": ("row",), "vertical": ("column", "tower"), "straight": ("row", "column")}
_NUMBERED = {"trio": ("group", 3), "couple": ("group", 2), "quartet": ("group", 4)}
_MULTIPLE = {"double": 2, "triple": 3, "quadruple": 4}
_SHAPES = {
    "formation": "group",
    "structure": "tower",
    "arrangement": "group",
    "grouping": "group",
    "configuration": "group",
    "building": "tower",
}
_COMPARATIVES = ("closer", "nearer", "farther", "further", "higher", "lower")


@dataclass
class Said:
    """What the words of a base noun phrase say."""

    types: list[str] = field(default_factory=list)
    colors: list[str] = field(default_factory=list)
    relations: list[str] = field(default_factory=list)
    indices: list[int] = field(default_factory=list)
    numbers: list[int] = field(default_factory=list)
    kinds: tuple[str, ...] = ()
    place: str = ""
    plural: bool = False
    universal: bool = False
    definite: bool = False
    indefinite: bool = False
    only: bool = False
    lone: bool = False
    other: bool = False
    comparative: bool = False
    robot: bool = False
    speaker: bool = False
    unknown: bool = False
    slanted: bool = False
    lying: str = ""
    several: bool = False
    size: int = 0
    its: bool = False
    one: bool = False
    same: bool = False
    pointed: bool = False
    mine: bool = False
    yours: bool = False


def sort_words(phrase: Phrase, opposite: bool) -> Said:
    """Sort the words of a base noun phrase.

    Args:
        phrase: without child phrases.
        opposite: whether the speaker looks at the robot, so that "my left" is the robot's right.

    Raises:
        NotAnnotatable: a word that is not covered, by name.
    """
    said = Said()
    words = [word for word in phrase.words if word.tag != "UH"]
    for place, word in enumerate(words):
        text, head = word.text, place == len(words) - 1
        if _function_word(phrase, said, word, words):
            said.mine |= text == "my"
            said.yours |= text == "your"
            continue
        if text in _LYING and not head:
            said.lying = text
            continue
        if text == "diagonal":
            said.slanted = True
            if head:
                said.kinds = ("column", "row")
            continue
        if size_order(text):
            said.size = size_order(text)
            continue
        if text == "one" and head and len(words) > 1 and not said.numbers:
            said.types.append("block")
            said.one = True
            continue
        if text == "ones" and head:
            said.types.append("block")
            said.plural = said.one = True
            continue
        said.plural |= head and is_plural(word.tag)
        if text in PLACE_NOUNS and (head or words[place + 1].text in ("block", "cube", "box", "brick", "piece", "one")):
            if head:
                said.place = text
            continue
        if text in _COMPARATIVES and word.tag == "JJR":
            said.comparative = True
        _sort_symbols(phrase, said, word, head)
    if said.mine and opposite:
        said.relations = [OPPOSITE.get(name, name) for name in said.relations]
    return said


def _function_word(phrase: Phrase, said: Said, word: Word, words: Sequence[Word]) -> bool:
    text = word.text
    if text == "one" and len(words) > 1 and words[0] is word and words[-1].tag == "NN":
        said.indefinite = True  # "one red block"
        return True
    if text in LONE:
        said.lone = True
        return True
    if text in OTHER:
        said.other = said.indefinite = True
        return True
    if text == "its":
        said.its = said.definite = True
        return True
    if not (is_universal(text) or word.tag in ("DT", "PDT", "PRP$") or text == "most" or text in IGNORED):
        return False
    if text == "and" and sum(any(isinstance(s, ObjectColor) for s in meanings(w.text)) for w in words) == 2:
        return True
    if text in ("their", "no", "half"):
        raise NotAnnotatable(f"NP {phrase.text!r}: {text!r} is not covered")
    if text in ("a", "an") and any(Cardinal in map(type, meanings(w.text)) for w in words):
        return True
    said.same |= text == "same"
    said.pointed |= text in ("that", "this", "same")
    said.universal |= is_universal(text)
    said.indefinite |= text in INDEFINITE
    said.definite |= text in ("the", "that", "this", "these", "those", "your", "my") or is_universal(text)
    said.only |= text == "only"
    if text == "everything":
        said.plural = True
    elif text == "both":
        said.numbers.append(2)
    return True


def _sort_symbols(phrase: Phrase, said: Said, word: Word, head: bool) -> None:
    text = word.text
    symbols = meanings(text)
    if text in ("me", "myself", "speaker"):
        said.speaker = True
        return
    if text in ("yourself", "you"):
        said.robot = True
        return
    if text in BLOCKS and head:
        said.types.append("block")
        return
    if text in TABLES:
        if head:
            said.types.append("table")
        return
    if text in _NUMBERED:
        kind, number = _NUMBERED[text]
        said.kinds = (kind,)
        said.numbers.append(number)
        return
    if text in _MULTIPLE and not head:
        said.numbers.append(_MULTIPLE[text])
        return
    if text in _SHAPES:
        said.kinds = (_SHAPES[text],)
        return
    kinds = sorted(s.kind for s in symbols if isinstance(s, Container))
    if kinds == ["robot"]:
        said.robot = True
        return
    if kinds:
        said.several = is_plural(word.tag)
        said.kinds = tuple(kinds)
        said.numbers += [s.value for s in symbols if isinstance(s, Cardinal)]
        return
    named = directions(text)
    if named:
        said.relations += named
        return
    for symbol in symbols:
        match symbol:
            case ObjectType(name):
                said.types.append(name)
                return
            case ObjectColor(name):
                said.colors.append(name)
                return
            case Ordinal(value):
                said.indices.append(value)
                return
            case Cardinal(value):
                said.numbers.append(value)
                return
    if word.tag in ("NN", "NNS") and not symbols and text in UNKNOWN_NOUNS:
        said.unknown = True
        return
    raise NotAnnotatable(f"NP {phrase.text!r}: {text!r} is not covered")


def is_measure(phrase: Phrase) -> bool:
    """Whether a base noun phrase is a distance: "two spaces", "half a block", "a bit"."""
    words = [word for word in phrase.words if word.tag != "UH"]
    texts = [word.text for word in words]
    counted = words[0].tag in ("CD", "PDT") or texts[0] in ("a", "an", "another", *MEASURING) or _is_decimal(texts[0])
    if not counted or texts[0] == "the":
        return False
    if texts[-1] in ("bit", "little", "tad") or any(map(_is_decimal, texts)):
        return True
    named = any(isinstance(s, ObjectColor | SpatialReference) for text in texts for s in meanings(text))
    if named:
        return False
    return texts[-1] in LENGTHS or any(text in MEASURING for text in texts)


def _is_decimal(text: str) -> bool:
    return "." in text and text.replace(".", "").isdecimal()


def labels(said: Said) -> set[Symbol]:
    """The concrete symbols that the words name."""
    symbols: set[Symbol] = {ObjectType(name) for name in said.types}
    symbols |= {ObjectColor(name) for name in said.colors}
    symbols |= {SpatialReference(name) for name in said.relations}
    symbols |= {Ordinal(value) for value in said.indices}
    symbols |= {Cardinal(value) for value in said.numbers}
    return symbols


def lying_kinds(said: Said) -> tuple[str, ...]:
    """The kinds of arrangement that the words allow: a horizontal line is a row."""
    return tuple(kind for kind in said.kinds if kind in _LYING[said.lying]) if said.lying else said.kinds
