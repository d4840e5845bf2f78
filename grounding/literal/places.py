"""Noun phrases of places, read literally: sides, corners, the middle, and sides of things."""

from __future__ import annotations

from grounding.language.lexicon import meanings
from grounding.literal.reading import ReadsLiterally
from grounding.literal.values import Meant, Unread
from grounding.meaning.nouns import Noun, read_noun
from grounding.symbols import Cardinal
from grounding.world.scene import SPEAKER

PARTS = frozenset("half part section area portion region quadrant zone".split())
NAMES = {"up": "top", "down": "bottom"}
OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front", "near": "far", "far": "near",
            "top": "bottom", "bottom": "top"}  # fmt: skip


_SILENT = frozenset("same most hand way whole entire exact immediate story stories high only".split())


def says_unknown(noun: Noun) -> bool:
    """Whether a noun has words that say nothing here."""
    return any(
        word not in _SILENT and not any(isinstance(s, Cardinal) for s in meanings(word)) for word in noun.unknown
    )


def names_of(noun: Noun) -> tuple[str, ...]:
    """The directions that a noun's own words name; distance and the middle are such as well."""
    names = [NAMES.get(name, name) for name in noun.directions]
    if noun.far and names in ([], ["back"]):
        names = ["far"]
    if noun.distance:
        if noun.distance == "near" and names in ([], ["front"]):
            names = ["near"]
        elif noun.distance == "near":
            names = [*(name for name in names if name != "front"), "front"]
        elif not names:
            names = ["far"]
    if noun.middle:
        names.append("center")
    return tuple(dict.fromkeys(names))


def mean_place(reader: ReadsLiterally, noun: Noun) -> Meant:
    """What a noun of a place means.

    Raises:
        Unread: it is beyond what is read literally.
        Missing: what it is a side of is not there.
    """
    if noun.colors or noun.ordinals or noun.number or says_unknown(noun) or noun.lone or noun.strange:
        raise Unread(noun.text)
    names = list(names_of(noun))
    place = next((word for word in noun.text.split() if word in PARTS), noun.place or "")
    agent = reader.person(noun.agent) if noun.agent else None
    if agent == SPEAKER:
        names = [OPPOSITE.get(name, name) for name in names]
    if not names and agent:
        names = ["far" if agent == SPEAKER else "near"]
    whole: Meant | None = None
    for modifier in noun.modifiers:
        words = [word.text for word in modifier.words]
        of = modifier.tag == "PP" and words in (["of"], ["in"], ["on"], ["to"], ["from"]) and len(modifier.phrases) == 1
        if not of or whole is not None:
            raise Unread(noun.text)
        whole = reader.meant(read_noun(modifier.phrases[0]))
    if not names or len(names) > 2:
        raise Unread(noun.text)
    if whole is not None and whole.sort == "table" and names in (["left"], ["right"], ["front"], ["back"], ["top"],
                                                                ["bottom"], ["center"]):  # fmt: skip
        return Meant("place", names=tuple(names), place=place, parts=(whole,))
    if whole is None or whole.sort == "table":
        return Meant("place", names=tuple(names), place=place, agent=agent)
    if whole.sort == "place":
        if names != ["center"] or len(whole.names) != 1 or whole.parts:
            raise Unread(noun.text)
        return Meant("place", names=(*whole.names, "center"), place="edge")
    if whole.sort == "agent" and whole.agent == SPEAKER:
        names = [OPPOSITE.get(name, name) for name in names]
    return Meant("place", names=tuple(names), place=place, agent=whole.agent, parts=(whole,))
