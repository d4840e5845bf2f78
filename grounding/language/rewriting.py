"""One spelling for words that are written apart, together or with hyphens: "left most", "top-left", "thats", "nw".

Readers of trees then meet "leftmost", "top left", "that 's" and "northwest" only.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from grounding.language.tokens import Token

_HANDED = frozenset("side edge corner end part half stack tower pile row column block cube box brick one".split())
_JOINED = {
    **{(side, "most"): side + "most" for side in "left right top bottom upper lower front back rear inner".split()},
    **{(way, "most"): way + "most" for way in "northern southern eastern western".split()},
    **{(way, "most"): way + "ernmost" for way in "north south east west".split()},
    **{(one, two): one + two for one in ("north", "south") for two in ("east", "west", "eastern", "western")},
    **{(way, "most"): way for way in "furthest farthest closest nearest topmost bottommost leftmost rightmost".split()},
    ("far", "most"): "farthest",
    ("near", "most"): "nearest",
    ("up", "side"): "upside",
    ("in", "side"): "inside",
}
_SPLIT = {
    "thats": ("that", "'s"),
    "theres": ("there", "'s"),
    "pickup": ("pick", "up"),
    "inbetween": ("in", "between"),
    "infront": ("in", "front"),
    "ontop": ("on", "top"),
    "nextto": ("next", "to"),
    "dont": ("do", "n't"),
    "tothe": ("to", "the"),
    "ofthe": ("of", "the"),
    "inthe": ("in", "the"),
}
_REPAIRED = {("tot", "he"): ("to", "the"), ("int", "he"): ("in", "the"), ("ont", "he"): ("on", "the"),
             ("oft", "he"): ("of", "the"), ("closet", "to"): ("closest", "to"), ("closes", "to"): ("closest", "to"),
              ("att", "he"): ("at", "the")}  # fmt: skip
_READ_AS = {
    "nw": "northwest", "ne": "northeast", "sw": "southwest", "se": "southeast", "righthand": "right-hand",
    "lefthand": "left-hand", "centre": "center", "centres": "centers", "grey": "gray", "colour": "color",
    "coloured": "colored", "farest": "farthest", "furtherest": "furthest", "fartherest": "farthest",
    "centermost": "middle", "middlemost": "middle", "westmost": "westernmost", "eastmost": "easternmost",
    "northmost": "northernmost", "southmost": "southernmost", "til": "until", "till": "until",
    "neither": "not", "nor": "or", "neighbour": "neighbor", "neighbours": "neighbors",
}  # fmt: skip

_BLOCKS = frozenset(
    "block blocks cube cubes box boxes brick bricks one first second third fourth fifth last away".split()
)
_PUT = frozenset("put set place move stack slide push".split())
_SIDES = frozenset("the left right top bottom front back your my you me".split())
_WHERE = frozenset("in on at to next beside behind above below between inside near closest nearest that which".split())
_NEVER_TWICE = frozenset("the a an of to in on at and is be from".split())
_AFTER_IS = frozenset(
    "next on in at by above below behind between the a closest nearest farthest furthest touching not directly just "
    "slightly located sitting adjacent".split()
)
_BEFORE_OWN = frozenset("to on at of from with".split())
_OWNED = frozenset("left right top bottom front back upper lower own side edge immediate".split())
# A word that is another's misspelling between certain neighbours: (words before, word, words after, as read).
_CONFUSED = (
    (_PUT, "in", _WHERE, "it"),
    (_BLOCKS, "form", _SIDES, "from"),
    (frozenset({"the"}), "on", _WHERE, "one"),
    (_BLOCKS, "the", frozenset({"is"}), "that"),
)


def rewrite(tokens: Sequence[Token], is_known: Callable[[str], bool]) -> tuple[Token, ...]:
    """The tokens of a text, joined and split where another spelling is the usual one.

    Args:
        tokens: as the text has them.
        is_known: whether a word is one that the grammar or the lexicon has.

    Returns:
        tokens with their own places in the text; a joined one covers both of its parts.
    """
    apart = [part for token in tokens for part in _parts(token, is_known)]
    apart = [_by_neighbours(apart, index) for index in range(len(apart))]
    written: list[Token] = []
    index = 0
    while index < len(apart):
        token = apart[index]
        after = apart[index + 1] if index + 1 < len(apart) else None
        pair = (token.text, after.text if after else "")
        following = apart[index + 2].text if index + 2 < len(apart) else ""
        if after and pair in _REPAIRED:
            first, second = _REPAIRED[pair]
            written += [replace(token, text=first), replace(after, text=second)]
            index += 2
        elif length := _all_the_way(apart, index):
            way = token
            for part in apart[index + 1 : index + length]:
                way = _join(way, part, "furthest")
            written.append(way)
            index += length
        elif after and pair[0] == pair[1] and pair[0] in _NEVER_TWICE:
            written.append(_join(token, after, token.text))
            index += 2
        elif after and pair == ("it", "'s") and written and written[-1].text in _BEFORE_OWN and following in _OWNED:
            written.append(_join(token, after, "its"))
            index += 2
        elif token.text == "its" and pair[1] in _AFTER_IS:
            written += _cut(token, ("it", "'s"), 0)
            index += 1
        elif after and pair in _JOINED:
            written.append(_join(token, after, _JOINED[pair]))
            index += 2
        elif after and pair[0] in ("left", "right") and pair[1] == "hand" and following in _HANDED:
            written.append(_join(token, after, f"{pair[0]}-hand"))
            index += 2
        else:
            written.append(replace(token, text=_READ_AS[token.text]) if token.text in _READ_AS else token)
            index += 1
    return tuple(written)


def _all_the_way(tokens: Sequence[Token], index: int) -> int:
    """How many tokens "all the way" has where a side follows it: what is all the way on the left is furthest left."""
    texts = [token.text for token in tokens[index : index + 4]]
    for phrase in (["all", "the", "way"], ["all", "of", "the", "way"]):
        following = [token.text for token in tokens[index + len(phrase) : index + len(phrase) + 2]]
        if texts[: len(phrase)] == phrase and following[:1] and following[0] in ("to", "on", "at", "in"):
            return len(phrase)
    return 0


def _by_neighbours(tokens: Sequence[Token], index: int) -> Token:
    """A token as its neighbours tell that it was meant."""
    token = tokens[index]
    for before, word, after, meant in _CONFUSED:
        inside = token.text == word and 0 < index < len(tokens) - 1
        if inside and tokens[index - 1].text in before and tokens[index + 1].text in after:
            return replace(token, text=meant)
    return token


def _join(first: Token, second: Token, text: str) -> Token:
    blank = " " * (second.start - first.end)
    return Token(text, first.original + blank + second.original, first.start, second.end)


def _parts(token: Token, is_known: Callable[[str], bool]) -> tuple[Token, ...]:
    """A token, or the words that it is made of."""
    if token.text in _SPLIT and len(token.original) == len("".join(_SPLIT[token.text]).replace("'", "")):
        return _cut(token, _SPLIT[token.text], 0)
    if "-" not in token.text or is_known(token.text):
        return (token,)
    parts = tuple(token.text.split("-"))
    if len(token.original) != len(token.text) or not all(parts):
        return (token,)
    together = "".join(parts)
    if together in _JOINED.values() or is_known(together):
        return (replace(token, text=together),)
    if all(is_known(part) or part.isdigit() or part in ("most", "hand") for part in parts):
        return _cut(token, parts, 1)
    return (token,)


def _cut(token: Token, parts: Sequence[str], gap: int) -> tuple[Token, ...]:
    cut: list[Token] = []
    start = 0
    for part in parts:
        end = start + len(part.replace("'", ""))
        cut.append(Token(part, token.original[start:end], token.start + start, token.start + end))
        start = end + gap
    return tuple(cut)
