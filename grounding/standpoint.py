"""The speaker's side, where nobody told where the speaker is."""

from __future__ import annotations

from grounding.language.tree import Phrase
from grounding.world import World

_ONESELF = frozenset("me my myself mine".split())
_GIVING = frozenset("give hand bring pass fetch get".split())
UNKNOWN = "where you are is not known: your side was taken for the robot's"


def unknown_side(tree: Phrase, world: World) -> str:
    """What people should know who speak of their own side where nobody told where they are; "" where they do not.

    Args:
        tree: the parse.
        world: with or without a speaker.
    """
    if world.speaker is not None:
        return ""
    giving = any(leaf.text in _GIVING for leaf in tree.leaves)
    places = (phrase for phrase in tree.preorder() if phrase.tag == "PP")
    return UNKNOWN if any(_speaks_of_oneself(phrase, giving) for phrase in places) else ""


def _speaks_of_oneself(place: Phrase, giving: bool) -> bool:
    """Whether a place is the speaker's: "on my left", "closest to me"; "to me" is whom something is handed to."""
    texts = [leaf.text for leaf in place.leaves]
    return bool(_ONESELF & set(texts)) and not (giving and texts == ["to", "me"])
