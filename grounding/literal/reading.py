"""What reading a phrase literally needs of its surroundings: the scene, and the reader of phrases within."""

from __future__ import annotations

from typing import Protocol

from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase
from grounding.literal.values import Effect, Meant
from grounding.meaning.nouns import Noun
from grounding.world.scene import Scene


class ReadsLiterally(Protocol):
    """A literal reader of noun phrases, given to those that read their parts; see `LiteralReader`."""

    scene: Scene
    layout: Layout
    history: tuple[int, ...]
    vague: bool

    def mean(self, phrase: Phrase) -> Meant:
        """What a noun phrase means."""

    def meant(self, noun: Noun, base: int | None = None) -> Meant:
        """What a noun means."""

    def modify(self, phrase: Phrase, noun: Noun, pool: int) -> list[Effect]:
        """What a modifier does to the things of a noun."""

    def person(self, agent: str | None) -> str:
        """Who is meant: "robot" or "speaker"."""
