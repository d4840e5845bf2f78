"""Whose directions may be meant where no side is marked, by who is named."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.world.scene import ROBOT, SPEAKER, Scene

_ALONG = frozenset("behind row column line first second third fourth fifth last".split())


def views(tree: Phrase, scene: Scene) -> tuple[tuple[str, str], ...]:
    """The views with which a text may be read, each with what speaks for it, for features; "" where nothing is open."""
    if scene.layout.world.speaker is None:
        return ((ROBOT, ""),)
    texts = [leaf.text for leaf in tree.leaves]
    for place, text in enumerate(texts):
        if w.is_view(text):
            before = texts[max(0, place - 3) : place]
            if "your" in before:
                return ((ROBOT, ""),)
            if "my" in before:
                return ((SPEAKER, ""),)
    if not any(w.directions(text) or text in _ALONG for text in texts):
        return ((ROBOT, ""),)
    named = _named(texts)
    return ((ROBOT, f"robot.{named}"), (SPEAKER, f"speaker.{named}"))


def _named(texts: Sequence[str]) -> str:
    """Who is named: "you" where the robot is spoken to, "me" where only the speaker is, else "nobody"."""
    addressed = any(text in ("you", "your", "yours", "you're") for text in texts)
    persons = {w.agent(text) for text in texts}
    return "you" if addressed and ROBOT in persons else "me" if SPEAKER in persons else "nobody"


