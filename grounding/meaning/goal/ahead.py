"""A look ahead in the pieces of a destination, for words whose meaning depends on what follows them."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.lexicon import whereto as g
from grounding.lexicon import words as w
from grounding.meaning.goal.items import Item

_LOOK_AHEAD = 7  # pieces


def direction_follows(items: Sequence[Item], place: int) -> bool:
    """Tells whether a direction follows a number, before anything else that it could belong to."""
    for item in items[place + 1 : place + 1 + _LOOK_AHEAD]:
        if item.kind not in ("word", "length") or item.text in ("and", "then"):
            return False
        if w.directions(item.text) or g.leads(item.text):
            return True
    return False


def top_of_thing(items: Sequence[Item], place: int) -> bool:
    """Tells whether "top" is the top of something: "the top of the stack", not "to the top of the table"."""
    following = items[place + 1 : place + 3]
    return len(following) > 1 and following[0].text == "of" and following[1].kind in ("thing", "pronoun", "counted")


def thing_follows(items: Sequence[Item], place: int) -> bool:
    """Tells whether the next piece names things."""
    return place + 1 < len(items) and items[place + 1].kind in ("thing", "counted")


def side_follows(items: Sequence[Item], place: int) -> bool:
    """Tells whether "on" leads to a side: "on the left of X"."""
    for item in items[place + 1 : place + 5]:
        if item.kind in ("thing", "counted", "pronoun"):
            return False
        if item.kind == "place" or (w.directions(item.text) and item.text != "top"):
            return True
    return False


def face_follows(items: Sequence[Item], place: int) -> bool:
    """Tells whether a direction names a face: "left side", "upper right corner"."""
    following = [item.text for item in items[place + 1 : place + 3]]
    if following[:1] and g.is_face(following[0]):
        return True
    return len(following) > 1 and bool(w.directions(following[0])) and g.is_face(following[1])


def reference_follows(items: Sequence[Item], place: int) -> bool:
    """Tells whether the next word is "of" or "from"."""
    return [item.text for item in items[place + 1 : place + 2]] in (["of"], ["from"])


def ends_in_place(items: Sequence[Item], place: int) -> bool:
    """Tells whether a direction ends what it belongs to: nothing tells of what it is a side, or how far it goes."""
    for item in items[place + 1 : place + 4]:
        if item.text in ("of", "from") or item.kind in ("number", "length", "counted"):
            return False
        if item.kind != "word" or not (w.directions(item.text) or g.is_face(item.text) or item.text == "hand"):
            break
    return True
